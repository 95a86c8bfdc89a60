/// Named rotations of the task.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace trocar::spatial {

inline Eigen::Quaterniond about_x(double angle_rad) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitX()));
}
inline Eigen::Quaterniond about_y(double angle_rad) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitY()));
}
inline Eigen::Quaterniond about_z(double angle_rad) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitZ()));
}

}  // namespace trocar::spatial
