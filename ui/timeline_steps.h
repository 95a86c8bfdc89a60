/// Where the playhead goes when it is stepped.
#pragma once

#include "engine/demonstration/demonstration.h"

namespace trocar::ui {

/// `steps` samples on from the sample at `t_s` (negative: back), kept within the gates.
double stepped(const demonstration::Demonstration& demonstration, double t_s, int steps);

/// The speed after J (−1) or L (1): the other way or at rest it plays at once; else twice as fast, up to 32.
double shuttled(double speed, int direction);

}  // namespace trocar::ui
