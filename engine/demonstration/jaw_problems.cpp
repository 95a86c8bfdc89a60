#include "engine/demonstration/jaw_problems.h"

#include <fmt/format.h>

#include <algorithm>
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
  for (const CompactPose& block : sample.blocks) nearest_m = std::min(nearest_m, (block.pose().p - p_WT).norm());
  return nearest_m;
}

void check_closing(const Demonstration& document, std::size_t arm, std::vector<Problem>& found) {
  bool open = false;
  for (const Sample& sample : document.gated()) {
    const double jaw_rad = sample.arms[arm].setpoint_jaw_rad;
    if (jaw_rad >= kJawOpen_rad) open = true;
    if (!open || jaw_rad > kJawClosed_rad) continue;
    open = false;
    const double distance_m = nearest_block_m(sample, arm);
    if (distance_m <= kReach_m) continue;
    const double t_s = document.time_of(sample);
    found.push_back({ProblemKind::kJaw, Severity::kWarning, t_s, t_s,
                     fmt::format("the {} gripper closes on nothing, the nearest block is {:.0f} mm away",
                                 arm == 0 ? "left" : "right", 1e3 * (distance_m - peg_board::kBlockCircumradius_m)),
                     "", static_cast<int>(arm)});
  }
}

void check_hand_off(const Demonstration& document, std::vector<Problem>& found) {
  double left_until_s = -1.0;
  bool together = false;
  for (const Sample& sample : document.gated()) {
    const bool left = (sample.flags & kLeftHolds) != 0;
    const bool right = (sample.flags & kRightHolds) != 0;
    if (left) left_until_s = document.time_of(sample);
    together = together || (left && right);
    if (!right || left_until_s < 0.0) continue;
    if (!together) {
      found.push_back({ProblemKind::kJaw, Severity::kWarning, left_until_s, document.time_of(sample),
                       "the block changes hands without a moment in which both arms hold it", ""});
    }
    return;
  }
}

}  // namespace

void add_jaw_problems(const Demonstration& document, std::vector<Problem>& found) {
  for (std::size_t arm = 0; arm < 2; ++arm) check_closing(document, arm, found);
  check_hand_off(document, found);
}

}  // namespace trocar::demonstration
