#include <algorithm>

#include "engine/trial/arm_drive.h"
#include "engine/trial/sampling.h"
#include "engine/trial/task.h"
#include "engine/trial/transfer_session.h"

namespace trocar::trial {
namespace {

using demonstration::RecordingInfo;
using demonstration::Sample;

Status check(const RecordingInfo& recording, const demonstration::SampleTrack& samples) {
  if (recording.initial_world.empty()) {
    return fail(ErrorCode::kInvalidArgument, "the recording has no initial world, so it cannot be replayed");
  }
  if (recording.hashes.empty()) {
    return fail(ErrorCode::kInvalidArgument, "the recording has no state hashes to compare with");
  }
  if (samples.empty()) return fail(ErrorCode::kInvalidArgument, "the recording has no samples");
  const auto index_ok = [](int index) { return index >= 0 && index < peg_board::kBlockCount; };
  if (!index_ok(recording.provenance.block) || !index_ok(recording.provenance.goal)) {
    return fail(ErrorCode::kInvalidArgument, "the recording names a block or goal that does not exist");
  }
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (samples.tick(i) <= samples.tick(i - 1)) {
      return fail(ErrorCode::kInvalidArgument, "the recording's samples are out of order");
    }
  }
  return {};
}

/// A world that follows recorded setpoints and compares its hashes with the recorded ones.
class Replayer {
 public:
  Replayer(const RecordingInfo& recording, simulation::World world)
      : recording_(recording), world_(std::move(world)), task_(recording.provenance.block, recording.provenance.goal) {}

  /// At the first sample, before any step.
  void start() {
    task_.update(world_.state());
    compare();
  }

  void follow(const Sample& from, const Sample& to) {
    const int count = static_cast<int>(to.tick - from.tick);
    for (int sub = 1; sub <= count; ++sub) {
      for (const kinematics::ArmSide side : kinematics::kArmSides) {
        const std::size_t i = kinematics::index_of(side);
        const control::ToolCommand command =
            between(recorded_setpoint(from.arms[i]), recorded_setpoint(to.arms[i]), sub, count);
        // What the arm refused while recording it refuses again.
        static_cast<void>(world_.command(side, {command.X_WT, command.jaw_rad}));
      }
      world_.step();
      compare();
    }
    task_.update(world_.state());
  }

  ReplayResult result() const {
    ReplayResult result;
    result.diverged_at_s = diverged_at_s_;
    // Marks after the last sample cannot be checked, as in a recording cut short.
    result.verified = !diverged_at_s_ && compared_ > 0;
    result.placed = task_.placed();
    return result;
  }

 private:
  void compare() {
    const std::int64_t tick = world_.state().tick.count;
    while (next_mark_ < recording_.hashes.size() && recording_.hashes[next_mark_].tick < tick) ++next_mark_;
    if (next_mark_ == recording_.hashes.size() || recording_.hashes[next_mark_].tick != tick) return;
    ++compared_;
    if (recording_.hashes[next_mark_].hash != world_.state_hash() && !diverged_at_s_) {
      diverged_at_s_ = world_.state().tick.seconds();
    }
  }

  const RecordingInfo& recording_;
  simulation::World world_;
  Task task_;
  std::size_t next_mark_ = 0;
  int compared_ = 0;
  std::optional<double> diverged_at_s_;
};

}  // namespace

Result<ReplayResult> replay(const RecordingInfo& recording, const demonstration::SampleTrack& samples,
                            Progress& progress) {
  TROCAR_RETURN_IF_ERROR(check(recording, samples));
  simulation::WorldOptions options;
  options.seed = recording.provenance.seed;
  simulation::World world(options);
  if (Status restored = world.restore({recording.initial_world}); !restored) {
    return tl::unexpected(std::move(restored).error().in("restore the recording's initial world"));
  }
  Replayer replayer(recording, std::move(world));
  replayer.start();
  const std::size_t count = samples.size();
  for (std::size_t i = 1; i < count; ++i) {
    if (progress.cancelled()) return fail(ErrorCode::kCancelled, "the replay was stopped");
    replayer.follow(samples[i - 1], samples[i]);
    if (i % 20 == 0) progress.set(static_cast<double>(i) / static_cast<double>(count));
  }
  progress.set(1.0);
  return replayer.result();
}

}  // namespace trocar::trial
