/// Lines in the 3-D view from where the tools are to where they are in what is compared.
#pragma once

#include <vector>

#include "engine/demonstration/comparison.h"
#include "engine/stage/stage.h"

namespace trocar::workbench {

/// What deviates by less has no whisker.
constexpr double kLeastWhisker_m = 5e-5;

/// Up to 60 for each arm, evenly along the matches that deviate: bright, thick and long where they deviate much.
void add_whiskers(const demonstration::Comparison& comparison, std::vector<stage::PathLayer>& paths);

/// The colour of a deviation, 0 … 1 of the largest.
Rgba whisker_colour(double share);

}  // namespace trocar::workbench
