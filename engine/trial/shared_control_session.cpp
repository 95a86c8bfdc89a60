#include "engine/trial/shared_control_session.h"

#include <atomic>
#include <utility>

#include "engine/core/spsc_queue.h"
#include "engine/trial/sampling.h"
#include "engine/trial/task.h"
#include "engine/trial/trial_authority.h"
#include "engine/trial/trial_motion.h"
#include "engine/trial/trial_people.h"
#include "engine/trial/trial_recorder.h"
#include "engine/trial/trial_setup.h"

namespace trocar::trial {

using control::ControlState;
using control::ToolCommand;
using demonstration::Authority;
using demonstration::Outcome;
using demonstration::Segment;
using kinematics::ArmSide;

struct SharedControlSession::Impl {
  Impl(TrialOptions options_in, const TrialInputs& inputs)
      : options(std::move(options_in)),
        world(world_options(options)),
        provenance(provenance_of(options, world.options(), inputs)),
        recorder(world.snapshot().bytes),
        task(options.block, options.goal),
        people(options, inputs),
        authority(recorder, options.time_limit_s),
        motion(world, options, recorder) {
    task.update(world.state());
    record();
    mark();
  }

  Tick now() const { return world.state().tick; }

  /// One way through: what people do, who has the arm by it, how the arms move by that, and what the world makes of it.
  void step() {
    const bool stop = take_requests();
    people.listen(world.state());
    motion.look(people, stop);
    authority.look(shown(stop), motion.guard(ArmSide::kLeft), motion.guard(ArmSide::kRight));
    motion.advance(authority, people, task.segment());
    world.step();
    count_time();
    if (now().count % demonstration::kTicksPerSample == 0) {
      finish_sample();
    } else {
      recorder.add_between(sample_of(motion.told()));
    }
  }

  /// Of other threads. True if it is to stop.
  bool take_requests() {
    const bool stop = stop_asked.exchange(false);
    for (const ArmSide side : kinematics::kArmSides) {
      if (fault_asked[kinematics::index_of(side)].exchange(false)) motion.play_fault(side);
    }
    while (std::optional<std::string> incident = incidents.pop()) log(TrialEventKind::kIncident, std::move(*incident));
    return stop;
  }

  TrialLook shown(bool stop) const {
    TrialLook look;
    look.now = now();
    look.segment = task.segment();
    look.dropped = task.outcome() == Outcome::kDropped;
    look.agent_pedal = people.hand().agent_pedal;
    look.clutch_pedal = people.hand().clutch_pedal;
    look.connected = people.link().connected;
    look.homed = motion.homed(ArmSide::kLeft);
    look.agent_can_begin = motion.agent_refusal(task.segment()).empty();
    look.stop = stop;
    return look;
  }

  void finish_sample() {
    const Segment segment_before = task.segment();
    const Outcome outcome_before = task.outcome();
    task.update(world.state());
    if (task.segment() != segment_before) {
      log(TrialEventKind::kSegment, std::string(1, demonstration::letter(task.segment())));
      segment_begins = now();
    }
    if (task.outcome() != outcome_before) log(TrialEventKind::kOutcome, std::string(to_string(task.outcome())));
    motion.log_guards();
    record();
    authority.look_for_end(now(), task.outcome() == Outcome::kDropped || people.finished(task));
    if (authority.ended() || now().count % Tick::kPerSecond == 0) mark();
  }

  // --- The record -------------------------------------------------------------------------------------------------

  void log(TrialEventKind kind, std::string text) { recorder.log(now(), kind, std::move(text)); }
  void record() { recorder.add(sample_of(motion.planned())); }
  void mark() { recorder.mark(now(), world.state_hash()); }

  Outcome outcome() const { return authority.outcome(task.outcome()); }

  demonstration::Sample sample_of(const std::array<ToolCommand, 2>& setpoints) const {
    const HandSample& hand = people.hand();
    const Segment segment = task.segment();
    return make_sample(world.state(), {options.block, setpoints, hand.agent_pedal, hand.clutch_pedal,
                                       authority.owner(segment), segment});
  }

  void count_time() {
    constexpr double kMillisecond_s = 1e-3;
    // E begins with success, and lasts until the block is placed.
    const bool placing = task.segment() == Segment::kE && !task.placed();
    if (outcome() != Outcome::kUnfinished && !placing) return;
    counts.segment_s[static_cast<std::size_t>(task.segment())] += kMillisecond_s;
    if (authority.state() == ControlState::kAgent) counts.agent_s += kMillisecond_s;
    if (authority.state() == ControlState::kClutch) counts.clutch_s += kMillisecond_s;
  }

  TrialCounts counted() const {
    TrialCounts all = counts;
    all.attempts = task.misses() + task.lifts();
    all.misses = task.misses();
    all.hand_overs = authority.hand_overs();
    all.delay_mean_s = people.line().mean_delay_s();
    all.delay_worst_s = people.line().worst_delay_s();
    motion.count(all);
    return all;
  }

  TrialOptions options;
  simulation::World world;
  demonstration::Provenance provenance;
  TrialRecorder recorder;
  Task task;
  TrialPeople people;
  TrialAuthority authority;
  TrialMotion motion;
  TrialCounts counts;  ///< Times, so far.
  Tick segment_begins;
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
  if (!done()) impl_->step();
}
bool SharedControlSession::done() const {
  return impl_->authority.ended();
}
const simulation::WorldState& SharedControlSession::state() const {
  return impl_->world.state();
}
Segment SharedControlSession::segment() const {
  return impl_->task.segment();
}
Authority SharedControlSession::authority() const {
  return impl_->authority.owner(segment());
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
  const HandSample& hand = impl.people.hand();
  TrialStatus status;
  status.state = impl.authority.state();
  status.agent_pedal = hand.agent_pedal;
  status.clutch_pedal = hand.clutch_pedal;
  status.agent_presses = impl.authority.agent_presses();
  status.pedal_stuck = impl.authority.agent_pedal_stuck();
  const Agent* agent = impl.motion.agent();
  if (agent != nullptr) status.agent = agent->state();
  if (agent == nullptr) status.agent_refusal = impl.motion.agent_refusal(impl.task.segment());
  const control::Guard& guard = impl.motion.guard(ArmSide::kLeft);
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
