/// What becomes of every start when the agent errs: ε-greedy rollouts, many for each start.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/progress.h"
#include "engine/learning/field.h"
#include "engine/learning/model.h"

namespace trocar::learning {

struct MonteCarloOptions {
  double epsilon = 0.1;  ///< Share of actions drawn evenly from those that lattice and safe set allow; 0 … 1.
  int runs = 100;        ///< For each start; 1 … 100,000.
  std::uint64_t seed = 1;
  int max_steps = 0;  ///< A rollout that has not arrived by then has failed; 0: 10 cells for each of a side.
  int threads = 1;    ///< 1 … 64; the result does not depend on it.
};

/// One entry for each start, in their order.
struct MonteCarlo {
  MonteCarloOptions options;
  std::vector<spatial::CellIndex> starts;
  std::vector<std::int32_t> arrived;     ///< Of `runs`.
  std::vector<std::int64_t> steps;       ///< Of those that arrived, together.
  std::vector<std::int32_t> from_above;  ///< Of those that arrived: the last three moves were −z.
  int finished = 0;                      ///< Starts that were done, from the front, when it was cancelled; else all.

  int runs() const { return options.runs; }
};

/// Each start has a random stream of its own, drawn from the seed and its cell's number: neither the order of the
/// starts nor the number of threads matters. A rollout without a known move fails where it stands. A cancelled one
/// keeps what was finished (`finished`). Errors: kInvalidArgument for options out of range.
Result<MonteCarlo> monte_carlo(const Model& model, const std::vector<spatial::CellIndex>& starts,
                               const MonteCarloOptions& options, Progress& progress);

/// The share that arrives from each start, NaN elsewhere; a cell that occurs twice counts once, with its last.
Field success_share(const spatial::Grid& grid, const MonteCarlo& result);

}  // namespace trocar::learning
