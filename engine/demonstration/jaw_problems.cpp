#include "engine/demonstration/jaw_problems.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/demonstration/jaw_limits.h"
#include "engine/demonstration/motion.h"

namespace trocar::demonstration {
namespace {

/// "Closing with no block in 3 mm" (workbench, Validity), from the block's circumscribed sphere about its centre.
constexpr double kReach_m = 0.003 + peg_board::kBlockCircumradius_m;

double nearest_block_m(const Sample& sample, std::size_t arm) {
  const Eigen::Vector3d p_WT = measured_tip(sample, arm);
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const CompactPose& block : sample.blocks) {
    if (is_known(block)) nearest_m = std::min(nearest_m, (block.pose().p - p_WT).norm());
  }
  return nearest_m;
}

}  // namespace

void JawChecks::check_closing(const Sample& sample, double t_s, std::size_t arm) {
  const double jaw_rad = sample.arms[arm].setpoint_jaw_rad;
  if (jaw_rad >= kJawOpen_rad) open_[arm] = true;
  if (!open_[arm] || jaw_rad > kJawClosed_rad) return;
  open_[arm] = false;
  const double distance_m = nearest_block_m(sample, arm);
  // Where no block was recorded, nobody knows what it closes on.
  if (distance_m <= kReach_m || !std::isfinite(distance_m)) return;
  closings_[arm].push_back(
      {ProblemKind::kJaw, Severity::kWarning, t_s, t_s,
       fmt::format("the {} gripper closes on nothing, the nearest block is {:.0f} mm away", arm == 0 ? "left" : "right",
                   1e3 * (distance_m - peg_board::kBlockCircumradius_m)),
       "", static_cast<int>(arm)});
}

void JawChecks::check_hand_off(const Sample& sample, double t_s) {
  if (handed_over_) return;
  const bool left = (sample.flags & kLeftHolds) != 0;
  const bool right = (sample.flags & kRightHolds) != 0;
  if (left) left_until_s_ = t_s;
  together_ = together_ || (left && right);
  if (!right || left_until_s_ < 0.0) return;
  if (!together_) {
    hand_off_ = Problem{ProblemKind::kJaw,
                        Severity::kWarning,
                        left_until_s_,
                        t_s,
                        "the block changes hands without a moment in which both arms hold it",
                        ""};
  }
  handed_over_ = true;
}

void JawChecks::add(const Sample& sample, double t_s) {
  for (std::size_t arm = 0; arm < open_.size(); ++arm) check_closing(sample, t_s, arm);
  check_hand_off(sample, t_s);
}

void JawChecks::report(std::vector<Problem>& found) const {
  for (const std::vector<Problem>& of_arm : closings_) found.insert(found.end(), of_arm.begin(), of_arm.end());
  if (hand_off_) found.push_back(*hand_off_);
}

}  // namespace trocar::demonstration
