/// How the command line says what of a model's field is drawn in the scene: as in the panel Fields.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/workbench/project.h"
#include "engine/workbench/studio.h"

namespace trocar::app {

struct FieldArguments {
  std::string layer = "value";
  std::string mask = "none";
  std::string scale;
  std::string map;
  std::string vision = "full";
  std::optional<double> voxels;
  std::optional<double> iso;
  bool volume = false;
  std::string opacity_curve;  ///< Empty: fitted to the field.
  std::string glyphs = "none";
  std::string streamlines;
  bool no_slices = false;
  std::vector<std::string> slices;
  std::vector<double> limits;
  std::vector<int> slabs;
  std::string through = "largest";
  float opacity = 0.8F;
};

/// One option for each of them; all need `model`.
void bind_field(CLI::App& verb, FieldArguments& arguments, CLI::Option* model);

/// Slices go through the model's goal if none is said. Errors: kInvalidArgument naming the option at fault.
Result<workbench::FieldSettings> settings_from(const FieldArguments& arguments, const learning::Model& model);

/// The field as it is drawn. Errors: kInvalidArgument for a surface or a volume of classes.
Result<stage::FieldLayer> drawn_layer(const workbench::ModelEntry& entry, const workbench::FieldSettings& settings);

/// Errors: those of `settings_from` and `drawn_layer`; kInvalidArgument for starts that the model cannot have.
Result<stage::FieldLayer> layer_of(const workbench::ModelEntry& entry, const FieldArguments& arguments);

/// One --also: LAYER and, after commas, what is unlike the defaults. Errors: kInvalidArgument naming the word at fault.
Result<workbench::FieldSettings> also_from(const std::string& text);

}  // namespace trocar::app
