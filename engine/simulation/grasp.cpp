#include "engine/simulation/grasp.h"

#include <algorithm>

#include "engine/peg_board/peg_board.h"
#include "engine/spatial/rotation.h"
#include "engine/spatial/units.h"

namespace trocar::simulation {
namespace {

Eigen::Vector3d wall_normal(int wall) {
  return spatial::about_z(peg_board::wall_angle(wall)) * Eigen::Vector3d::UnitX();
}

}  // namespace

spatial::Pose grasp_pose(const spatial::Pose& X_WK, int wall) {
  const Eigen::Vector3d p_KT =
      peg_board::kWallMid_m * wall_normal(wall) + Eigen::Vector3d(0.0, 0.0, kGraspAboveCentre_m);
  // Straight down in K, the hinge along the wall: y_T is then the wall's normal or its opposite.
  const Eigen::Quaterniond R_KT =
      spatial::about_z(peg_board::wall_angle(wall) + spatial::from_degrees(90.0)) * Eigen::Quaterniond(0, 1, 0, 0);
  spatial::Pose X_WT{X_WK * p_KT, (X_WK.q * R_KT).normalized()};
  if ((X_WT.q * Eigen::Vector3d::UnitX()).x() < 0.0) X_WT.q = X_WT.q * Eigen::Quaterniond(0, 0, 0, 1);
  return X_WT;
}

std::array<int, 3> walls_by_preference(kinematics::ArmSide side, const spatial::Pose& X_WK) {
  const double towards_base = side == kinematics::ArmSide::kLeft ? -1.0 : 1.0;
  std::array<int, 3> walls{0, 1, 2};
  std::stable_sort(walls.begin(), walls.end(), [&](int a, int b) {
    return towards_base * (X_WK.q * wall_normal(a)).y() > towards_base * (X_WK.q * wall_normal(b)).y();
  });
  return walls;
}

}  // namespace trocar::simulation
