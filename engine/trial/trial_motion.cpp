#include "engine/trial/trial_motion.h"

#include <utility>

#include "engine/trial/arm_drive.h"
#include "engine/trial/shared_control_session.h"

namespace trocar::trial {

using control::ControlState;
using control::ToolCommand;
using demonstration::kTicksPerSample;
using demonstration::Segment;
using kinematics::ArmSide;

TrialMotion::TrialMotion(simulation::World& world, const TrialOptions& options, TrialRecorder& recorder)
    : world_(&world),
      recorder_(&recorder),
      arms_{SimulatedArm(world, ArmSide::kLeft), SimulatedArm(world, ArmSide::kRight)},
      left_(arms_[0], guard_settings(), options.scale),
      right_(arms_[1], guard_settings(), kAssistantScale),
      agents_(options),
      from_(told()),
      to_(from_) {
  for (std::size_t i = 0; i < 2; ++i) arm(i);
  left_.guard().set_safe_set([this](const Eigen::Vector3d& p_W) { return agents_.safe(segment_, p_W); });
}

// --- Guards -------------------------------------------------------------------------------------------------------

void TrialMotion::arm(std::size_t i) {
  control::Guard& guard = guarded(i).guard();
  guard.confirm_frame(true);
  // The scene is the simulator's own: its arms are homed, enabled and where they say.
  const Status armed = guard.arm(arms_[i].feedback(), stamp());
  if (!armed) recorder_->log(now(), TrialEventKind::kGuard, armed.error().text());
  show(i, {}, {true, false, now()});
}

void TrialMotion::show(std::size_t i, control::GuardLook look, const LinkState& link) {
  look.now = stamp();
  look.feedback = arms_[i].feedback();
  look.dead_man = link.present;
  look.dead_man_stamp = Tick{link.stamp.count + 1};
  look.connected = link.connected;
  guarded(i).guard().look(look);
}

void TrialMotion::look(const TrialPeople& people, bool stop) {
  // Whose first hand arrives means by it where the tool is.
  if (people.joins()) left_.take_over(people.hand());
  if (now().count == 0) right_.take_over(people.assistant_hand());
  control::GuardLook look;
  look.soft_stop = stop;
  look.agent_pedal = people.hand().agent_pedal;
  show(0, look, people.link());
  look.agent_pedal = false;
  show(1, look, people.assistant_link());
}

const control::Guard& TrialMotion::guard(ArmSide side) const {
  return (side == ArmSide::kLeft ? left_ : right_).guard();
}

void TrialMotion::log_guards() {
  for (std::size_t i = 0; i < 2; ++i) {
    for (const control::GuardEvent& event : guarded(i).guard().take_events()) {
      recorder_->log(Tick{event.at.count - 1}, TrialEventKind::kGuard, (i == 0 ? "left: " : "right: ") + event.text);
    }
  }
}

// --- From who has the arm to setpoints ----------------------------------------------------------------------------

std::string TrialMotion::agent_refusal(Segment segment) const {
  // In the middle of a sample that is not where the sample was to end.
  return agents_.refusal(segment, arms_[0].setpoint_cp().X_WT.p);
}

/// Who has the arm now goes on from where it is, and as it moves.
void TrialMotion::hand_over(const TrialAuthority& authority, const HandSample& hand) {
  if (authority.agent_has()) {
    agents_.begin(segment_, left_.guard().setpoint().X_WT.p, left_.guard().velocity());
    recorder_->log(now(), TrialEventKind::kAgent, "begins: " + agents_.driving()->model().name);
  } else {
    agents_.end();
  }
  // The clutch engages too: what the hand meant before the agent moved the tool, it means no more.
  if (authority.operator_has()) left_.take_over(hand);
}

ToolCommand TrialMotion::left_setpoint(const TrialAuthority& authority, const TrialPeople& people, double period_s) {
  if (!people.arrived()) return left_.rest(period_s);
  if (authority.agent_has()) {
    Agent& agent = *agents_.driving();
    const Agent::State before = agent.state();
    ToolCommand next = left_.follow(agent, stamp(), period_s);
    if (agent.state() != before) log_agent(agent.state());
    return next;
  }
  const bool held = authority.state() == ControlState::kHold;
  // What was held engages anew where the tool is, as soon as the guard lets it.
  if (held) left_.take_over(people.hand());
  const bool follows = authority.operator_has() || held;
  return follows ? left_.follow(people.hand(), stamp(), period_s) : left_.rest(period_s);
}

void TrialMotion::log_agent(Agent::State state) {
  const auto log = [&](std::string text) { recorder_->log(now(), TrialEventKind::kAgent, std::move(text)); };
  if (state == Agent::State::kArrived) log("arrived");
  if (state == Agent::State::kLoops) log("goes in circles and rests");
  if (state == Agent::State::kStuck) log("knows no move and rests");
}

/// New setpoints for what is left of the sample; the right arm's stand once they are made, unless it halts.
void TrialMotion::plan(const TrialAuthority& authority, const TrialPeople& people) {
  constexpr double kMillisecond_s = 1e-3;
  const bool whole = sub() == 0;
  const int rest = kTicksPerSample - sub();
  const double period_s = rest * kMillisecond_s;
  if (whole) from_ = to_;
  to_[0] = left_setpoint(authority, people, period_s);
  if (whole || authority.halts()) {
    to_[1] = authority.broken_off() ? right_.rest(period_s) : right_.follow(people.assistant_hand(), stamp(), period_s);
  }
  span_ = rest;
  begun_at_ = sub();
  limit_hits_ += left_.limits().any() ? 1 : 0;
  unreachable_ += left_.refusal().empty() ? 0 : 1;
}

// --- From setpoints to commands -----------------------------------------------------------------------------------

/// Between two samples somebody else takes the arm: the recording gets a sample at every tick up to this one, as
/// interpolation to another end is not the same to the last bit.
void TrialMotion::cut(bool both) {
  from_ = told();
  recorder_->keep_between();
  left_.guard().cut_short(from_[0]);
  if (both) right_.guard().cut_short(from_[1]);
}

void TrialMotion::advance(const TrialAuthority& authority, const TrialPeople& people, Segment segment) {
  segment_ = segment;
  const bool cuts = authority.changed() && sub() != 0;
  if (cuts) cut(authority.halts());
  if (authority.changed()) hand_over(authority, people.hand());
  if (cuts || sub() == 0) plan(authority, people);
  for (std::size_t i = 0; i < 2; ++i) {
    // Both ends are within reach; a point between them that is not leaves the arm where it is, in a replay too.
    static_cast<void>(arms_[i].servo_cp(between(from_[i], to_[i], sub() + 1 - begun_at_, span_)));
  }
}

void TrialMotion::count(TrialCounts& counts) const {
  counts.clutches = left_.mapping().count();
  counts.agent_steps = agents_.steps();
  counts.limit_hits = limit_hits_;
  counts.unreachable = unreachable_;
}

}  // namespace trocar::trial
