#include "engine/trial/arm_drive.h"

#include <algorithm>

#include "engine/core/check.h"
#include "engine/demonstration/recording.h"

namespace trocar::trial {

ArmDrive::ArmDrive(kinematics::ArmSide side, const control::ToolCommand& start, double scale)
    : model_(kinematics::psm_model(side)),
      mapping_(control::ToolMapping(control::display_rotation(), scale)),
      limiter_(control::MotionLimits{}, 1.0 / demonstration::kSampleRate_hz, start) {}

control::ToolCommand ArmDrive::advance(const HandSample& hand, Tick now) {
  const control::ToolCommand held = limiter_.setpoint();
  if (!engaged_) {
    mapping_.take_over(hand.X_DH, held.X_WT);
    engaged_ = true;
  }
  control::ToolCommand wish;
  wish.X_WT = mapping_.follow(hand.X_DH, hand.clutch_pedal, now);
  wish.jaw_rad = hand.grip_rad;
  const control::ToolCommand next = approach(wish);
  if (!refusal_.empty()) mapping_.take_over(hand.X_DH, held.X_WT);
  return next;
}

control::ToolCommand ArmDrive::approach(const control::ToolCommand& wish) {
  const control::ToolCommand held = limiter_.setpoint();
  const control::LimitedCommand limited =
      limiter_.next({wish.X_WT, std::clamp(wish.jaw_rad, model_.jaw.low, model_.jaw.high)});
  limits_ = limited.report;
  refusal_.clear();
  const Result<kinematics::Joints> joints = kinematics::inverse(model_, limited.command.X_WT);
  if (joints) return limited.command;
  ++unreachable_;
  refusal_ = joints.error().text();
  const control::ToolCommand staying{held.X_WT, limited.command.jaw_rad};
  limiter_.restart(staying);
  return staying;
}

control::ToolCommand between(const control::ToolCommand& from, const control::ToolCommand& to, int sub, int count) {
  TROCAR_CHECK(sub >= 1 && sub <= count);
  if (sub == count) return to;
  const double s = static_cast<double>(sub) / count;
  return {spatial::interpolate(from.X_WT, to.X_WT, s), from.jaw_rad + s * (to.jaw_rad - from.jaw_rad)};
}

}  // namespace trocar::trial
