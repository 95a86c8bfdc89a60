/// What is worked out of rollouts beside the exact ones: erring at random, in the simulator, and as a file.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/learning/field.h"
#include "engine/learning/monte_carlo.h"
#include "engine/learning/rollout_spread.h"
#include "engine/learning/rollout_table.h"
#include "engine/statistics/proportion.h"
#include "engine/trial/physics_rollout.h"
#include "engine/workbench/command.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

/// What erring at random found, whole or as far as it came.
struct MonteCarloView {
  std::shared_ptr<const ModelEntry> entry;
  std::string starts;  ///< As text.
  learning::MonteCarlo result;
  std::shared_ptr<const learning::Field> share;  ///< That arrives, of the starts that are finished.
  std::int64_t runs = 0;                         ///< Of the finished starts, together.
  std::int64_t arrived = 0;
  statistics::Interval interval;  ///< Of the share, 95 % (Wilson).

  bool whole() const { return static_cast<std::size_t>(result.finished) == result.starts.size(); }
};
MonteCarloView monte_carlo_view(std::shared_ptr<const ModelEntry> entry, std::string starts,
                                learning::MonteCarlo result);

/// What the simulator made of the policy, whole or as far as it came.
struct PhysicsView {
  std::shared_ptr<const ModelEntry> entry;
  std::string starts;
  std::vector<spatial::CellIndex> cells;
  trial::PhysicsOptions options;
  trial::PhysicsRollouts rollouts;  ///< By the place in `cells`.
  int finished = 0;
  int arrived = 0;
  double pushed_m = 0.0;  ///< The most that any block was moved.
};
PhysicsView physics_view(std::shared_ptr<const ModelEntry> entry, std::string starts,
                         std::vector<spatial::CellIndex> cells, const trial::PhysicsOptions& options,
                         trial::PhysicsRollouts rollouts);

/// `options` with the segment that the model is of, and the block and goal of its first demonstration (0 where that is
/// not known).
trial::PhysicsOptions physics_options_of(const Project& project, const ModelEntry& entry,
                                         trial::PhysicsOptions options);

/// How many steps a rollout has taken where rollouts are drawn: all of them without `RolloutSettings::reach`. As every
/// step is one cell long, a share of its way is that share of its steps.
double steps_taken(const learning::Rollout& rollout, const RolloutSettings& settings);

/// What a file of rollouts says of whose they are: "model", "method", "segment", "starts".
std::map<std::string, std::string> about_rollouts(const ModelEntry& entry, const std::string& starts);

/// The rows of rollouts with the clearance on this board, as window and command line write them. `monte_carlo` is of
/// the same starts, or null. Errors: kCancelled.
Result<std::string> rollout_rows(const learning::Model& model, const std::vector<spatial::CellIndex>& starts,
                                 const learning::MonteCarlo* monte_carlo, Progress& progress);
/// The deviations from the expert, step by step, of all starts, as window and command
/// line write them. Errors: kInvalidArgument where fewer than `learning::kLeastInBand` begin; kCancelled.
Result<std::string> band_rows(const learning::Model& model, const std::vector<spatial::CellIndex>& starts,
                              Progress& progress);

}  // namespace trocar::workbench
