#include "engine/trial/trial_authority.h"

#include <string>
#include <utility>

namespace trocar::trial {

using control::ControlState;
using control::GuardState;
using demonstration::Outcome;
using demonstration::Segment;

namespace {

constexpr Tick kRecordedAfterwards{1000};

}  // namespace

bool TrialAuthority::operator_has() const {
  return state() == ControlState::kOperator || state() == ControlState::kClutch;
}

bool TrialAuthority::agent_may(const TrialLook& look, const control::Guard& left) const {
  // Who has the arm keeps it while the guard lets it move; who asks for it must know what to do.
  if (agent_has()) return look.segment == segment_of_agent_ && left.state() == GuardState::kMoving;
  return machine_.agent_pedal().down && look.agent_can_begin;
}

void TrialAuthority::look(const TrialLook& look, const control::Guard& left, const control::Guard& right) {
  left_moves_ = left_moves_ || left.state() == GuardState::kMoving;
  const bool left_disarmed = left.state() == GuardState::kDisarmed;
  const bool armed = !left_disarmed && right.state() != GuardState::kDisarmed;
  control::ControlLook shown;
  shown.now = Tick{look.now.count + 1};
  shown.begin = !begun_;
  shown.ended = look.dropped || broken_off_ || ends_at_;
  shown.agent_pedal = look.agent_pedal;
  shown.clutch_pedal = look.clutch_pedal;
  shown.agent_may = agent_may(look, left);
  shown.fresh = left.state() == GuardState::kMoving || !left_moves_;
  shown.stop = look.stop;
  shown.connected = look.connected || !left_moves_;
  shown.homed = look.homed;
  shown.armed = armed;
  // What disarms an arm that was armed is a fault: it is not armed again by itself (rule 9).
  shown.fault = !armed;
  machine_.look(shown);
  begun_ = begun_ || operator_has();
  if (changed() && agent_has()) segment_of_agent_ = look.segment;
  log_changes(look.now);

  halts_ = !broken_off_ && (look.stop || !armed);
  if (!halts_) return;
  if (look.stop) return break_off(look.now, Outcome::kAborted, "stopped");
  break_off(look.now, Outcome::kFault,
            "fault: " + (left_disarmed ? left.reason_text() : "right: " + right.reason_text()));
}

void TrialAuthority::log_changes(Tick now) {
  const auto log = [&](TrialEventKind kind, std::string text) { recorder_->log(now, kind, std::move(text)); };
  if (machine_.agent_pedal().pressed) ++presses_, log(TrialEventKind::kPedal, "agent pedal down");
  if (machine_.agent_pedal().released) log(TrialEventKind::kPedal, "agent pedal up");
  if (machine_.clutch_pedal().pressed) log(TrialEventKind::kPedal, "clutch down");
  if (machine_.clutch_pedal().released) log(TrialEventKind::kPedal, "clutch up");
  if (changed()) log(TrialEventKind::kState, std::string(to_string(state())));
}

void TrialAuthority::break_off(Tick now, Outcome as, const std::string& why) {
  broken_off_ = as;
  ends_at_ = Tick{now.count + kRecordedAfterwards.count};
  recorder_->log(now, TrialEventKind::kOutcome, why);
}

void TrialAuthority::look_for_end(Tick now, bool nothing_left) {
  if (nothing_left && !ends_at_) ends_at_ = Tick{now.count + kRecordedAfterwards.count};
  ended_ = (ends_at_ && now >= *ends_at_) || now.seconds() >= time_limit_s_;
}

demonstration::Authority TrialAuthority::owner(Segment segment) const {
  if (state() == ControlState::kHold || state() == ControlState::kStopped) return demonstration::Authority::kHold;
  // With the segment the agent's time is over, at once.
  if (agent_has() && segment == segment_of_agent_) return demonstration::Authority::kAgent;
  return segment == Segment::kE ? demonstration::Authority::kAssistant : demonstration::Authority::kOperator;
}

Outcome TrialAuthority::outcome(Outcome of_task) const {
  return of_task == Outcome::kUnfinished ? broken_off_.value_or(Outcome::kUnfinished) : of_task;
}

}  // namespace trocar::trial
