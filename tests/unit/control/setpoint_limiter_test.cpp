#include "engine/control/setpoint_limiter.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/random.h"
#include "engine/spatial/rotation.h"

using namespace trocar;
using control::MotionLimits;
using control::SetpointLimiter;
using control::ToolCommand;
using spatial::Pose;

namespace {

constexpr double kPeriod_s = 0.005;
constexpr double kRounding = 1e-9;

ToolCommand at(double x_m) {
  return {Pose::translation({x_m, 0.0, 0.0}), 0.0};
}

}  // namespace

TEST_CASE("a wish within the limits passes through bit for bit") {
  const MotionLimits limits;
  SetpointLimiter limiter(limits, kPeriod_s, at(0.0));
  for (int i = 1; i <= 400; ++i) {
    const double t_s = i * kPeriod_s;
    const ToolCommand wish{{{0.02 * (1.0 - std::cos(t_s)), 0.01 * (1.0 - std::cos(2.0 * t_s)), 0.0},
                            spatial::about_z(0.5 * (1.0 - std::cos(t_s)))},
                           0.3 * (1.0 - std::cos(t_s))};
    const auto out = limiter.next(wish);
    CHECK(out.command.X_WT == wish.X_WT);
    CHECK(out.command.jaw_rad == wish.jaw_rad);
    CHECK_FALSE(out.report.any());
  }
  CHECK(limiter.hits() == 0);
}

TEST_CASE("a jumping wish is approached within speed and acceleration and reached without a swing") {
  const MotionLimits limits;
  SetpointLimiter limiter(limits, kPeriod_s, at(0.0));
  double x = 0.0;
  double v = 0.0;
  bool reported = false;
  for (int i = 0; i < 400; ++i) {
    const auto out = limiter.next(at(0.030));
    const double v_next = (out.command.X_WT.p.x() - x) / kPeriod_s;
    CHECK(std::abs(v_next) <= limits.speed_m_s + kRounding);
    CHECK(std::abs(v_next - v) <= limits.acceleration_m_s2 * kPeriod_s + kRounding);
    CHECK(out.command.X_WT.p.x() <= 0.030 + 1e-4);
    reported = reported || out.report.speed || out.report.acceleration;
    x = out.command.X_WT.p.x();
    v = v_next;
  }
  CHECK(x == 0.030);
  CHECK(reported);
  CHECK(limiter.hits() > 0);
}

TEST_CASE("random wishes never get past the limits") {
  const MotionLimits limits;
  Random random(5);
  SetpointLimiter limiter(limits, kPeriod_s, at(0.0));
  ToolCommand last = limiter.setpoint();
  Eigen::Vector3d v{0.0, 0.0, 0.0};
  ToolCommand wish = last;
  for (int i = 0; i < 5000; ++i) {
    if (random.below(20) == 0) {
      wish.X_WT.p = {random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05)};
      wish.X_WT.q = Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
      wish.jaw_rad = random.uniform(-0.7, 1.4);
    }
    const ToolCommand out = limiter.next(wish).command;
    const Eigen::Vector3d v_next = (out.X_WT.p - last.X_WT.p) / kPeriod_s;
    REQUIRE(v_next.norm() <= limits.speed_m_s + kRounding);
    REQUIRE((v_next - v).norm() <= limits.acceleration_m_s2 * kPeriod_s + kRounding);
    REQUIRE(spatial::angle_between(out.X_WT.q, last.X_WT.q) <= limits.angular_rad_s * kPeriod_s + kRounding);
    REQUIRE(std::abs(out.jaw_rad - last.jaw_rad) <= limits.jaw_rad_s * kPeriod_s + kRounding);
    v = v_next;
    last = out;
  }
}

TEST_CASE("a fast turn and a fast jaw saturate and are reported") {
  const MotionLimits limits;
  SetpointLimiter limiter(limits, kPeriod_s, at(0.0));
  const auto out = limiter.next({{{0.0, 0.0, 0.0}, spatial::about_y(1.0)}, 1.0});
  CHECK(out.report.angular);
  CHECK(out.report.jaw);
  CHECK_FALSE(out.report.speed);
  CHECK(spatial::angle_between(out.command.X_WT.q, Eigen::Quaterniond::Identity()) ==
        doctest::Approx(limits.angular_rad_s * kPeriod_s));
  CHECK(out.command.jaw_rad == doctest::Approx(limits.jaw_rad_s * kPeriod_s));
}

TEST_CASE("a wish that is not a finite pose is dropped and counted") {
  SetpointLimiter limiter(MotionLimits{}, kPeriod_s, at(0.01));
  ToolCommand wish = at(std::numeric_limits<double>::quiet_NaN());
  CHECK(limiter.next(wish).report.invalid);
  wish = at(0.01);
  wish.X_WT.q.coeffs() *= 2.0;
  CHECK(limiter.next(wish).report.invalid);
  wish = at(0.01);
  wish.jaw_rad = std::numeric_limits<double>::infinity();
  const auto out = limiter.next(wish);
  CHECK(out.report.invalid);
  CHECK(out.command.X_WT == at(0.01).X_WT);
  CHECK(limiter.hits() == 3);
}
