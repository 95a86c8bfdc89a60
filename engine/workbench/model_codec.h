/// How a model is stored: where it came from as JSON, the model itself as the bytes of `learning::encode_model`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

/// The kind of object in the store.
constexpr const char* kModelKind = "model";

struct EncodedModel {
  std::string meta;   ///< JSON: name, segment, demonstrations with their hashes, and a summary for human readers.
  std::string bytes;  ///< `learning::encode_model`.
};

/// Preconditions: `entry.model` is not null, and each demonstration has its hash.
EncodedModel encode_model(const ModelEntry& entry);
/// An entry without id. Errors: kUnsupported for another layout; kCorrupt naming what does not fit.
Result<ModelEntry> decode_model(std::string_view meta, std::string_view bytes);
/// The same without the model itself, but with its hash; `size_bytes` is how long its bytes are. No value if only the
/// bytes can tell (they were written before descriptions had what it takes). Errors: as `decode_model`.
Result<std::optional<ModelEntry>> describe_model(std::string_view meta, std::int64_t size_bytes);

}  // namespace trocar::workbench
