/// Writes a field of a model as a figure or as numbers, by the extension of the file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "engine/learning/field.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

struct FieldExport {
  std::shared_ptr<const ModelEntry> model;
  learning::Layer layer = learning::Layer::kReward;
  std::string slice;  ///< "z=11"; empty: a montage of all slices.
  std::filesystem::path path;
};

/// Threads: any. Errors: kInvalidArgument (slice, extension), kIo.
Status export_field(const FieldExport& request);

}  // namespace trocar::workbench
