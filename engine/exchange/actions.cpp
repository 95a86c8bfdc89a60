#include "engine/exchange/actions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/kinematics/psm.h"

namespace trocar::exchange {
namespace {

using demonstration::ArmSample;
using demonstration::Sample;

constexpr double kSmallestStep = 1e-6;

struct Step {
  Eigen::Vector3d position_m;
  Eigen::Vector3d rotation_rad;
};

Step step(const ArmSample& from, const ArmSample& to) {
  const spatial::Pose a = from.setpoint();
  const spatial::Pose b = to.setpoint();
  Eigen::Quaterniond turn = b.q.normalized() * a.q.normalized().conjugate();
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  const Eigen::AngleAxisd axis(turn);
  return {b.p - a.p, axis.angle() * axis.axis()};
}

/// 1, 2 or 5 times a power of ten, at or above `value`.
double rounded_up(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(std::max(value, kSmallestStep))));
  for (const double times : {1.0, 2.0, 5.0}) {
    if (value <= times * decade) return times * decade;
  }
  return 10.0 * decade;
}

double bounded(double value) {
  return std::clamp(value, -1.0, 1.0);  // rounding alone takes it out
}

}  // namespace

const std::vector<std::string>& action_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const std::string robot : {"robot0_", "robot1_"}) {
      for (const char* part : {"dx", "dy", "dz", "drx", "dry", "drz", "jaw"}) all.push_back(robot + part);
    }
    return all;
  }();
  return names;
}

std::array<double, kActionWidth> ActionScale::factor() const {
  std::array<double, kActionWidth> factors{};
  for (std::size_t i = 0; i < kActionWidth; ++i) {
    const std::size_t part = i % (kActionWidth / 2);
    factors[i] = part < 3 ? position_m : part < 6 ? rotation_rad : 0.5 * (jaw_closed_rad - jaw_open_rad);
  }
  return factors;
}

std::array<double, kActionWidth> ActionScale::offset() const {
  std::array<double, kActionWidth> offsets{};
  for (const std::size_t jaw : {kActionWidth / 2 - 1, kActionWidth - 1}) {
    offsets[jaw] = 0.5 * (jaw_closed_rad + jaw_open_rad);
  }
  return offsets;
}

ActionRange::ActionRange() {
  const kinematics::JointLimit jaw = kinematics::psm_model(kinematics::ArmSide::kLeft).jaw;
  jaw_low_rad_ = jaw.low;
  jaw_high_rad_ = jaw.high;
}

void ActionRange::add(std::span<const Sample> samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (std::size_t arm = 0; arm < 2; ++arm) {
      const ArmSample& now = samples[i].arms[arm];
      jaw_low_rad_ = std::min(jaw_low_rad_, now.setpoint_jaw_rad);
      jaw_high_rad_ = std::max(jaw_high_rad_, now.setpoint_jaw_rad);
      if (i == 0) continue;
      const Step taken = step(samples[i - 1].arms[arm], now);
      position_m_ = std::max(position_m_, taken.position_m.cwiseAbs().maxCoeff());
      rotation_rad_ = std::max(rotation_rad_, taken.rotation_rad.cwiseAbs().maxCoeff());
    }
  }
}

ActionScale ActionRange::scale() const {
  return {rounded_up(position_m_), rounded_up(rotation_rad_), jaw_high_rad_, jaw_low_rad_};
}

std::vector<double> actions(std::span<const Sample> samples, const ActionScale& scale) {
  std::vector<double> rows;
  rows.reserve(samples.size() * kActionWidth);
  const double jaw_factor = scale.factor().back();
  const double jaw_offset = scale.offset().back();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& next = samples[std::min(i + 1, samples.size() - 1)];
    for (std::size_t arm = 0; arm < 2; ++arm) {
      const Step taken = step(samples[i].arms[arm], next.arms[arm]);
      for (int axis = 0; axis < 3; ++axis) rows.push_back(bounded(taken.position_m[axis] / scale.position_m));
      for (int axis = 0; axis < 3; ++axis) rows.push_back(bounded(taken.rotation_rad[axis] / scale.rotation_rad));
      rows.push_back(bounded((next.arms[arm].setpoint_jaw_rad - jaw_offset) / jaw_factor));
    }
  }
  return rows;
}

}  // namespace trocar::exchange
