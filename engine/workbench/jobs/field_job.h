/// Writes a field of a model as a figure or as numbers, by the extension of the file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "engine/figure/field_figure.h"
#include "engine/learning/field.h"
#include "engine/workbench/field_settings.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

struct FieldExport {
  std::shared_ptr<const ModelEntry> model;
  learning::Layer layer = learning::Layer::kReward;
  learning::FieldMask mask = learning::FieldMask::kNone;
  std::shared_ptr<const ModelEntry> against;  ///< B, if what B changes against `model` is written and not the field …
  FieldContrast contrast = FieldContrast::kDifference;      ///< … and which of it.
  std::string slice;                                        ///< "z=11"; empty: a montage of all slices.
  int slab = 1;                                             ///< Cells that the slice is thick …
  learning::Through through = learning::Through::kLargest;  ///< … and what is written of them.
  FieldFileLook look;
  std::filesystem::path path;
};

/// What suits the layer, with the marks of the model and a subtitle that says whose field it is: "A exact · segment A ·
/// exact". Precondition: the entry's model is there.
figure::FieldFigureOptions figure_options(const ModelEntry& entry, const learning::Field& field);

/// .png, .svg or .pdf draws; .csv, .npy, .vti or .h5 holds the numbers, of the slice in a .csv or .npy. A picture says
/// how many pixels an inch has where the look has a preset or a resolution. Returns what was written.
/// Threads: any. Errors: kInvalidArgument (slice, extension, preset, models of different lattices), kUnsupported, kIo.
Result<learning::Field> export_field(const FieldExport& request);
/// Any field as such a file, without a model; a picture of `options`. Errors: likewise.
Status write_field(const learning::Field& field, const figure::FieldFigureOptions& options,
                   const std::filesystem::path& path);
/// Whether such a file is drawn, and so has a look.
bool is_drawn(const std::filesystem::path& path);

}  // namespace trocar::workbench
