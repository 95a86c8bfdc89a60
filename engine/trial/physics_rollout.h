/// The agent's policy in the simulator: from a start the left tool goes cell by cell, with its limits, reach and
/// contacts.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/demonstration/recording.h"
#include "engine/learning/model.h"
#include "engine/simulation/world_state.h"

namespace trocar::trial {

/// What makes the agent's world less than ideal. It moves to the middle of the neighbour of the cell in which it reads
/// itself to be, wherever it is, in the time of a cell; where it reads itself to be at the goal it rests as long and
/// looks again. With any of this a cell that is come by again is no loop: such rollouts arrive, or end with their time.
struct Perturbation {
  double epsilon =
      0.0;  ///< 0 … 1: this share of the actions is drawn evenly from those that lattice and safe set allow.
  double delay_s = 0.0;  ///< 0 … 5: the policy is asked for where the tool was so long ago.
  double noise_m = 0.0;  ///< 0 … 0.05: standard deviation, on each axis, of where the tool is taken to be.
  bool operator==(const Perturbation&) const = default;
};

struct PhysicsOptions {
  std::uint64_t seed = 1;  ///< Of the blocks' yaw, of where in its cell a start lies, and of what is perturbed.
  /// What the model was learned from. In C the tool carries `block`, which a scripted expert has taken, and a rollout
  /// that loses it has ended.
  demonstration::Segment segment = demonstration::Segment::kA;
  int block = 0;  ///< 0 … 5, likewise `goal`; of C.
  int goal = 0;
  Perturbation perturbed;
  bool continuous = false;  ///< The start is anywhere in its cell, evenly; else its middle.
  double time_limit_s = 60.0;
  int threads = 2;  ///< 1 … 64; the result does not depend on it.
};
/// Whether rollouts of one are those of the other.
bool same_runs(const PhysicsOptions& a, const PhysicsOptions& b);

enum class PhysicsEnd : std::uint8_t { kArrives, kLoops, kDeadEnd, kOutsideSafeSet, kOutOfReach, kTimeUp, kDrops };
constexpr int kPhysicsEnds = 7;
std::string_view to_string(PhysicsEnd end);

/// From when the tool has been led to the start.
struct PhysicsRollout {
  PhysicsEnd end = PhysicsEnd::kDeadEnd;
  int steps = 0;          ///< Moves that the policy led to.
  int outside_steps = 0;  ///< Of these, that ended outside of the safe set: the agent read itself to be elsewhere.
  double duration_s = 0.0;
  double length_m = 0.0;         ///< Of the tip's way.
  double pushed_m = 0.0;         ///< By how much the block that moved most was moved; the carried one is left out.
  std::uint64_t state_hash = 0;  ///< Of the world at the end.
  bool operator==(const PhysicsRollout&) const = default;
};

using RolloutWatcher = std::function<void(const simulation::WorldState&)>;

/// In a world of its own, led to the start from above with closed jaws. The policy is asked for the cell that the tool
/// is measured in; a cell is 1/8 s. The same on every thread. `world` is where it begins, of `segment_world`; "": a new
/// one. Precondition: it is a snapshot of this version.
/// `watch` sees it at 200 Hz from the start on, and for half a second after its end, of which the result knows nothing.
PhysicsRollout physics_rollout(const learning::Model& model, const std::vector<std::uint8_t>& policy,
                               spatial::CellIndex start, const PhysicsOptions& options, const std::string& world = "",
                               const RolloutWatcher& watch = {});

/// One for each start, nothing where none was run yet.
using PhysicsRollouts = std::vector<std::optional<PhysicsRollout>>;
int finished(const PhysicsRollouts& rollouts);

/// Runs those that are still missing in `rollouts`. Cancelled it keeps what was finished: called again with that, it
/// goes on, to the same result. Errors: kInvalidArgument for options out of range, or another count of rollouts than
/// of starts, or starts outside of the lattice; those of `segment_world`.
Status run_physics(const learning::Model& model, const std::vector<spatial::CellIndex>& starts,
                   const PhysicsOptions& options, PhysicsRollouts& rollouts, Progress& progress);

/// A header and one row for each start that was run, in their order, each with the hash of the model and what else they
/// depend on.
std::string physics_csv(const learning::Model& model, const std::vector<spatial::CellIndex>& starts,
                        const PhysicsOptions& options, const PhysicsRollouts& rollouts);
/// What such a file holds of these starts. Errors: kCorrupt, naming the line; kInvalidArgument if it is of another
/// model or other options.
Result<PhysicsRollouts> parse_physics_csv(std::string_view csv, const learning::Model& model,
                                          const std::vector<spatial::CellIndex>& starts, const PhysicsOptions& options);

}  // namespace trocar::trial
