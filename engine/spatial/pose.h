/// A rigid pose: where a frame's origin is, and how it is turned.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace trocar::spatial {

/// X_AB: the pose of frame B in frame A. Equal letters meet: `X_AC = X_AB * X_BC`.
struct Pose {
  Eigen::Vector3d p{0.0, 0.0, 0.0};          ///< p_AB: Bo from Ao, in A, in metres.
  Eigen::Quaterniond q{1.0, 0.0, 0.0, 0.0};  ///< R_AB as a unit quaternion.

  static Pose translation(const Eigen::Vector3d& p_AB) { return {p_AB, Eigen::Quaterniond::Identity()}; }

  Pose operator*(const Pose& other) const { return {p + q * other.p, (q * other.q).normalized()}; }
  /// p_AQ from p_BQ.
  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return p + q * point; }
  Pose inverse() const { return {q.conjugate() * -p, q.conjugate()}; }
  Eigen::Matrix3d rotation() const { return q.toRotationMatrix(); }
  Eigen::Matrix4d matrix() const;
  bool finite() const { return p.allFinite() && q.coeffs().allFinite(); }
  /// Equal to the bit.
  bool operator==(const Pose& other) const { return p == other.p && q.coeffs() == other.q.coeffs(); }
};

/// Straight in position, great circle (shorter way) in rotation; `s` from 0 (a) to 1 (b).
Pose interpolate(const Pose& a, const Pose& b, double s);

/// The angle between two rotations, in radians, 0 … π.
double angle_between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

}  // namespace trocar::spatial
