#include "engine/control/setpoint_limiter.h"

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"

namespace trocar::control {
namespace {

// A share of the allowed acceleration is kept back when braking, for the last period's rounding up.
constexpr double kBrakingShare = 0.8;
constexpr double kUnitTolerance = 1e-6;

/// The largest speed for the next period from which `distance_m` minus that period's way is enough to brake.
double braking_speed(double distance_m, double deceleration_m_s2, double period_s) {
  const double step = deceleration_m_s2 * period_s;
  return std::sqrt(step * step + 2.0 * deceleration_m_s2 * distance_m) - step;
}

}  // namespace

bool well_formed(const ToolCommand& command) {
  return command.X_WT.finite() && std::isfinite(command.jaw_rad) &&
         std::abs(command.X_WT.q.norm() - 1.0) < kUnitTolerance;
}

SetpointLimiter::SetpointLimiter(const MotionLimits& limits, double period_s, const ToolCommand& start)
    : limits_(limits), period_s_(period_s), setpoint_(start), last_wish_(start.X_WT.p) {
  TROCAR_CHECK(period_s > 0.0 && limits.speed_m_s > 0.0 && limits.acceleration_m_s2 > 0.0);
  TROCAR_CHECK(limits.angular_rad_s > 0.0 && limits.jaw_rad_s > 0.0);
}

void SetpointLimiter::restart(const ToolCommand& start) {
  setpoint_ = start;
  last_wish_ = start.X_WT.p;
  v_WT_.setZero();
}

Eigen::Vector3d SetpointLimiter::next_position(const Eigen::Vector3d& wish, double period_s, LimitReport& report) {
  const Eigen::Vector3d error = wish - setpoint_.X_WT.p;
  const double dv_max = limits_.acceleration_m_s2 * period_s;
  const Eigen::Vector3d v_exact = error / period_s;
  const Eigen::Vector3d v_wish = (wish - last_wish_) / period_s;
  last_wish_ = wish;
  report.speed = v_exact.norm() > limits_.speed_m_s;
  // Arriving faster than the wish itself moves is allowed only if the difference can be braked in one period.
  report.acceleration = (v_exact - v_WT_).norm() > dv_max || (v_exact - v_wish).norm() > dv_max;
  if (!report.speed && !report.acceleration) {
    v_WT_ = v_exact;
    return wish;
  }
  const double distance = error.norm();
  const double braking = braking_speed(distance, kBrakingShare * limits_.acceleration_m_s2, period_s);
  const double speed = std::min({limits_.speed_m_s, distance / period_s, braking});
  Eigen::Vector3d change = -v_WT_;
  if (distance > 0.0) change += error * (speed / distance);
  if (change.norm() > dv_max) change *= dv_max / change.norm();
  v_WT_ += change;
  return setpoint_.X_WT.p + v_WT_ * period_s;
}

LimitedCommand SetpointLimiter::next(const ToolCommand& wish, double period_s) {
  LimitReport report;
  if (!well_formed(wish)) {
    report.invalid = true;
    v_WT_.setZero();
    ++hits_;
    return {setpoint_, report};
  }
  ToolCommand command = wish;
  command.X_WT.p = next_position(wish.X_WT.p, period_s, report);

  const double turn_rad = spatial::angle_between(setpoint_.X_WT.q, wish.X_WT.q);
  const double turn_max_rad = limits_.angular_rad_s * period_s;
  report.angular = turn_rad > turn_max_rad;
  if (report.angular) command.X_WT.q = setpoint_.X_WT.q.slerp(turn_max_rad / turn_rad, wish.X_WT.q).normalized();

  const double jaw_step_rad = wish.jaw_rad - setpoint_.jaw_rad;
  const double jaw_max_rad = limits_.jaw_rad_s * period_s;
  report.jaw = std::abs(jaw_step_rad) > jaw_max_rad;
  if (report.jaw) command.jaw_rad = setpoint_.jaw_rad + std::copysign(jaw_max_rad, jaw_step_rad);

  if (report.any()) ++hits_;
  setpoint_ = command;
  return {command, report};
}

void SetpointLimiter::rewind(const ToolCommand& reached) {
  setpoint_ = reached;
  last_wish_ = reached.X_WT.p;
}

ToolCommand SetpointLimiter::brake(double period_s) {
  const double slower = limits_.acceleration_m_s2 * period_s;
  const double speed = v_WT_.norm();
  v_WT_ *= speed > slower ? (speed - slower) / speed : 0.0;
  setpoint_.X_WT.p += v_WT_ * period_s;
  last_wish_ = setpoint_.X_WT.p;
  return setpoint_;
}

}  // namespace trocar::control
