/// What is odd about a recording that came from elsewhere, said and not mended.
#pragma once

#include <string>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/spatial/grid.h"

namespace trocar::exchange {

/// One sentence each, the sample rate first: uneven times, gaps as the checks count them, stretches in which nothing
/// moves, quaternions that change sign from one sample to the next, jumps, motion outside of the learning lattice.
/// Precondition: at least 2 samples.
std::vector<std::string> findings(const demonstration::Demonstration& document, const spatial::Grid& grid);

}  // namespace trocar::exchange
