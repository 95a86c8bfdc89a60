/// Which joint keeps an arm from a pose, and by how much; `inverse` for who counts instead of refusing.
#pragma once

#include "engine/kinematics/psm.h"

namespace trocar::kinematics {

/// How far the worst joint is beyond its limit.
struct Excess {
  int joint = -1;       ///< 0 … 5; −1: all joints are inside.
  double beyond = 0.0;  ///< Radians; metres for the insertion.
  double limit = 0.0;   ///< The limit that it is beyond, in the same unit.
};

/// For the branch of the solution that is the least beyond. A millimetre of insertion counts like a degree.
/// Errors: kInvalidArgument if the pose is not finite or not of unit length; kOutOfReach where no joints exist at all.
Result<Excess> excess_at(const PsmModel& model, const spatial::Pose& X_WT);

}  // namespace trocar::kinematics
