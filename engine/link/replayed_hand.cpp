#include "engine/link/replayed_hand.h"

#include <algorithm>
#include <utility>

#include "engine/control/tool_mapping.h"

namespace trocar::link {
namespace {

OneHand hand_leading(const demonstration::ArmSample& arm, const demonstration::ArmSample& first, double scale) {
  const Eigen::Quaterniond R_DW = control::display_rotation().conjugate();
  const spatial::Pose X_WT = arm.setpoint();
  OneHand hand;
  hand.X_DH.p = R_DW * (X_WT.p - first.setpoint().p) / scale;
  hand.X_DH.q = (R_DW * X_WT.q).normalized();
  hand.grip_rad = arm.setpoint_jaw_rad;
  return hand;
}

}  // namespace

Result<ReplayedHand> ReplayedHand::create(std::shared_ptr<const demonstration::Demonstration> shown, double scale) {
  if (shown->gated().empty()) return fail(ErrorCode::kInvalidArgument, shown->name + " has no samples");
  if (!(scale >= control::kSmallestScale && scale <= control::kLargestScale)) {
    return fail(ErrorCode::kInvalidArgument, "the scale from hand to tool is 0.1 to 0.5");
  }
  return ReplayedHand(std::move(shown), scale);
}

ReplayedHand::ReplayedHand(std::shared_ptr<const demonstration::Demonstration> shown, double scale)
    : shown_(std::move(shown)), scale_(scale), first_(shown_->sample_at(shown_->begin_s)) {}

HandFrame ReplayedHand::at(double t_s) const {
  const demonstration::Sample sample = shown_->sample_at(shown_->begin_s + std::clamp(t_s, 0.0, end_s()));
  HandFrame frame;
  frame.left = hand_leading(sample.arms[0], first_.arms[0], scale_);
  frame.right = hand_leading(sample.arms[1], first_.arms[1], scale_);
  return frame;
}

double ReplayedHand::end_s() const {
  return shown_->duration_s();
}

}  // namespace trocar::link
