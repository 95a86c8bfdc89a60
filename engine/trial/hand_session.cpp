#include "engine/trial/hand_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "engine/core/check.h"
#include "engine/core/spsc_queue.h"
#include "engine/trial/arm_drive.h"
#include "engine/trial/hand_provenance.h"
#include "engine/trial/pre_roll.h"
#include "engine/trial/sampling.h"
#include "engine/trial/scripted_assistant.h"
#include "engine/trial/scripted_user.h"
#include "engine/trial/segment_world.h"
#include "engine/trial/skill.h"
#include "engine/trial/task.h"
#include "engine/trial/tool_hand.h"

namespace trocar::trial {
namespace {

using control::ToolCommand;
using demonstration::kTicksPerSample;
using kinematics::ArmSide;
using kinematics::index_of;

constexpr std::size_t kWaitingEvents = 1024;
/// So many samples of the lead-in are one step, about 4 ms of computing.
constexpr int kLeadInPerStep = 25;

/// Nobody has to be led there.
bool near(const ToolCommand& a, const ToolCommand& b) {
  return (a.X_WT.p - b.X_WT.p).norm() < 1e-6 && spatial::angle_between(a.X_WT.q, b.X_WT.q) < 1e-6 &&
         std::abs(a.jaw_rad - b.jaw_rad) < 1e-6;
}

simulation::WorldOptions world_options(const HandOptions& options) {
  simulation::WorldOptions world;
  world.seed = options.seed;
  return world;
}

}  // namespace

struct HandSession::Impl {
  Impl(HandOptions options_in, simulation::World world_in)
      : options(std::move(options_in)),
        world(std::move(world_in)),
        provenance(provenance_of(options, world.options())),
        task(options.block, options.goal),
        from(commands_now()),
        to(from) {
    const Random random = Random(options.seed).child(0);
    const auto assignment = [this](Skill skill) {
      return Assignment{options.block, options.goal, parameters(skill), std::string(trial::to_string(skill))};
    };
    if (options.sources[0] == ArmSource::kScripted) {
      scripted[0] = std::make_unique<ScriptedUser>(assignment(options.skill), random.child(1));
    }
    if (options.sources[1] == ArmSource::kScripted) {
      scripted[1] = std::make_unique<ScriptedAssistant>(assignment(options.skill), random.child(2));
    }
    if (options.begin_segment) {
      TransferOptions transfer;
      transfer.seed = options.seed;
      transfer.block = options.block;
      transfer.goal = options.goal;
      // The options of the take were checked, which are those of the transfer.
      approach = std::make_unique<SegmentApproach>(SegmentApproach::create(*options.begin_segment, transfer).value());
    } else if (options.lead_in.empty()) {
      get_ready();
    }
  }

  std::array<ToolCommand, 2> commands_now() const {
    return {setpoint_of(world.state(), ArmSide::kLeft), setpoint_of(world.state(), ArmSide::kRight)};
  }

  /// One tick of the way from the last setpoints to the next.
  void move(int sub) {
    for (const ArmSide side : kinematics::kArmSides) {
      const std::size_t i = index_of(side);
      const ToolCommand command = between(from[i], to[i], sub, kTicksPerSample);
      // Both ends are within reach; a point between them that is not leaves the arm where it is, in a replay too.
      static_cast<void>(world.command(side, {command.X_WT, command.jaw_rad}));
    }
    world.step();
  }

  /// By a scripted expert, to where the segment begins. What never comes there is no take.
  void approach_segment() {
    approach->step(kLeadInPerStep * kTicksPerSample);
    if (approach->failed()) phase = Phase::kEnded;
    if (!approach->there()) return;
    const Status restored = world.restore({approach->world()});
    TROCAR_CHECK(restored.has_value());
    approach.reset();
    get_ready();
  }

  void lead_in() {
    if (approach) return approach_segment();
    for (int i = 0; i < kLeadInPerStep && lead_next < options.lead_in.size(); ++i, ++lead_next) {
      from = to;
      to = options.lead_in[lead_next];
      for (int sub = 1; sub <= kTicksPerSample; ++sub) move(sub);
      task.update(world.state());
    }
    if (lead_next == options.lead_in.size()) get_ready();
  }

  /// The arms are where the lead-in left them, and are driven from there.
  void get_ready() {
    phase = Phase::kCountdown;
    from = to = commands_now();
    for (const ArmSide side : kinematics::kArmSides) {
      const std::size_t i = index_of(side);
      drives.emplace_back(side, to[i]);
      const bool by_hand = options.sources[i] == ArmSource::kHand;
      hands.emplace_back(by_hand ? options.mode : HandMode::kContinuous, to[i]);
      if (!options.replay.empty() && !near(to[i], options.replay.front()[i]))
        hands[i].lead_to(options.replay.front()[i]);
      if (options.begin_p_WT[i]) {
        ToolCommand begin = to[i];
        begin.X_WT.p = *options.begin_p_WT[i];
        hands[i].lead_to(begin);
      }
    }
    task.update(world.state());
    countdown_ticks = static_cast<std::int64_t>(std::llround(options.countdown_s * Tick::kPerSecond));
    look_at_countdown();
  }

  // --- What the operator does -------------------------------------------------------------------------------------

  ToolHand* hand_of(ArmSide side) {
    const std::size_t i = index_of(side);
    return options.sources[i] == ArmSource::kHand && !hands.empty() ? &hands[i] : nullptr;
  }

  void on(const DriveTool& event) {
    if (ToolHand* hand = hand_of(event.arm)) hand->drive(event.v_WT, event.w_WT_T);
  }
  void on(const StepTool& event) {
    if (ToolHand* hand = hand_of(event.arm)) hand->step(event.cells);
  }
  void on(const ShiftTool& event) {
    if (ToolHand* hand = hand_of(event.arm)) hand->shift(event.by_W_m);
  }
  void on(const PlaceTool& event) {
    if (ToolHand* hand = hand_of(event.arm)) hand->place(event.X_WT);
  }
  void on(const ToggleJaw& event) {
    if (ToolHand* hand = hand_of(event.arm)) hand->toggle_jaw();
  }
  void on(const HoldClutch& event) {
    clutch = event.down;
    for (const ArmSide side : kinematics::kArmSides) {
      if (ToolHand* hand = hand_of(side)) hand->hold_clutch(event.down);
    }
  }
  void on(const GoToWaypoint&) {
    for (const ArmSide side : kinematics::kArmSides) {
      if (ToolHand* hand = hand_of(side)) hand->go();
    }
  }
  void on(const PauseTake& event) {
    if (phase == Phase::kRecording && event.paused) {
      phase = Phase::kPaused;
      paused_ms = 0;
    } else if (phase == Phase::kPaused && !event.paused) {
      phase = Phase::kRecording;
      const double seconds = static_cast<double>(paused_ms) / Tick::kPerSecond;
      notes.push_back({world.state().tick.count, fmt::format("Paused for {:.1f} s", seconds)});
    }
  }
  void on(const BeginTake&) {
    if (phase == Phase::kCountdown) countdown_ticks = 0;
  }
  void on(const EndTake&) { end(); }

  /// At a sample, or while nothing moves.
  void take_events() {
    while (const std::optional<HandEvent> event = events.pop()) {
      std::visit([this](const auto& known) { on(known); }, *event);
    }
  }

  // --- The take ---------------------------------------------------------------------------------------------------

  bool recording() const { return phase == Phase::kRecording; }

  void look_at_countdown() {
    const auto is_led = [](const ToolHand& hand) { return hand.under_way(); };
    if (countdown_ticks > 0 || std::any_of(hands.begin(), hands.end(), is_led)) return;
    phase = Phase::kRecording;
    if (pre_roll.seconds() > 0.0) {
      PreRoll::Kept kept = pre_roll.take();
      initial_world = std::move(kept.initial_world);
      begun_at = kept.samples.front().tick;
      samples = std::move(kept.samples);
      marks = std::move(kept.marks);
      marks_at = marks.back().tick;
      return;
    }
    initial_world = world.snapshot().bytes;
    begun_at = world.state().tick.count;
    samples.push_back(sample_now());
    mark();
  }

  demonstration::Sample sample_now() const {
    return make_sample(world.state(), {options.block, to, false, clutch, authority(), task.segment()});
  }

  demonstration::Authority authority() const {
    const bool assistant = task.segment() == demonstration::Segment::kE;
    return assistant ? demonstration::Authority::kAssistant : demonstration::Authority::kOperator;
  }

  void mark() {
    const std::int64_t tick = world.state().tick.count;
    if (marks_at != tick) marks.push_back({tick, world.state_hash()});
    marks_at = tick;
  }

  void end() {
    if (begun_at) mark();
    phase = Phase::kEnded;
  }

  ToolCommand next_setpoint(std::size_t i) {
    const bool plays = options.sources[i] == ArmSource::kScripted || options.sources[i] == ArmSource::kReplay;
    if (plays && recording()) {
      if (scripted[i]) return drives[i].advance(scripted[i]->sample(world.state()), world.state().tick);
      const std::size_t at = std::min(replay_next, options.replay.size() - 1);
      return drives[i].approach(options.replay[at][i]);
    }
    const ToolCommand setpoint = drives[i].approach(hands[i].next());
    if (!drives[i].refusal().empty()) hands[i].stay_at(setpoint);
    return setpoint;
  }

  void plan() {
    if (recording()) ++replay_next;
    for (std::size_t i = 0; i < 2; ++i) {
      from[i] = to[i];
      to[i] = next_setpoint(i);
      if (!recording()) continue;
      limited[i] += drives[i].limits().any() || hands[i].at_floor() ? 1 : 0;
      refused[i] += drives[i].refusal().empty() ? 0 : 1;
    }
  }

  void step() {
    if (phase == Phase::kLeadIn) {
      take_events();
      return phase == Phase::kEnded ? void() : lead_in();
    }
    if (sub_tick == 0) {
      take_events();
      if (phase == Phase::kEnded) return;
      if (phase == Phase::kPaused) {
        ++paused_ms;
        return;
      }
      plan();
    }
    move(++sub_tick);
    if (phase == Phase::kCountdown && countdown_ticks > 0) --countdown_ticks;
    if (sub_tick < kTicksPerSample) return;
    sub_tick = 0;
    finish_sample();
  }

  void finish_sample() {
    task.update(world.state());
    if (phase == Phase::kCountdown) {
      if (options.pre_roll) pre_roll.add(sample_now(), world);
      return look_at_countdown();
    }
    samples.push_back(sample_now());
    const std::int64_t tick = world.state().tick.count;
    if (tick % Tick::kPerSecond == 0) mark();
    if (Tick{tick - *begun_at}.seconds() >= options.time_limit_s) end();
  }

  SessionStatus status() const {
    SessionStatus status;
    status.phase = phase;
    status.countdown_s = Tick{std::max<std::int64_t>(countdown_ticks, 0)}.seconds();
    status.pre_roll_s = pre_roll.seconds();
    status.clutch = clutch;
    status.dropped_input = dropped.load(std::memory_order_relaxed);
    for (std::size_t i = 0; i < hands.size(); ++i) {
      status.arms[i] = {drives[i].limits().any() || hands[i].at_floor(), drives[i].refusal(), limited[i], refused[i],
                        hands[i].waypoint()};
    }
    return status;
  }

  HandOptions options;
  simulation::World world;
  demonstration::Provenance provenance;
  Task task;
  std::array<std::unique_ptr<ScriptedOperator>, 2> scripted;
  std::vector<ArmDrive> drives;  ///< One for each arm once the lead-in is over; likewise `hands`.
  std::vector<ToolHand> hands;
  std::array<ToolCommand, 2> from;
  std::array<ToolCommand, 2> to;
  Phase phase = Phase::kLeadIn;
  std::unique_ptr<SegmentApproach> approach;
  std::size_t lead_next = 0;
  std::size_t replay_next = 0;
  int sub_tick = 0;  ///< Of the sample that is under way.
  std::int64_t countdown_ticks = 0;
  std::int64_t paused_ms = 0;
  bool clutch = false;
  PreRoll pre_roll;
  std::optional<std::int64_t> begun_at;
  std::array<std::int64_t, 2> limited{};
  std::array<std::int64_t, 2> refused{};
  std::optional<std::string> initial_world;
  std::vector<demonstration::Sample> samples;
  std::vector<demonstration::HashMark> marks;
  std::optional<std::int64_t> marks_at;
  std::vector<TakeNote> notes;
  SpscQueue<HandEvent> events{kWaitingEvents};
  std::atomic<std::int64_t> dropped{0};
};

Result<std::unique_ptr<HandSession>> HandSession::create(HandOptions options) {
  TROCAR_RETURN_IF_ERROR(check(options));
  simulation::World world(world_options(options));
  if (!options.initial_world.empty()) {
    if (Status restored = world.restore({options.initial_world}); !restored) {
      return tl::unexpected(std::move(restored).error().in("restore the world in which the take begins"));
    }
  }
  auto impl = std::make_unique<Impl>(std::move(options), std::move(world));
  return std::unique_ptr<HandSession>(new HandSession(std::move(impl)));
}

HandSession::HandSession(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
HandSession::~HandSession() = default;

bool HandSession::post(const HandEvent& event) {
  if (impl_->events.push(HandEvent(event))) return true;
  impl_->dropped.fetch_add(1, std::memory_order_relaxed);
  return false;
}

const demonstration::Provenance& HandSession::provenance() const {
  return impl_->provenance;
}
const HandOptions& HandSession::options() const {
  return impl_->options;
}

void HandSession::step() {
  if (impl_->phase != Phase::kEnded) impl_->step();
}

bool HandSession::done() const {
  return impl_->phase == Phase::kEnded;
}
const simulation::WorldState& HandSession::state() const {
  return impl_->world.state();
}
demonstration::Segment HandSession::segment() const {
  return impl_->task.segment();
}
demonstration::Authority HandSession::authority() const {
  return impl_->authority();
}
demonstration::Outcome HandSession::outcome() const {
  return impl_->task.outcome();
}
bool HandSession::placed() const {
  return impl_->task.placed();
}
SessionStatus HandSession::status() const {
  return impl_->status();
}
std::optional<std::string> HandSession::take_initial_world() {
  return std::exchange(impl_->initial_world, std::nullopt);
}
std::vector<demonstration::Sample> HandSession::take_samples() {
  return std::exchange(impl_->samples, {});
}
std::vector<demonstration::HashMark> HandSession::take_marks() {
  return std::exchange(impl_->marks, {});
}
std::vector<TakeNote> HandSession::take_notes() {
  return std::exchange(impl_->notes, {});
}

}  // namespace trocar::trial
