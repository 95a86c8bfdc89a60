/// How a picture looks to a colour-blind reader, or printed in grey.
#pragma once

#include <string_view>
#include <vector>

#include "engine/core/image.h"
#include "engine/core/result.h"

namespace trocar::plot {

/// Without the long-, middle- or short-wave cones (Machado, Oliveira and Fernandes 2009, severity 1), or lightness
/// only.
enum class ColourVision { kFull, kProtan, kDeutan, kTritan, kGrey };
std::string_view to_string(ColourVision vision);
/// Errors: kInvalidArgument with the names that there are.
Result<ColourVision> colour_vision_from(std::string_view text);
/// In the order of the menus.
const std::vector<ColourVision>& all_colour_visions();

/// What `colour` (sRGB) looks like; alpha is kept.
Rgba seen_with(ColourVision vision, Rgba colour);

}  // namespace trocar::plot
