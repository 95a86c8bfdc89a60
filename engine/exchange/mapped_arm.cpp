#include "engine/exchange/mapped_arm.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "engine/spatial/units.h"

#include "engine/exchange/plausible.h"

namespace trocar::exchange {
namespace {

constexpr double kFarthest_rad = 1000.0;

const char* name_of(kinematics::ArmSide side) {
  return side == kinematics::ArmSide::kLeft ? "left" : "right";
}

Eigen::Vector3d axis_of(char letter) {
  return Eigen::Vector3d::Unit(std::tolower(letter) - 'x');
}

Eigen::Quaterniond euler_rotation(const double* angles, const RotationColumns& how) {
  const double factor = unit_factor(how.unit);
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(factor * angles[i], axis_of(how.order[i])));
    const bool moving_axes = how.order[i] >= 'X' && how.order[i] <= 'Z';
    q = moving_axes ? q * turn : turn * q;
  }
  return q;
}

/// The rotation seen in a mirror across the plane normal to `axis`: its axis of turning is a pseudo-vector.
Eigen::Quaterniond mirrored(const Eigen::Quaterniond& q, int axis) {
  Eigen::Vector3d v = -q.vec();
  v[axis] = -v[axis];
  return {q.w(), v.x(), v.y(), v.z()};
}

}  // namespace

MappedArm::MappedArm(ArmColumns columns, const FrameMap& frame, kinematics::ArmSide side)
    : columns_(std::move(columns)), frame_(frame), side_(side), model_(kinematics::psm_model(side)) {}

Result<MappedArm> MappedArm::resolve(const NumberTable& table, const ArmColumns& columns, const FrameMap& frame,
                                     kinematics::ArmSide side) {
  MappedArm arm(columns, frame, side);
  std::vector<ColumnName> names;
  if (columns.position) names = columns.position->columns;
  if (columns.joints) names = columns.joints->columns;
  if (columns.rotation) names.insert(names.end(), columns.rotation->columns.begin(), columns.rotation->columns.end());
  if (columns.jaw) names.push_back(columns.jaw->column);
  for (const ColumnName& name : names) {
    TROCAR_ASSIGN_OR_RETURN(const std::size_t column, table.find(name));
    if (std::find(arm.used_.begin(), arm.used_.end(), column) != arm.used_.end()) {
      return fail(ErrorCode::kInvalidArgument,
                  fmt::format("the map takes two numbers of the {} tool from one column, {}", name_of(side),
                              table.shown(column)));
    }
    arm.used_.push_back(column);
  }
  return arm;
}

Result<MappedArm::Outcome> MappedArm::take(const NumberTable& table, std::size_t row, demonstration::ArmSample& into) {
  TROCAR_RETURN_IF_ERROR(table.read(row, used_, numbers_));
  for (const double number : numbers_) {
    if (!std::isfinite(number)) return Outcome::kNumberMissing;
  }
  double jaw_rad = 0.0;
  if (columns_.jaw) {
    const JawColumn& jaw = *columns_.jaw;
    const bool ratio = jaw.unit == "ratio";
    jaw_rad = ratio ? (numbers_.back() - jaw.closed) / (jaw.open - jaw.closed) * spatial::from_degrees(jaw.open_deg)
                    : numbers_.back() * unit_factor(jaw.unit);
  }
  if (std::abs(jaw_rad) > kFarthest_rad) {
    return fail(ErrorCode::kCorrupt, fmt::format("{}: the {} jaw is no angle", table.place(row), name_of(side_)));
  }
  into.setpoint_jaw_rad = jaw_rad;
  const std::string place = table.place(row);
  if (columns_.joints) return take_joints(place, into);
  if (columns_.position) return take_pose(place, into);
  into.set_setpoint(kinematics::ready_pose(side_), jaw_rad);
  return Outcome::kTaken;
}

Result<MappedArm::Outcome> MappedArm::take_pose(const std::string& place, demonstration::ArmSample& into) {
  const double factor = unit_factor(columns_.position->unit) * frame_.scale;
  spatial::Pose X_FT;
  X_FT.p = factor * Eigen::Vector3d(numbers_[0], numbers_[1], numbers_[2]);
  if (!(X_FT.p.norm() <= kFarthest_m)) {
    return fail(ErrorCode::kCorrupt, fmt::format("{}: the {} tool is more than a kilometre away, is its unit {}?",
                                                 place, name_of(side_), columns_.position->unit));
  }
  if (columns_.rotation) {
    const std::optional<Eigen::Quaterniond> q = rotation(numbers_.data() + 3);
    if (!q) return Outcome::kNoRotation;
    X_FT.q = *q;
  }
  spatial::Pose X_WT = placed(X_FT);
  if (!columns_.rotation) X_WT.q = kinematics::pointing_down(0.0);
  into.set_setpoint(X_WT, into.setpoint_jaw_rad);
  return Outcome::kTaken;
}

Result<MappedArm::Outcome> MappedArm::take_joints(const std::string& place, demonstration::ArmSample& into) {
  kinematics::Joints q{};
  for (std::size_t i = 0; i < q.size(); ++i) {
    q[i] = numbers_[i] * unit_factor(i == 2 ? columns_.joints->insertion_unit : columns_.joints->unit);
    if (std::abs(q[i]) > kFarthest_rad) {
      return fail(ErrorCode::kCorrupt, fmt::format("{}: {} of the {} arm is no joint's value", place,
                                                   kinematics::joint_name(static_cast<int>(i)), name_of(side_)));
    }
    into.joints[i] = static_cast<float>(q[i]);
  }
  if (const Status inside = kinematics::check_limits(model_, q); !inside && beyond_limits_++ == 0) {
    first_beyond_ = fmt::format("{}: {}", place, inside.error().text());
  }
  spatial::Pose X_WT = kinematics::forward(model_, q);
  if (X_WT.q.dot(last_) < 0.0) X_WT.q.coeffs() = -X_WT.q.coeffs();
  last_ = X_WT.q;
  into.set_setpoint(X_WT, into.setpoint_jaw_rad);
  return Outcome::kTaken;
}

std::optional<Eigen::Quaterniond> MappedArm::rotation(const double* n) {
  const RotationColumns& how = *columns_.rotation;
  double off = 0.0;
  Eigen::Quaterniond q;
  if (how.kind.starts_with("quaternion")) {
    q = how.kind == "quaternion_wxyz" ? Eigen::Quaterniond(n[0], n[1], n[2], n[3])
                                      : Eigen::Quaterniond(n[3], n[0], n[1], n[2]);
    off = std::abs(q.norm() - 1.0);
    if (!(off <= kFarFromRotation)) return std::nullopt;
    worst_rotation_ = std::max(worst_rotation_, off);
    return q.normalized();  // its sign as it stands there
  }
  if (how.kind == "euler") {
    q = euler_rotation(n, how);
  } else {
    Eigen::Matrix3d R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(n);
    if (how.kind == "matrix_columns") R.transposeInPlace();
    off = (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (!(off <= kFarFromRotation) || R.determinant() <= 0.0) return std::nullopt;
    q = Eigen::Quaterniond(R).normalized();
  }
  worst_rotation_ = std::max(worst_rotation_, off);
  if (q.dot(last_) < 0.0) q.coeffs() = -q.coeffs();
  last_ = q;
  return q;
}

spatial::Pose MappedArm::placed(const spatial::Pose& X_FT) const {
  spatial::Pose X = X_FT;
  if (frame_.mirror != "none") {
    const int axis = frame_.mirror[0] - 'x';
    X.p[axis] = -X.p[axis];
    X.q = mirrored(X.q, axis);
  }
  const auto& q = frame_.rotation_wxyz;
  const spatial::Pose X_WF{{frame_.translation_m[0], frame_.translation_m[1], frame_.translation_m[2]},
                           Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized()};
  return X_WF * X;
}

std::vector<std::string> MappedArm::found() const {
  std::vector<std::string> found;
  if (worst_rotation_ > kRounded) {
    found.push_back(fmt::format("the {} tool's rotations are off by up to {:.2g}; unit quaternions stand in",
                                name_of(side_), worst_rotation_));
  }
  if (beyond_limits_ > 0) {
    found.push_back(fmt::format("the {} arm's joints are beyond their limits in {} {}, first in {}", name_of(side_),
                                beyond_limits_, beyond_limits_ == 1 ? "row" : "rows", first_beyond_));
  }
  return found;
}

std::vector<std::string> MappedArm::lossy() const {
  const char* name = name_of(side_);
  if (columns_.empty()) return {fmt::format("the {} arm (it stands at its ready pose)", name)};
  std::vector<std::string> lossy;
  if (columns_.position && !columns_.rotation)
    lossy.push_back(fmt::format("the {} tool's rotation (it points down)", name));
  if (!columns_.jaw) lossy.push_back(fmt::format("the {} tool's jaw (it is closed)", name));
  if (!columns_.joints) lossy.push_back(fmt::format("the joints of the {} arm", name));
  return lossy;
}

}  // namespace trocar::exchange
