#include "engine/simulation/shapes.h"

#include "engine/spatial/rotation.h"
#include "engine/spatial/units.h"

namespace trocar::simulation {

using namespace peg_board;
using kinematics::kTipFromWrist_m;

spatial::Pose jaw_pose(std::size_t jaw, double angle_rad) {
  const double side = jaw == 0 ? 1.0 : -1.0;
  const Eigen::Quaterniond turn = spatial::about_x(-side * angle_rad);
  return {turn * Eigen::Vector3d(0.0, side * kJawThickness_m / 2.0, kTipFromWrist_m / 2.0), turn};
}

std::array<BlockBox, kBoxesPerBlock> block_boxes() {
  constexpr double kWallLength_m = 0.0148;
  constexpr double kCornerDepth_m = 0.00284;
  constexpr double kCornerWidth_m = 0.0034;
  std::array<BlockBox, kBoxesPerBlock> boxes;
  for (int i = 0; i < kWallCount; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double wall = wall_angle(i);
    boxes[k] = {wall, kHoleApothem_m + kWallThickness_m / 2.0, kWallThickness_m, kWallLength_m};
    boxes[k + kWallCount] = {wall + spatial::from_degrees(60.0), kHoleApothem_m + kCornerDepth_m / 2.0, kCornerDepth_m,
                             kCornerWidth_m};
  }
  return boxes;
}

}  // namespace trocar::simulation
