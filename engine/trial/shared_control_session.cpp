#include "engine/trial/shared_control_session.h"

#include <atomic>
#include <utility>

#include "engine/core/spsc_queue.h"
#include "engine/trial/arm_drive.h"
#include "engine/trial/guarded_arm.h"
#include "engine/trial/sampling.h"
#include "engine/trial/segment_agents.h"
#include "engine/trial/simulated_arm.h"
#include "engine/trial/task.h"
#include "engine/trial/trial_people.h"
#include "engine/trial/trial_recorder.h"
#include "engine/trial/trial_setup.h"

namespace trocar::trial {
namespace {

using control::ControlState;
using control::ToolCommand;
using demonstration::Authority;
using demonstration::kTicksPerSample;
using demonstration::Outcome;
using demonstration::Segment;
using kinematics::ArmSide;

constexpr Tick kRecordedAfterwards{1000};
constexpr double kMillisecond_s = 1e-3;

Authority authority_in(ControlState state, Segment segment) {
  switch (state) {
    case ControlState::kAgent:
      return Authority::kAgent;
    case ControlState::kHold:
    case ControlState::kStopped:
      return Authority::kHold;
    default:
      return segment == Segment::kE ? Authority::kAssistant : Authority::kOperator;
  }
}

}  // namespace

struct SharedControlSession::Impl {
  Impl(TrialOptions options_in, const TrialInputs& inputs)
      : options(std::move(options_in)),
        world(world_options(options)),
        provenance(provenance_of(options, world.options(), inputs)),
        recorder(world.snapshot().bytes),
        task(options.block, options.goal),
        arms{SimulatedArm(world, ArmSide::kLeft), SimulatedArm(world, ArmSide::kRight)},
        left(arms[0], guard_settings(), options.scale),
        right(arms[1], guard_settings(), kAssistantScale),
        people(options, inputs),
        agents(options),
        from{arms[0].setpoint_cp(), arms[1].setpoint_cp()},
        to(from) {
    task.update(world.state());
    arm_both();
    record();
    mark();
  }

  Tick now() const { return world.state().tick; }
  /// Of the guards' clock, whose first tick is 1.
  Tick stamp() const { return Tick{now().count + 1}; }

  // --- Guards -----------------------------------------------------------------------------------------------------

  void arm_both() {
    for (std::size_t i = 0; i < 2; ++i) {
      control::Guard& guard = guards(i);
      guard.confirm_frame(true);
      // The scene is the simulator's own: its arms are homed, enabled and where they say.
      const Status armed = guard.arm(arms[i].feedback(), stamp());
      if (!armed) log(TrialEventKind::kGuard, armed.error().text());
      look(i, {true, false, now()});
    }
    left.guard().set_safe_set([this](const Eigen::Vector3d& p_W) { return agents.safe(task.segment(), p_W); });
  }

  control::Guard& guards(std::size_t i) { return i == 0 ? left.guard() : right.guard(); }

  /// `link`: of the operator to the left arm, of the assistant to the right one.
  void look(std::size_t i, const LinkState& link) {
    control::GuardLook look;
    look.now = stamp();
    look.feedback = arms[i].feedback();
    look.dead_man = link.present;
    look.dead_man_stamp = Tick{link.stamp.count + 1};
    look.connected = link.connected;
    look.soft_stop = stopping;
    look.agent_pedal = i == 0 && people.hand().agent_pedal;
    guards(i).look(look);
  }

  // --- Authority --------------------------------------------------------------------------------------------------

  /// In the middle of a sample the tool is not where the sample was to end.
  std::string agent_refusal() const { return agents.refusal(task.segment(), arms[0].setpoint_cp().X_WT.p); }

  bool agent_may() const {
    // Who has the arm keeps it while the guard lets it move; who asks for it must know what to do.
    if (machine.state() == ControlState::kAgent) {
      return agents.driving()->model().segment == task.segment() &&
             left.guard().state() == control::GuardState::kMoving;
    }
    return machine.agent_pedal().down && agent_refusal().empty();
  }

  void look_at_authority() {
    control::ControlLook look;
    look.now = stamp();
    look.begin = !begun;
    look.ended = task.outcome() == Outcome::kDropped || ended_by_hand || ends_at;
    look.agent_pedal = people.hand().agent_pedal;
    look.clutch_pedal = people.hand().clutch_pedal;
    look.agent_may = agent_may();
    look.fresh = left.guard().state() == control::GuardState::kMoving || !left_moves;
    look.stop = stopping;
    look.connected = people.link().connected || !left_moves;
    look.homed = arms[0].feedback().homed;
    look.armed = !disarmed(0) && !disarmed(1);
    // What disarms an arm that was armed is a fault: it is not armed again by itself (rule 9).
    look.fault = !look.armed;
    machine.look(look);
    begun = begun || machine.state() == ControlState::kOperator || machine.state() == ControlState::kClutch;
    if (machine.agent_pedal().pressed) ++presses, log(TrialEventKind::kPedal, "agent pedal down");
    if (machine.agent_pedal().released) log(TrialEventKind::kPedal, "agent pedal up");
    if (machine.clutch_pedal().pressed) log(TrialEventKind::kPedal, "clutch down");
    if (machine.clutch_pedal().released) log(TrialEventKind::kPedal, "clutch up");
    if (machine.changed()) log(TrialEventKind::kState, std::string(to_string(machine.state())));
  }

  bool disarmed(std::size_t i) const {
    return (i == 0 ? left : right).guard().state() == control::GuardState::kDisarmed;
  }

  bool operator_steers() const {
    const ControlState state = machine.state();
    return state == ControlState::kOperator || state == ControlState::kClutch;
  }

  /// Who has the arm now goes on from where it is, and as it moves.
  void hand_over() {
    if (machine.state() == ControlState::kAgent) {
      agents.begin(task.segment(), left.guard().setpoint().X_WT.p, left.guard().velocity());
      log(TrialEventKind::kAgent, "begins: " + agents.driving()->model().name);
    } else {
      agents.end();
    }
    // The clutch engages too: what the hand meant before the agent moved the tool, it means no more.
    const bool hand = machine.state() == ControlState::kOperator || machine.state() == ControlState::kClutch;
    if (hand) left.take_over(people.hand());
  }

  // --- Motion -----------------------------------------------------------------------------------------------------

  ToolCommand left_setpoint(double period_s) {
    if (!people.arrived()) return left.rest(period_s);
    if (machine.state() == ControlState::kAgent) {
      Agent& agent = *agents.driving();
      const Agent::State before = agent.state();
      const ToolCommand next = left.follow(agent, stamp(), period_s);
      if (agent.state() != before) log_agent(agent.state());
      return next;
    }
    // What was held engages anew where the tool is, as soon as the guard lets it.
    if (machine.state() == ControlState::kHold) left.take_over(people.hand());
    const bool follows = operator_steers() || machine.state() == ControlState::kHold;
    return follows ? left.follow(people.hand(), stamp(), period_s) : left.rest(period_s);
  }

  void log_agent(Agent::State state) {
    if (state == Agent::State::kArrived) log(TrialEventKind::kAgent, "arrived");
    if (state == Agent::State::kLoops) log(TrialEventKind::kAgent, "goes in circles and rests");
    if (state == Agent::State::kStuck) log(TrialEventKind::kAgent, "knows no move and rests");
  }

  /// New setpoints for what is left of the sample; the right arm's stand once they are made.
  void plan() {
    const int rest = kTicksPerSample - sub;
    const double period_s = rest * kMillisecond_s;
    if (sub == 0) from = to;
    to[0] = left_setpoint(period_s);
    if (sub == 0 || halts)
      to[1] = ended_by_hand ? right.rest(period_s) : right.follow(people.assistant_hand(), stamp(), period_s);
    span = rest;
    begun_at = sub;
    limit_hits += left.limits().any() ? 1 : 0;
    unreachable += left.refusal().empty() ? 0 : 1;
  }

  std::array<ToolCommand, 2> told() const { return {arms[0].setpoint_cp(), arms[1].setpoint_cp()}; }

  /// Between two samples somebody else takes the arm: the recording gets a sample at every tick up to this one, as
  /// interpolation to another end is not the same to the last bit.
  void cut() {
    from = told();
    recorder.keep_between();
    left.guard().cut_short(from[0]);
    if (halts) right.guard().cut_short(from[1]);
  }

  void step() {
    stopping = stop_asked.exchange(false);
    for (std::size_t i = 0; i < 2; ++i) {
      if (fault_asked[i].exchange(false)) arms[i].play(control::OperatingState::kFault);
    }
    while (std::optional<std::string> incident = incidents.pop()) log(TrialEventKind::kIncident, std::move(*incident));
    people.listen(world.state());
    if (people.joins()) left.take_over(people.hand());
    if (now().count == 0) right.take_over(people.assistant_hand());
    look(0, people.link());
    look(1, people.assistant_link());
    left_moves = left_moves || left.guard().state() == control::GuardState::kMoving;
    look_at_authority();
    halts = !ended_by_hand && (stopping || disarmed(0) || disarmed(1));
    if (halts) stopping ? end_by_stop() : end_by_fault(disarmed(0) ? 0 : 1);
    const bool cuts = machine.changed() && sub != 0;
    if (cuts) cut();
    if (machine.changed()) hand_over();
    if (cuts || sub == 0) plan();
    ++sub;
    for (std::size_t i = 0; i < 2; ++i) {
      // Both ends are within reach; a point between them that is not leaves the arm where it is, in a replay too.
      static_cast<void>(arms[i].servo_cp(between(from[i], to[i], sub - begun_at, span)));
    }
    world.step();
    count_time();
    if (sub < kTicksPerSample) {
      recorder.add_between(sample_of(told()));
      return;
    }
    sub = 0;
    finish_sample();
  }

  void end_by_stop() {
    stopped = true;
    ended_by_hand = true;
    ends_at = Tick{now().count + kRecordedAfterwards.count};
    log(TrialEventKind::kOutcome, "stopped");
  }

  void end_by_fault(std::size_t arm) {
    faulted = true;
    ended_by_hand = true;
    ends_at = Tick{now().count + kRecordedAfterwards.count};
    log(TrialEventKind::kOutcome, "fault: " + std::string(arm == 0 ? "" : "right: ") + guards(arm).reason_text());
  }

  // --- The record -------------------------------------------------------------------------------------------------

  void log(TrialEventKind kind, std::string text) { recorder.log(now(), kind, std::move(text)); }

  void count_time() {
    // E begins with success, and lasts until the block is placed.
    const bool placing = task.segment() == Segment::kE && !task.placed();
    if (outcome() != Outcome::kUnfinished && !placing) return;
    counts.segment_s[static_cast<std::size_t>(task.segment())] += kMillisecond_s;
    if (machine.state() == ControlState::kAgent) counts.agent_s += kMillisecond_s;
    if (machine.state() == ControlState::kClutch) counts.clutch_s += kMillisecond_s;
  }

  Authority authority() const {
    // With the segment the agent's time is over, at once.
    const bool over = machine.state() == ControlState::kAgent && agents.driving()->model().segment != task.segment();
    return over ? authority_in(ControlState::kOperator, task.segment()) : authority_in(machine.state(), task.segment());
  }
  Outcome outcome() const {
    if (task.outcome() != Outcome::kUnfinished) return task.outcome();
    return faulted ? Outcome::kFault : stopped ? Outcome::kAborted : Outcome::kUnfinished;
  }

  demonstration::Sample sample_of(const std::array<ToolCommand, 2>& setpoints) const {
    const SampleContext context{options.block, setpoints,     people.hand().agent_pedal, people.hand().clutch_pedal,
                                authority(),   task.segment()};
    return make_sample(world.state(), context);
  }
  void record() { recorder.add(sample_of(to)); }
  void mark() { recorder.mark(now(), world.state_hash()); }

  bool nothing_left() const { return task.outcome() == Outcome::kDropped || people.finished(task); }

  void finish_sample() {
    const Segment segment_before = task.segment();
    const Outcome outcome_before = task.outcome();
    task.update(world.state());
    if (task.segment() != segment_before) {
      log(TrialEventKind::kSegment, std::string(1, demonstration::letter(task.segment())));
      segment_begins = now();
    }
    if (task.outcome() != outcome_before) log(TrialEventKind::kOutcome, std::string(to_string(task.outcome())));
    for (std::size_t i = 0; i < 2; ++i) {
      for (control::GuardEvent& event : guards(i).take_events()) {
        recorder.log(Tick{event.at.count - 1}, TrialEventKind::kGuard, (i == 0 ? "left: " : "right: ") + event.text);
      }
    }
    record();
    const Tick tick = now();
    if (nothing_left() && !ends_at) ends_at = Tick{tick.count + kRecordedAfterwards.count};
    ended = (ends_at && tick >= *ends_at) || tick.seconds() >= options.time_limit_s;
    if (ended || tick.count % Tick::kPerSecond == 0) mark();
  }

  TrialCounts counted() const {
    TrialCounts all = counts;
    all.attempts = task.misses() + task.lifts();
    all.misses = task.misses();
    all.clutches = left.mapping().count();
    all.hand_overs = machine.hand_overs();
    all.agent_steps = agents.steps();
    all.limit_hits = limit_hits;
    all.unreachable = unreachable;
    all.delay_mean_s = people.line().mean_delay_s();
    all.delay_worst_s = people.line().worst_delay_s();
    return all;
  }

  TrialOptions options;
  simulation::World world;
  demonstration::Provenance provenance;
  TrialRecorder recorder;
  Task task;
  std::array<SimulatedArm, 2> arms;
  GuardedArm left;
  GuardedArm right;
  TrialPeople people;
  SegmentAgents agents;
  control::AuthorityMachine machine;
  std::array<ToolCommand, 2> from;
  std::array<ToolCommand, 2> to;
  int sub = 0;                 ///< Ticks of the sample that are over.
  int begun_at = 0;            ///< Where in the sample the plan began …
  int span = kTicksPerSample;  ///< … and how many ticks it is for.
  bool begun = false;
  bool left_moves = false;
  bool stopped = false;
  bool faulted = false;
  bool stopping = false;  ///< Stop is pressed, in this tick.
  bool halts = false;     ///< Both arms come to rest from this tick on, and it ends.
  bool ended_by_hand = false;
  bool ended = false;
  int presses = 0;
  std::int64_t limit_hits = 0;
  std::int64_t unreachable = 0;
  Tick segment_begins;
  std::optional<Tick> ends_at;
  TrialCounts counts;
  std::atomic<bool> stop_asked{false};
  std::array<std::atomic<bool>, 2> fault_asked{};
  SpscQueue<std::string> incidents{64};
};

Result<std::unique_ptr<SharedControlSession>> SharedControlSession::create(TrialOptions options, TrialInputs inputs) {
  TROCAR_RETURN_IF_ERROR(check(options));
  return std::unique_ptr<SharedControlSession>(
      new SharedControlSession(std::make_unique<Impl>(std::move(options), inputs)));
}

SharedControlSession::SharedControlSession(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SharedControlSession::~SharedControlSession() = default;

const TrialOptions& SharedControlSession::options() const {
  return impl_->options;
}
const demonstration::Provenance& SharedControlSession::provenance() const {
  return impl_->provenance;
}
void SharedControlSession::stop() {
  impl_->stop_asked.store(true);
}
std::string_view SharedControlSession::assistant_kind() const {
  return impl_->people.assistant_scripted() ? "scripted" : "person";
}
void SharedControlSession::play_fault(ArmSide side) {
  impl_->fault_asked[kinematics::index_of(side)].store(true);
}
void SharedControlSession::mark_incident(std::string text) {
  static_cast<void>(impl_->incidents.push(std::move(text)));
}
void SharedControlSession::step() {
  if (!impl_->ended) impl_->step();
}
bool SharedControlSession::done() const {
  return impl_->ended;
}
const simulation::WorldState& SharedControlSession::state() const {
  return impl_->world.state();
}
Segment SharedControlSession::segment() const {
  return impl_->task.segment();
}
Authority SharedControlSession::authority() const {
  return impl_->authority();
}
Outcome SharedControlSession::outcome() const {
  return impl_->outcome();
}
bool SharedControlSession::placed() const {
  return impl_->task.placed();
}
std::optional<std::string> SharedControlSession::take_initial_world() {
  return impl_->recorder.take_initial_world();
}
std::vector<demonstration::Sample> SharedControlSession::take_samples() {
  return impl_->recorder.take_samples();
}
std::vector<demonstration::HashMark> SharedControlSession::take_marks() {
  return impl_->recorder.take_marks();
}
std::vector<TrialEvent> SharedControlSession::take_events() {
  return impl_->recorder.take_events();
}
std::optional<double> SharedControlSession::completion_s() const {
  return outcome() == Outcome::kSuccess ? decided_s() : std::nullopt;
}
std::optional<double> SharedControlSession::decided_s() const {
  const auto at = impl_->task.decided_at();
  if (!at) return std::nullopt;
  return at->seconds();
}

std::optional<TrialStatus> SharedControlSession::trial_status() const {
  const Impl& impl = *impl_;
  TrialStatus status;
  status.state = impl.machine.state();
  status.agent_pedal = impl.people.hand().agent_pedal;
  status.clutch_pedal = impl.people.hand().clutch_pedal;
  status.agent_presses = impl.presses;
  status.pedal_stuck = impl.machine.agent_pedal_stuck();
  const Agent* agent = impl.agents.driving();
  if (agent != nullptr) status.agent = agent->state();
  if (agent == nullptr) status.agent_refusal = impl.agent_refusal();
  const control::Guard& guard = impl.left.guard();
  if (guard.state() != control::GuardState::kMoving) status.guard = guard.reason_text();
  status.tool_speed_m_s = guard.velocity().norm();
  const simulation::WorldState& state = impl.world.state();
  const Eigen::Vector3d& tip = state.arm(ArmSide::kLeft).X_WT.p;
  status.to_block_m = (tip - state.blocks[static_cast<std::size_t>(impl.options.block)].X_WK.p).norm();
  status.error_m = (tip - guard.setpoint().X_WT.p).norm();
  status.delay_s = impl.people.line().last_delay_s();
  status.segment_s = Tick{impl.now().count - impl.segment_begins.count}.seconds();
  status.counts = impl.counted();
  return status;
}

}  // namespace trocar::trial
