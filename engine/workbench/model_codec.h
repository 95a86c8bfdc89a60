/// How a model is stored: its numbers a person may want to read as JSON, its arrays as bytes.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

/// The kind of object in the store.
constexpr const char* kModelKind = "model";

struct EncodedModel {
  std::string meta;   ///< JSON: name, provenance, options, lattice.
  std::string bytes;  ///< Each array as a 64-bit count and its numbers, little-endian.
};

/// Precondition: `entry.model` is not null.
EncodedModel encode_model(const ModelEntry& entry);
/// An entry without id. Errors: kCorrupt naming what does not fit.
Result<ModelEntry> decode_model(std::string_view meta, std::string_view bytes);

}  // namespace trocar::workbench
