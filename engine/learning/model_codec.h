/// A model as bytes, for the project file: what `encode_model` wrote comes back equal bit for bit.
#pragma once

#include <string>
#include <string_view>

#include "engine/learning/model.h"

namespace trocar::learning {

/// Raised when the layout or the methods change; older versions stay readable. Models that were trained here are of 1.
constexpr std::uint32_t kModelFormat = 2;

/// Little-endian: "TRCMODEL", format, length of the rest, options, grid, experts, then the safe set and
/// the arrays, and last the model's
/// hash. Numbers that repeat in a row (most of an `eg-maxent` model) are written once with their count.
std::string encode_model(const Model& model);

/// Errors: kCorrupt (truncated, foreign, inconsistent, or its hash does not fit); kUnsupported (a newer format).
/// Never reads beyond `bytes` nor allocates more than a lattice of 192 cells a side needs.
Result<Model> decode_model(std::string_view bytes);

}  // namespace trocar::learning
