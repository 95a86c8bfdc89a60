#include "engine/demonstration/setpoint_problems.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/demonstration/jaw_limits.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/problem_spans.h"

namespace trocar::demonstration {
namespace {

/// A tip is less than this from its wrist, for which the workspaces are given; with 4 mm of their slack.
constexpr double kBeyondWrist_m = 0.020;
/// Further out than any bending of the arms explains: another frame, or another unit.
constexpr double kFarOutside_m = 0.1;
/// The guard of an arm holds at a larger step.
constexpr double kLeap_m = 0.005;
/// What the limiter lets through at its limit differs from it by rounding only.
constexpr double kAtLimit = 1.01;

/// Both arms' workspaces together, as the tools pass the block from one to the other.
double distance_outside_m(const Eigen::Vector3d& p_WT) {
  const spatial::Box left = peg_board::wrist_workspace(true);
  const spatial::Box right = peg_board::wrist_workspace(false);
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kBeyondWrist_m);
  const spatial::Box both{left.low.cwiseMin(right.low) - margin, left.high.cwiseMax(right.high) + margin};
  return (p_WT - both.clamp(p_WT)).norm();
}

}  // namespace

void SetpointChecks::check_place(const Sample& sample, double t_s, std::size_t arm) {
  const ArmSample& tool = sample.arms[arm];
  const double distance_m =
      std::max(distance_outside_m(tool.setpoint().p), distance_outside_m(measured_tip(sample, arm)));
  if (distance_m > 0.0) arms_[arm].outside.add(t_s, distance_m);
  const double beyond_rad = std::max(kJawLow_rad - tool.setpoint_jaw_rad, tool.setpoint_jaw_rad - kJawHigh_rad);
  if (beyond_rad > kJawRounding_rad) arms_[arm].jaw.add(t_s, beyond_rad);
}

void SetpointChecks::check_step(const Sample& sample, double t_s, std::size_t arm) {
  Arm& of = arms_[arm];
  const Eigen::Vector3d p_WT = sample.arms[arm].setpoint().p;
  const double jaw_rad = sample.arms[arm].setpoint_jaw_rad;
  const double seconds = begun_ ? sample.t_s() - last_s_ : 0.0;
  const double distance_m = (p_WT - of.last_p_WT).norm();
  const double turned_rad = std::abs(jaw_rad - of.last_jaw_rad);
  of.last_p_WT = p_WT;
  of.last_jaw_rad = jaw_rad;
  if (seconds <= 0.0) return;
  const double speed_m_s = distance_m / seconds;
  const bool fast = speed_m_s > kAtLimit * bounds_.speed_m_s;
  // A long way in a long time is no leap, as where samples are far apart.
  if (fast && distance_m > kLeap_m) of.leaps.add(t_s, distance_m);
  if (fast && distance_m <= kLeap_m) of.speeds.add(t_s, speed_m_s);
  if (turned_rad > kAtLimit * kJawRate_rad_s * seconds) of.jaw_speeds.add(t_s, turned_rad / seconds);
}

void SetpointChecks::add(const Sample& sample, double t_s) {
  for (std::size_t arm = 0; arm < arms_.size(); ++arm) {
    check_place(sample, t_s, arm);
    check_step(sample, t_s, arm);
  }
  begun_ = true;
  last_s_ = sample.t_s();
}

void SetpointChecks::report_places(std::size_t arm, const Arm& of, std::vector<Problem>& found) {
  for (const ProblemSpan& span : of.outside.spans()) {
    found.push_back({ProblemKind::kWorkspace, span.worst > kFarOutside_m ? Severity::kError : Severity::kWarning,
                     span.begin_s, span.end_s,
                     fmt::format("the {} tool is up to {:.3g} mm outside of where the arms work, in {} samples",
                                 kTools[arm], 1e3 * span.worst, span.count),
                     "", static_cast<int>(arm)});
  }
  for (const ProblemSpan& span : of.jaw.spans()) {
    found.push_back({ProblemKind::kJaw, Severity::kError, span.begin_s, span.end_s,
                     fmt::format("the {} jaws are told to go {:.3g}° beyond their limits of −40° and 80°", kTools[arm],
                                 span.worst * 180.0 / std::numbers::pi),
                     "", static_cast<int>(arm)});
  }
}

void SetpointChecks::report_steps(std::size_t arm, const Arm& of, std::vector<Problem>& found) const {
  for (const ProblemSpan& span : of.leaps.spans()) {
    found.push_back({ProblemKind::kSpeed, Severity::kError, span.begin_s, span.end_s,
                     fmt::format("the {} tool's setpoint leaps by {:.3g} mm from one sample to the next", kTools[arm],
                                 1e3 * span.worst),
                     "", static_cast<int>(arm)});
  }
  for (const ProblemSpan& span : of.speeds.spans()) {
    found.push_back({ProblemKind::kSpeed, Severity::kWarning, span.begin_s, span.end_s,
                     fmt::format("the {} tool's setpoint goes at {:.0f} mm/s, more than {:.0f}", kTools[arm],
                                 1e3 * span.worst, 1e3 * bounds_.speed_m_s),
                     "", static_cast<int>(arm)});
  }
  for (const ProblemSpan& span : of.jaw_speeds.spans()) {
    found.push_back({ProblemKind::kJaw, Severity::kWarning, span.begin_s, span.end_s,
                     fmt::format("the {} jaws are told to turn at {:.3g} rad/s, more than {:.0f}", kTools[arm],
                                 span.worst, kJawRate_rad_s),
                     "", static_cast<int>(arm)});
  }
}

void SetpointChecks::report(std::vector<Problem>& found) const {
  for (std::size_t arm = 0; arm < arms_.size(); ++arm) {
    report_places(arm, arms_[arm], found);
    report_steps(arm, arms_[arm], found);
  }
}

}  // namespace trocar::demonstration
