/// Rollouts for films: the agent in the simulator, as something that can be filmed.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/demonstration/demonstration.h"
#include "engine/trial/physics_rollout.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

struct FilmedRollout {
  std::shared_ptr<const demonstration::Demonstration> shown;
  trial::PhysicsRollout result;
  std::array<int, 3> start{};  ///< Cells.
};

/// Runs them, and keeps the last few: a film that is being made need not run them anew. Threads: one at a time.
class RolloutShelf {
 public:
  RolloutShelf() = default;
  /// Nothing is run any more once `progress` is cancelled. It lives as long as this.
  explicit RolloutShelf(const Progress& progress) : progress_(&progress) {}

  /// From where the model's first expert began without `start`; seed 1, with the block of the model's first
  /// demonstration. Precondition: the entry has its model. Errors: kInvalidArgument for a start outside of the lattice;
  /// those of `trial::record_rollout`; kCancelled.
  Result<FilmedRollout> rollout(const Project& project, const ModelEntry& entry,
                                const std::optional<std::array<int, 3>>& start);

 private:
  struct Kept {
    std::uint64_t model_hash = 0;
    spatial::CellIndex start;
    trial::PhysicsOptions options;
    FilmedRollout rollout;
  };
  const Progress* progress_ = nullptr;
  std::vector<Kept> kept_;  ///< The last one asked for is the last.
};

}  // namespace trocar::workbench
