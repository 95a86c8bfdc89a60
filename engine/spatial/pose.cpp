#include "engine/spatial/pose.h"

#include <algorithm>
#include <cmath>

namespace trocar::spatial {

Eigen::Matrix4d Pose::matrix() const {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = rotation();
  m.topRightCorner<3, 1>() = p;
  return m;
}

Pose interpolate(const Pose& a, const Pose& b, double s) {
  return {a.p + s * (b.p - a.p), a.q.slerp(s, b.q)};
}

double angle_between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Eigen::Quaterniond d = a.conjugate() * b;
  return 2.0 * std::atan2(d.vec().norm(), std::abs(d.w()));
}

}  // namespace trocar::spatial
