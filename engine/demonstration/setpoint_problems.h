/// Setpoints that no arm can follow, and tools where no arm can be; mostly of files that other programs wrote.
#pragma once

#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/problems.h"

namespace trocar::demonstration {

/// Adds what is out of the workspace or beyond the jaws' limits, and what leaps or goes faster than `bounds` allow.
/// Precondition: all numbers are finite.
void add_setpoint_problems(const Demonstration& document, const MotionBounds& bounds, std::vector<Problem>& found);

}  // namespace trocar::demonstration
