#include "engine/trial/transfer_session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/trial/arm_drive.h"
#include "engine/trial/provenance.h"
#include "engine/trial/sampling.h"
#include "engine/trial/scripted_assistant.h"
#include "engine/trial/scripted_user.h"
#include "engine/trial/task.h"

namespace trocar::trial {
namespace {

using demonstration::Authority;
using demonstration::kTicksPerSample;
using demonstration::Outcome;
using demonstration::Segment;
using kinematics::ArmSide;

constexpr Tick kTail{1000};  ///< Recorded after everything is done.

demonstration::Provenance provenance_of(const TransferOptions& options, const simulation::WorldOptions& world) {
  demonstration::Provenance provenance = provenance_on(world, options.seed, options.block, options.goal);
  provenance.operator_kind = "scripted";
  provenance.skill = to_string(options.skill);
  provenance.device = "scripted hand";
  return provenance;
}

Assignment assignment_of(const TransferOptions& options, Skill skill) {
  return {options.block, options.goal, parameters(skill), std::string(to_string(skill)), options.aim_jitter_m};
}

simulation::WorldOptions world_options(const TransferOptions& options) {
  simulation::WorldOptions world;
  world.seed = options.seed;
  return world;
}

}  // namespace

struct TransferSession::Impl {
  Impl(const TransferOptions& options_in, const Random& random)
      : options(options_in),
        world(world_options(options)),
        provenance(provenance_of(options, world.options())),
        initial_world(world.snapshot().bytes),
        task(options.block, options.goal),
        user(assignment_of(options, options.skill), random.child(1)),
        assistant(assignment_of(options, Skill::kExpert), random.child(2)),
        drives{ArmDrive(ArmSide::kLeft, setpoint_of(world.state(), ArmSide::kLeft)),
               ArmDrive(ArmSide::kRight, setpoint_of(world.state(), ArmSide::kRight))},
        from{drives[0].setpoint(), drives[1].setpoint()},
        to(from) {
    task.update(world.state());
    record();
    mark();
  }

  /// Asks both operators for the setpoints of the next sample.
  void plan() {
    const simulation::WorldState& state = world.state();
    hands = {user.sample(state), assistant.sample(state)};
    for (std::size_t i = 0; i < 2; ++i) {
      from[i] = to[i];
      to[i] = drives[i].advance(hands[i], state.tick);
    }
  }

  void record() {
    const SampleContext context{options.block,         to,          hands[0].agent_pedal,
                                hands[0].clutch_pedal, authority(), task.segment()};
    samples.push_back(make_sample(world.state(), context));
  }

  void mark() { marks.push_back({world.state().tick.count, world.state_hash()}); }

  Authority authority() const { return task.segment() == Segment::kE ? Authority::kAssistant : Authority::kOperator; }

  bool nothing_left() const {
    if (task.outcome() == Outcome::kDropped) return true;
    return user.finished() && assistant.finished();
  }

  void look_for_the_end() {
    const Tick now = world.state().tick;
    if (nothing_left() && !ends_at) ends_at = Tick{now.count + kTail.count};
    ended = (ends_at && now >= *ends_at) || now.seconds() >= options.time_limit_s;
  }

  void step() {
    const int sub = static_cast<int>(world.state().tick.count % kTicksPerSample) + 1;
    if (sub == 1) plan();
    for (const ArmSide side : kinematics::kArmSides) {
      const std::size_t i = kinematics::index_of(side);
      const control::ToolCommand command = between(from[i], to[i], sub, kTicksPerSample);
      // Both ends are within reach; a point between them that is not leaves the arm where it is, in a replay too.
      static_cast<void>(world.command(side, {command.X_WT, command.jaw_rad}));
    }
    world.step();
    if (sub < kTicksPerSample) return;
    task.update(world.state());
    record();
    look_for_the_end();
    if (ended || world.state().tick.count % Tick::kPerSecond == 0) mark();
  }

  TransferOptions options;
  simulation::World world;
  demonstration::Provenance provenance;
  std::string initial_world;
  bool initial_world_taken = false;
  Task task;
  ScriptedUser user;
  ScriptedAssistant assistant;
  std::array<ArmDrive, 2> drives;
  std::array<control::ToolCommand, 2> from;
  std::array<control::ToolCommand, 2> to;
  std::array<HandSample, 2> hands;
  std::vector<demonstration::Sample> samples;
  std::vector<demonstration::HashMark> marks;
  std::optional<Tick> ends_at;
  bool ended = false;
};

Result<TransferSession> TransferSession::create(const TransferOptions& options) {
  const auto exists = [](int index) { return index >= 0 && index < peg_board::kBlockCount; };
  if (!exists(options.block)) return fail(ErrorCode::kInvalidArgument, "the block is a number from 0 to 5");
  if (!exists(options.goal)) return fail(ErrorCode::kInvalidArgument, "the goal is a number from 0 to 5");
  if (!std::isfinite(options.time_limit_s) || options.time_limit_s <= 0.0) {
    return fail(ErrorCode::kInvalidArgument, "the time limit is not positive");
  }
  return TransferSession(std::make_unique<Impl>(options, Random(options.seed).child(0)));
}

TransferSession::TransferSession(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
TransferSession::~TransferSession() = default;
TransferSession::TransferSession(TransferSession&&) noexcept = default;
TransferSession& TransferSession::operator=(TransferSession&&) noexcept = default;

const demonstration::Provenance& TransferSession::provenance() const {
  return impl_->provenance;
}
const std::string& TransferSession::initial_world() const {
  return impl_->initial_world;
}
std::string TransferSession::world() const {
  return impl_->world.snapshot().bytes;
}
std::optional<std::string> TransferSession::take_initial_world() {
  if (std::exchange(impl_->initial_world_taken, true)) return std::nullopt;
  return impl_->initial_world;
}

void TransferSession::step() {
  if (!impl_->ended) impl_->step();
}

bool TransferSession::done() const {
  return impl_->ended;
}
const simulation::WorldState& TransferSession::state() const {
  return impl_->world.state();
}
Segment TransferSession::segment() const {
  return impl_->task.segment();
}
Authority TransferSession::authority() const {
  return impl_->authority();
}
Outcome TransferSession::outcome() const {
  return impl_->task.outcome();
}
bool TransferSession::placed() const {
  return impl_->task.placed();
}
int TransferSession::misses() const {
  return impl_->task.misses();
}

std::int64_t TransferSession::limit_hits() const {
  std::int64_t hits = 0;
  for (const ArmDrive& drive : impl_->drives) hits += drive.limit_hits() + drive.unreachable();
  return hits;
}

std::vector<demonstration::Sample> TransferSession::take_samples() {
  return std::exchange(impl_->samples, {});
}
std::vector<demonstration::HashMark> TransferSession::take_marks() {
  return std::exchange(impl_->marks, {});
}

}  // namespace trocar::trial
