/// The shapes that collide in the simulated world, as numbers: jaws, wrist, shaft, and the six boxes of a block.
#pragma once

#include <array>

#include "engine/kinematics/psm.h"
#include "engine/peg_board/peg_board.h"

namespace trocar::simulation {

// A jaw is a box from the wrist-yaw joint to the tip, `kinematics::kTipFromWrist_m` long. Wrist and shaft are capsules
// about the lines from wrist yaw to wrist pitch and from there to the remote centre.
constexpr double kJawThickness_m = 0.0014;  ///< Along y_T, in which the jaws open.
constexpr double kJawWidth_m = 0.0018;      ///< Along the hinge.
constexpr double kWristRadius_m = 0.0025;
constexpr double kShaftRadius_m = 0.0040;

/// X_YJ from the wrist-yaw joint, axes as T, to the middle of a jaw that is opened by `angle_rad`; axes along width,
/// thickness and length. Jaw 0 lies at +y_T, jaw 1 at −y_T.
spatial::Pose jaw_pose(std::size_t jaw, double angle_rad);

constexpr int kBoxesPerBlock = 6;
/// No point of a block is farther from its centre than this, in metres.
constexpr double kBlockRadius_m = 0.0126;

/// One box of a block, as high as the block: `depth_m` along the direction `angle_rad` about z_K, in which its middle
/// is `distance_m` from the block's axis, and `width_m` across.
struct BlockBox {
  double angle_rad = 0.0;
  double distance_m = 0.0;
  double depth_m = 0.0;
  double width_m = 0.0;
};
/// Walls 0–2, then the corners beside them.
std::array<BlockBox, kBoxesPerBlock> block_boxes();

}  // namespace trocar::simulation
