#include "engine/trial/event_operator.h"

#include <utility>

#include "engine/control/tool_mapping.h"
#include "engine/trial/sampling.h"

namespace trocar::trial {

EventOperator::EventOperator(kinematics::ArmSide side, const control::ToolCommand& start, double scale,
                             std::string name)
    : side_(side), scale_(scale), name_(std::move(name)), start_(start.X_WT), hand_(HandMode::kContinuous, start) {}

void EventOperator::take_events() {
  const bool has_pedals = side_ == kinematics::ArmSide::kLeft;
  while (const std::optional<HandEvent> event = events_.pop()) {
    const auto of_mine = [this](const auto& each) { return each.arm == side_; };
    if (const auto* drive = std::get_if<DriveTool>(&*event); drive != nullptr && of_mine(*drive)) {
      hand_.drive(drive->v_WT, drive->w_WT_T);
    } else if (const auto* shift = std::get_if<ShiftTool>(&*event); shift != nullptr && of_mine(*shift)) {
      hand_.shift(shift->by_W_m);
    } else if (const auto* jaw = std::get_if<ToggleJaw>(&*event); jaw != nullptr && of_mine(*jaw)) {
      hand_.toggle_jaw();
    } else if (const auto* clutch = std::get_if<HoldClutch>(&*event)) {
      clutch_ = has_pedals && clutch->down;
    } else if (const auto* pedal = std::get_if<HoldAgentPedal>(&*event)) {
      agent_pedal_ = has_pedals && pedal->down;
    }
  }
}

HandSample EventOperator::sample(const simulation::WorldState& seen) {
  take_events();
  const control::ToolCommand told = setpoint_of(seen, side_);
  // The agent moves the tool, or the guard does not let it follow: the hand is where the tool is.
  constexpr double kFarAhead_m = 0.010;
  control::ToolCommand wish = hand_.next();
  if (agent_pedal_ || (wish.X_WT.p - told.X_WT.p).norm() > kFarAhead_m) {
    hand_.stay_at({told.X_WT, wish.jaw_rad});
    wish.X_WT = told.X_WT;
  }
  const Eigen::Quaterniond R_WD = control::display_rotation();
  HandSample hand;
  hand.X_DH.p = R_WD.conjugate() * (wish.X_WT.p - start_.p) / scale_;
  hand.X_DH.q = (R_WD.conjugate() * wish.X_WT.q * start_.q.conjugate() * R_WD).normalized();
  hand.grip_rad = wish.jaw_rad;
  hand.agent_pedal = agent_pedal_;
  hand.clutch_pedal = clutch_;
  last_ = hand;
  return hand;
}

std::optional<HandSample> EventOperator::news(Tick now) {
  static_cast<void>(now);
  take_events();
  if (last_.agent_pedal == agent_pedal_ && last_.clutch_pedal == clutch_) return std::nullopt;
  last_.agent_pedal = agent_pedal_;
  last_.clutch_pedal = clutch_;
  return last_;
}

}  // namespace trocar::trial
