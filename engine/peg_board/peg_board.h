/// The scene's numbers (SurRoL's peg-transfer scene, re-modelled): board, pegs, blocks, workspaces and camera.
#pragma once

#include <Eigen/Core>
#include <array>

#include "engine/spatial/box.h"
#include "engine/spatial/pose.h"

namespace trocar::peg_board {

// All lengths in metres, in the board frame W: origin at the centre of the board's top face, x towards the viewer,
// y to the image's right, z up.
constexpr int kBlockCount = 6;
constexpr int kPegCount = 12;

constexpr double kBoardX_m = 0.103;
constexpr double kBoardY_m = 0.154;
constexpr double kBoardZ_m = 0.022;
constexpr double kTableZ_m = -0.0211;  ///< z of the table's plane.

constexpr double kPegRadius_m = 0.0015;
constexpr double kPegHeight_m = 0.026;

constexpr double kBlockCircumradius_m = 0.010;
constexpr double kBlockHeight_m = 0.0145;
constexpr double kHoleApothem_m = 0.004157;
constexpr double kWallThickness_m = 0.000843;  ///< At the middle of a side.
constexpr double kWallMid_m = 0.005;           ///< From the block's axis to the middle of a mid-side wall (about).
constexpr double kBlockMass_kg = 0.002;
constexpr double kBlockRest_m = 0.00725;  ///< z of a block's centre at rest on the board.

// Frame K of a block: origin at its centre, z along the hole (up at rest), +x towards the middle of a chamfered corner.
// The corners look along 0°, 120° and 240° about z, the walls (mid-sides) along 60°, 180° and 300°.
constexpr int kWallCount = 3;
/// The angle about z_K of the outward normal of a wall, in radians. Precondition: 0 ≤ wall < 3.
double wall_angle(int wall);

/// p_WP of the foot of a peg. Pegs 0–5 are the start pegs (the user's), 6–11 the goal pegs (the assistant's).
Eigen::Vector3d start_peg(int block);  ///< Precondition: 0 ≤ block < 6.
Eigen::Vector3d goal_peg(int goal);    ///< Precondition: 0 ≤ goal < 6.

/// Where the wrist (not the tip) of an arm may be; the left arm's y is −50 … 0 mm, the right one's 0 … 50 mm.
spatial::Box wrist_workspace(bool left);

/// The hand-off point of segment C, near which the assistant takes the block.
inline const Eigen::Vector3d kHandOff_m{-0.010, 0.0, 0.045};

/// The paper's view: eye at (101.5, 0, 82.9) mm, pitched 30° down towards −x, vertical field of view 45°.
struct PaperCamera {
  Eigen::Vector3d eye{0.1015, 0.0, 0.0829};
  double pitch_rad;
  double vertical_fov_rad;
};
PaperCamera paper_camera();

}  // namespace trocar::peg_board
