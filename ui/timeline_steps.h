/// Where the playhead goes when it is stepped.
#pragma once

#include "engine/demonstration/demonstration.h"

namespace trocar::ui {

/// `steps` samples on from the sample at `t_s` (negative: back), kept within the gates.
double stepped(const demonstration::Demonstration& demonstration, double t_s, int steps);

/// The next beginning or end of a segment after `t_s` (`direction` 1) or before it (−1); else the gate.
double next_boundary(const demonstration::Demonstration& demonstration, double t_s, int direction);

}  // namespace trocar::ui
