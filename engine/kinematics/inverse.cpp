#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/kinematics/chain.h"
#include "engine/kinematics/reach.h"
#include "engine/spatial/units.h"

namespace trocar::kinematics {
namespace {

constexpr double kTurn_rad = 2.0 * std::numbers::pi;
constexpr int kInsertion = 2;

/// An angle in (−π, π].
double wrapped(double angle_rad) {
  if (angle_rad > std::numbers::pi) return angle_rad - kTurn_rad;
  if (angle_rad <= -std::numbers::pi) return angle_rad + kTurn_rad;
  return angle_rad;
}

/// How far a joint is outside of its limits, ≥ 0.
double excess(const JointLimit& limit, double value) {
  return std::max({0.0, limit.low - value, value - limit.high});
}

/// A millimetre of insertion counts like a degree.
double scale_of(int joint) {
  return joint == kInsertion ? spatial::kRadiansPerDegree / spatial::kMetresPerMillimetre : 1.0;
}

/// The worst excess of all joints.
double worst_excess(const PsmModel& model, const Joints& q) {
  double worst = 0.0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    worst = std::max(worst, scale_of(static_cast<int>(i)) * excess(model.limits[i], q[i]));
  }
  return worst;
}

/// What the branches have in common: the wrist-yaw joint and two of its axes, in B.
struct Wrist {
  Eigen::Vector3d p;   ///< Origin of frame 6.
  Eigen::Vector3d x6;  ///< Its x axis.
  Eigen::Vector3d z6;  ///< The wrist-yaw joint's axis.
};

/// One branch: `x5` is the direction from the wrist-pitch to the wrist-yaw joint, `shaft` +1 if the wrist lies ahead of
/// the remote centre and −1 if it lies behind. Nothing if the wrist-pitch joint is at the remote centre.
bool solve_branch(const Wrist& wrist, const Eigen::Vector3d& x5, double shaft, Joints& q) {
  const Eigen::Vector3d c = wrist.p - kWrist_m * x5;
  const double reach = c.norm();
  if (!(reach > 1e-9)) return false;
  const Eigen::Vector3d along = shaft / reach * c;
  const double horizontal = std::hypot(along.x(), along.z());
  const bool tilts = horizontal > 0.0;
  const double sin1 = tilts ? along.x() / horizontal : 0.0;
  const double cos1 = tilts ? -along.z() / horizontal : 1.0;
  const double sin2 = -along.y();
  const double cos2 = horizontal;
  // The first two axes of frame 3 in B, from the sines and cosines just found; its z is `along`.
  const Eigen::Vector3d x3(-sin2 * sin1, -cos2, sin2 * cos1);
  const Eigen::Vector3d y3(-cos1, 0.0, -sin1);
  const Eigen::Vector3d z5 = x5.cross(wrist.z6);
  const double sin4 = -z5.dot(x3);
  const double cos4 = z5.dot(y3);
  const Eigen::Vector3d x4 = (cos4 * x3 + sin4 * y3).normalized();
  q[0] = tilts ? std::atan2(along.x(), -along.z()) : 0.0;
  q[1] = std::atan2(sin2, cos2);
  q[2] = shaft * reach + kInsertionOffset_m;
  q[3] = std::atan2(sin4, cos4);
  const double theta5 = std::atan2(-x5.dot(along), x5.dot(x4));
  const double theta6 = std::atan2(-wrist.x6.dot(z5), wrist.x6.dot(x5));
  q[4] = wrapped(theta5 - kChain[4].theta_rad);
  q[5] = wrapped(theta6 - kChain[5].theta_rad);
  return true;
}

std::string amount(int joint, double value) {
  return joint == kInsertion ? fmt::format("{:.1f} mm", spatial::to_mm(value))
                             : fmt::format("{:.1f}°", spatial::to_degrees(value));
}

}  // namespace

Status check_limits(const PsmModel& model, const Joints& q) {
  for (int joint = 0; joint < kJointCount; ++joint) {
    const auto i = static_cast<std::size_t>(joint);
    if (!std::isfinite(q[i])) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("the {} joint's value is not finite", joint_name(joint)));
    }
    const JointLimit& limit = model.limits[i];
    const double beyond = excess(limit, q[i]);
    if (beyond == 0.0) continue;
    const double bound = q[i] < limit.low ? limit.low : limit.high;
    return fail(ErrorCode::kOutOfReach, fmt::format("the {} joint would be {} beyond its limit of {}",
                                                    joint_name(joint), amount(joint, beyond), amount(joint, bound)));
  }
  return {};
}

namespace {

/// The branch that is the least beyond the limits, the first without any if there is one.
Result<Joints> nearest_branch(const PsmModel& model, const spatial::Pose& X_WT) {
  if (!X_WT.finite()) return fail(ErrorCode::kInvalidArgument, "the tool's pose is not finite");
  if (std::abs(X_WT.q.norm() - 1.0) > 1e-6) {
    return fail(ErrorCode::kInvalidArgument, "the tool's orientation is not a unit quaternion");
  }
  const spatial::Pose X_BT = model.X_WB.inverse() * X_WT;
  const Eigen::Matrix3d R_BT = X_BT.rotation();
  const Wrist wrist{X_BT.p - kTipFromWrist_m * R_BT.col(2), -R_BT.col(1), -R_BT.col(0)};
  const Eigen::Vector3d across = wrist.p - wrist.z6 * wrist.z6.dot(wrist.p);
  const double distance = across.norm();
  if (!(distance > 1e-9)) {
    return fail(ErrorCode::kOutOfReach, "the wrist yaw joint's axis would pass through the remote centre");
  }
  const Eigen::Vector3d u = across / distance;
  Joints best{};
  double least = std::numeric_limits<double>::infinity();
  for (const double side : {1.0, -1.0}) {
    for (const double shaft : {1.0, -1.0}) {
      Joints q{};
      if (!solve_branch(wrist, side * u, shaft, q)) continue;
      const double beyond = worst_excess(model, q);
      if (beyond < least) {
        least = beyond;
        best = q;
      }
      if (beyond == 0.0) return best;
    }
  }
  if (!std::isfinite(least)) {
    return fail(ErrorCode::kOutOfReach, "the wrist pitch joint would be at the remote centre");
  }
  return best;
}

}  // namespace

Result<Joints> inverse(const PsmModel& model, const spatial::Pose& X_WT) {
  TROCAR_ASSIGN_OR_RETURN(const Joints best, nearest_branch(model, X_WT));
  return check_limits(model, best).map([&] { return best; });
}

Result<Excess> excess_at(const PsmModel& model, const spatial::Pose& X_WT) {
  TROCAR_ASSIGN_OR_RETURN(const Joints q, nearest_branch(model, X_WT));
  Excess worst;
  double most = 0.0;
  for (int joint = 0; joint < kJointCount; ++joint) {
    const auto i = static_cast<std::size_t>(joint);
    const JointLimit& limit = model.limits[i];
    const double beyond = excess(limit, q[i]);
    const double weight = scale_of(joint) * beyond;
    if (weight <= most) continue;
    most = weight;
    worst = {joint, beyond, q[i] < limit.low ? limit.low : limit.high};
  }
  return worst;
}

}  // namespace trocar::kinematics
