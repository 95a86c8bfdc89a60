/// Writes a field of a model as a figure or as numbers, by the extension of the file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "engine/figure/field_figure.h"
#include "engine/learning/field.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

struct FieldExport {
  std::shared_ptr<const ModelEntry> model;
  learning::Layer layer = learning::Layer::kReward;
  std::string slice;  ///< "z=11"; empty: a montage of all slices.
  std::filesystem::path path;
};

/// What suits the layer, with the marks of the model and a subtitle that says whose field it is: "A exact · segment A ·
/// exact". Precondition: the entry's model is there.
figure::FieldFigureOptions figure_options(const ModelEntry& entry, const learning::Field& field);

/// Threads: any. Errors: kInvalidArgument (slice, extension), kIo.
Status export_field(const FieldExport& request);

}  // namespace trocar::workbench
