/// Grippers that close on nothing, and blocks that change hands without a moment in which both arms hold them.
#pragma once

#include <vector>

#include "engine/demonstration/problems.h"

namespace trocar::demonstration {

/// Appends to `found`. Precondition: all samples are finite.
void add_jaw_problems(const Demonstration& document, std::vector<Problem>& found);

}  // namespace trocar::demonstration
