/// What a model would do, drawn in the cells of a slice.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace trocar::stage {

/// An arrow for the greedy action; or six arms, the longer the larger Q is among the six of the cell.
enum class Glyphs : std::uint8_t { kNone, kBest, kStars };
std::string_view to_string(Glyphs glyphs);
/// Errors: kInvalidArgument with the names that there are.
Result<Glyphs> glyphs_from(std::string_view text);
/// In the order of the menus.
const std::vector<Glyphs>& all_glyphs();

}  // namespace trocar::stage
