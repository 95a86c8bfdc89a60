/// One bimanual transfer in the simulator from the first motion to the placed block, recorded as it happens.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/demonstration/sample_track.h"
#include "engine/simulation/world.h"
#include "engine/trial/live_session.h"
#include "engine/trial/operator_input.h"
#include "engine/trial/skill.h"

namespace trocar::trial {

struct TransferOptions {
  Skill skill = Skill::kExpert;
  std::uint64_t seed = 1;
  int block = 0;  ///< 0 … 5.
  int goal = 0;   ///< 0 … 5.
  double time_limit_s = 120.0;
  /// For studies of robustness: both operators misjudge every grasp by up to this along each axis of the tool, evenly,
  /// instead of by their skill; metres. Negative: by their skill.
  double aim_jitter_m = -1.0;
};

/// World, both scripted operators (the user of the given skill, the assistant always an expert), the task's segments
/// and the recorder, stepped together. Ends a moment after both have done their part, or after a drop, or at the time
/// limit. Deterministic: the same options give the same samples and hashes. Threads: one at a time.
class TransferSession final : public LiveSession {
 public:
  /// Errors: kInvalidArgument for a block or goal outside of 0 … 5, or a time limit that is not positive and finite.
  static Result<TransferSession> create(const TransferOptions& options);
  ~TransferSession() override;
  TransferSession(TransferSession&&) noexcept;
  TransferSession& operator=(TransferSession&&) noexcept;

  /// Who made it; `created` is left empty for the caller, who has the clock.
  const demonstration::Provenance& provenance() const;
  const std::string& initial_world() const;
  /// A snapshot of the world as it is now.
  std::string world() const;

  void step() override;
  bool done() const override;
  const simulation::WorldState& state() const override;
  demonstration::Segment segment() const override;
  demonstration::Authority authority() const override;
  demonstration::Outcome outcome() const override;
  bool placed() const override;

  /// Times the user's jaws closed on air.
  int misses() const;
  /// Samples at which a limit of speed, acceleration, turn or jaw was hit, or a pose was out of reach.
  std::int64_t limit_hits() const;

  /// The first tick's.
  std::optional<std::string> take_initial_world() override;
  std::vector<demonstration::Sample> take_samples() override;
  std::vector<demonstration::HashMark> take_marks() override;

 private:
  struct Impl;
  explicit TransferSession(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Re-simulates the recorded setpoints from the recorded initial world and compares the state hashes.
struct ReplayResult {
  bool verified = false;
  std::optional<double> diverged_at_s;  ///< Time of the first mark that differs.
  bool placed = false;                  ///< As found in the re-simulation.
};
/// Errors: kInvalidArgument if the recording has no initial world (imports) or no marks; kCancelled.
Result<ReplayResult> replay(const demonstration::RecordingInfo& recording, const demonstration::SampleTrack& samples,
                            Progress& progress);
inline Result<ReplayResult> replay(const demonstration::Recording& recording, Progress& progress) {
  return replay(recording, demonstration::SampleTrack(recording.samples), progress);
}

}  // namespace trocar::trial
