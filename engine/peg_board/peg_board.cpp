#include "engine/peg_board/peg_board.h"

#include "engine/core/check.h"
#include "engine/spatial/units.h"

namespace trocar::peg_board {

double wall_angle(int wall) {
  TROCAR_CHECK(wall >= 0 && wall < kWallCount);
  return spatial::from_degrees(60.0 + 120.0 * wall);
}

Eigen::Vector3d start_peg(int block) {
  TROCAR_CHECK(block >= 0 && block < kBlockCount);
  // A hexagon of radius 23 mm about (−10, −27) mm.
  static const std::array<Eigen::Vector3d, 6> kPegs{
      Eigen::Vector3d(-0.033, -0.027, 0.0),     Eigen::Vector3d(0.013, -0.027, 0.0),
      Eigen::Vector3d(-0.0215, -0.007081, 0.0), Eigen::Vector3d(0.0015, -0.007081, 0.0),
      Eigen::Vector3d(-0.0215, -0.046919, 0.0), Eigen::Vector3d(0.0015, -0.046919, 0.0)};
  return kPegs[static_cast<std::size_t>(block)];
}

Eigen::Vector3d goal_peg(int goal) {
  TROCAR_CHECK(goal >= 0 && goal < kBlockCount);
  const double x_m = -0.030 + 0.020 * (goal % 3);
  return {x_m, goal < 3 ? 0.043 : 0.013, 0.0};
}

spatial::Box wrist_workspace(bool left) {
  constexpr double kSlack_m = 0.004;
  const double y_low = left ? -0.050 : 0.0;
  return {{-0.050 - kSlack_m, y_low - kSlack_m, -0.0009}, {0.050 + kSlack_m, y_low + 0.050 + kSlack_m, 0.0581}};
}

PaperCamera paper_camera() {
  return {{0.1015, 0.0, 0.0829}, spatial::from_degrees(-30.0), spatial::from_degrees(45.0)};
}

}  // namespace trocar::peg_board
