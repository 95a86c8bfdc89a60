#include "engine/demonstration/setpoint_problems.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/demonstration/jaw_limits.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/problem_spans.h"

namespace trocar::demonstration {
namespace {

/// A tip is less than this from its wrist, for which the workspaces are given; with 4 mm of their slack.
constexpr double kBeyondWrist_m = 0.020;
/// Further out than any bending of the arms explains: another frame, or another unit.
constexpr double kFarOutside_m = 0.1;
constexpr double kJawRate_rad_s = 8.0;
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

void check_places(const Demonstration& document, std::size_t arm, std::vector<Problem>& found) {
  SpanCollector outside;
  SpanCollector jaw;
  for (const Sample& sample : document.gated()) {
    const double t_s = document.time_of(sample);
    const ArmSample& tool = sample.arms[arm];
    const double distance_m =
        std::max(distance_outside_m(tool.setpoint().p), distance_outside_m(measured_tip(sample, arm)));
    if (distance_m > 0.0) outside.add(t_s, distance_m);
    const double beyond_rad = std::max(kJawLow_rad - tool.setpoint_jaw_rad, tool.setpoint_jaw_rad - kJawHigh_rad);
    if (beyond_rad > kJawRounding_rad) jaw.add(t_s, beyond_rad);
  }
  for (const ProblemSpan& span : outside.spans()) {
    found.push_back({ProblemKind::kWorkspace, span.worst > kFarOutside_m ? Severity::kError : Severity::kWarning,
                     span.begin_s, span.end_s,
                     fmt::format("the {} tool is up to {:.3g} mm outside of where the arms work, in {} samples",
                                 kTools[arm], 1e3 * span.worst, span.count),
                     "", static_cast<int>(arm)});
  }
  for (const ProblemSpan& span : jaw.spans()) {
    found.push_back({ProblemKind::kJaw, Severity::kError, span.begin_s, span.end_s,
                     fmt::format("the {} jaws are told to go {:.3g}° beyond their limits of −40° and 80°", kTools[arm],
                                 span.worst * 180.0 / std::numbers::pi),
                     "", static_cast<int>(arm)});
  }
}

struct Step {
  double seconds = 0.0;
  double distance_m = 0.0;
  double jaw_rad = 0.0;
};

Step step_between(const Sample& before, const Sample& after, std::size_t arm) {
  const ArmSample& from = before.arms[arm];
  const ArmSample& to = after.arms[arm];
  return {after.t_s() - before.t_s(), (to.setpoint().p - from.setpoint().p).norm(),
          std::abs(to.setpoint_jaw_rad - from.setpoint_jaw_rad)};
}

void check_steps(const Demonstration& document, std::size_t arm, const MotionBounds& bounds,
                 std::vector<Problem>& found) {
  SpanCollector leaps;
  SpanCollector speeds;
  SpanCollector jaws;
  std::optional<Sample> before;
  for (const Sample& sample : document.gated()) {
    const Step step = before ? step_between(*before, sample, arm) : Step{};
    before = sample;
    if (step.seconds <= 0.0) continue;
    const double t_s = document.time_of(sample);
    const double speed_m_s = step.distance_m / step.seconds;
    const bool fast = speed_m_s > kAtLimit * bounds.speed_m_s;
    // A long way in a long time is no leap, as where samples are far apart.
    if (fast && step.distance_m > kLeap_m) leaps.add(t_s, step.distance_m);
    if (fast && step.distance_m <= kLeap_m) speeds.add(t_s, speed_m_s);
    if (step.jaw_rad > kAtLimit * kJawRate_rad_s * step.seconds) jaws.add(t_s, step.jaw_rad / step.seconds);
  }
  for (const ProblemSpan& span : leaps.spans()) {
    found.push_back({ProblemKind::kSpeed, Severity::kError, span.begin_s, span.end_s,
                     fmt::format("the {} tool's setpoint leaps by {:.3g} mm from one sample to the next", kTools[arm],
                                 1e3 * span.worst),
                     "", static_cast<int>(arm)});
  }
  for (const ProblemSpan& span : speeds.spans()) {
    found.push_back({ProblemKind::kSpeed, Severity::kWarning, span.begin_s, span.end_s,
                     fmt::format("the {} tool's setpoint goes at {:.0f} mm/s, more than {:.0f}", kTools[arm],
                                 1e3 * span.worst, 1e3 * bounds.speed_m_s),
                     "", static_cast<int>(arm)});
  }
  for (const ProblemSpan& span : jaws.spans()) {
    found.push_back({ProblemKind::kJaw, Severity::kWarning, span.begin_s, span.end_s,
                     fmt::format("the {} jaws are told to turn at {:.3g} rad/s, more than {:.0f}", kTools[arm],
                                 span.worst, kJawRate_rad_s),
                     "", static_cast<int>(arm)});
  }
}

}  // namespace

void add_setpoint_problems(const Demonstration& document, const MotionBounds& bounds, std::vector<Problem>& found) {
  for (std::size_t arm = 0; arm < 2; ++arm) {
    check_places(document, arm, found);
    check_steps(document, arm, bounds, found);
  }
}

}  // namespace trocar::demonstration
