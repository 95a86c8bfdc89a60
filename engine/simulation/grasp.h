/// How to take a block: the tool's poses at its three walls.
#pragma once

#include <array>

#include "engine/kinematics/psm.h"
#include "engine/spatial/pose.h"

namespace trocar::simulation {

/// Full opening of the jaws, in radians, to come down over a wall: wider, and the inner jaw meets the block's own peg.
constexpr double kApproachOpening_rad = 20.0 * 3.14159265358979323846 / 180.0;
/// Command to hold with the servo's whole force; below the opening at which the jaws touch the wall.
constexpr double kGripCommand_rad = -10.0 * 3.14159265358979323846 / 180.0;
/// The jaws' tips stand this far above the block's centre when they grip, in metres.
constexpr double kGraspAboveCentre_m = 0.003;

/// X_WT to grip `wall` of the block at X_WK: 5 mm from its axis, jaws along −z_K, one inside of the hole. Of the two
/// turns half a revolution apart the one whose hinge points more along +x_W. Precondition: 0 ≤ wall < 3.
spatial::Pose grasp_pose(const spatial::Pose& X_WK, int wall);

/// The three walls, best first, for an arm that comes from its side of the board: the wall that faces the arm's base
/// most. With a block turned by −30° … 30° the left arm's first wall is 2 and the right arm's 0, so that both can hold
/// one block; their hinges then point within 60° of +x_W, which both arms reach everywhere above the board.
std::array<int, 3> walls_by_preference(kinematics::ArmSide side, const spatial::Pose& X_WK);

}  // namespace trocar::simulation
