#include "engine/trial/guarded_arm.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/demonstration/recording.h"
#include "engine/kinematics/psm.h"

namespace trocar::trial {

using control::ToolCommand;

control::GuardSettings guard_settings() {
  control::GuardSettings settings;
  settings.period_s = 1.0 / demonstration::kSampleRate_hz;
  // The tip's own radius is not left out: a tool is a few millimetres wide, and the agent comes to the block from
  // above.
  constexpr double kClearance_m = 0.0010;
  for (int i = 0; i < peg_board::kBlockCount; ++i) {
    for (const Eigen::Vector3d& foot : {peg_board::start_peg(i), peg_board::goal_peg(i)}) {
      settings.keep_out.push_back({foot, peg_board::kPegRadius_m + kClearance_m, peg_board::kPegHeight_m});
    }
  }
  return settings;
}

GuardedArm::GuardedArm(control::Arm& arm, control::GuardSettings settings, double scale)
    : arm_(&arm),
      guard_(std::move(settings), arm.setpoint_cp()),
      mapping_(control::ToolMapping(control::display_rotation(), scale)) {}

void GuardedArm::take_over(const HandSample& hand) {
  carry_ = control::CarryOver(guard_.velocity());
  jaw_follows_ = false;
  grip_before_rad_ = hand.grip_rad;
  mapping_.take_over(hand.X_DH, guard_.setpoint().X_WT);
}

ToolCommand GuardedArm::admit(const ToolCommand& wish, Tick now, double period_s, bool autonomous) {
  const ToolCommand held = guard_.setpoint();
  const control::Admitted admitted = guard_.admit({wish, now, period_s, autonomous});
  limits_ = admitted.limits;
  refusal_.clear();
  const Status reached = arm_->reaches(admitted.command.X_WT);
  if (reached) return admitted.command;
  refusal_ = reached.error().text();
  const ToolCommand staying{held.X_WT, admitted.command.jaw_rad};
  guard_.refused(staying);
  return staying;
}

/// A hand that has opened while somebody else held the block must not drop it: the jaw waits for the grip to pass it.
double GuardedArm::jaw_for(double grip_rad) {
  constexpr double kSame_rad = 0.02;
  const double jaw_rad = guard_.setpoint().jaw_rad;
  const bool passed = (grip_before_rad_ - jaw_rad) * (grip_rad - jaw_rad) <= 0.0;
  jaw_follows_ = jaw_follows_ || passed || std::abs(grip_rad - jaw_rad) < kSame_rad;
  grip_before_rad_ = grip_rad;
  return jaw_follows_ ? grip_rad : jaw_rad;
}

ToolCommand GuardedArm::follow(const HandSample& hand, Tick now, double period_s) {
  static const kinematics::JointLimit kJaw = kinematics::psm_model(kinematics::ArmSide::kLeft).jaw;
  const bool was_engaged = guard_.state() == control::GuardState::kMoving;
  ToolCommand wish;
  wish.X_WT = mapping_.follow(hand.X_DH, hand.clutch_pedal, now);
  if (!carry_.over()) {
    wish.X_WT.p += carry_.advance(period_s);
    // What it was carried by stays in the engagement.
    if (carry_.over()) mapping_.take_over(hand.X_DH, wish.X_WT);
  }
  wish.jaw_rad = std::clamp(jaw_for(hand.grip_rad), kJaw.low, kJaw.high);
  const ToolCommand next = admit(wish, now, period_s, false);
  // What was held or refused goes on from where the tool is, not from where the hand has gone meanwhile.
  if (!refusal_.empty() || !was_engaged || guard_.state() != control::GuardState::kMoving) take_over(hand);
  return next;
}

ToolCommand GuardedArm::follow(Agent& agent, Tick now, double period_s) {
  ToolCommand wish = guard_.setpoint();
  wish.X_WT.p = agent.advance(period_s);
  return admit(wish, now, period_s, true);
}

ToolCommand GuardedArm::rest(double period_s) {
  return guard_.rest(period_s);
}

}  // namespace trocar::trial
