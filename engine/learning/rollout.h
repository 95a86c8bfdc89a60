/// What the agent does from a start: greedy rollouts, exact and for all cells at once.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/learning/model.h"

namespace trocar::learning {

enum class RolloutEnd : std::uint8_t { kArrives, kLoops, kDeadEnd, kOutsideSafeSet };
std::string_view to_string(RolloutEnd end);

/// The greedy action in each cell: argmax of Q over moves that stay on the lattice and, from a safe cell, in the safe
/// set; ties by the order of `spatial::Action`, where rewards were imported by the shortest way first. 255 where there
/// is none (the goal, or no move known).
///
/// From a cell outside of the safe set the agent may move only if the model knows how (`exact`), and never leaves the
/// safe set once inside.
std::vector<std::uint8_t> greedy_policy(const Model& model);
constexpr std::uint8_t kNoAction = 255;

/// Outcome of every start under `policy`: exact, in one pass over the functional graph.
struct Basin {
  std::vector<RolloutEnd> end;           ///< By CellIndex.
  std::vector<std::uint16_t> steps;      ///< To the goal; 0 where it does not arrive.
  std::vector<std::uint8_t> from_above;  ///< 1 where the last three moves are all −z.
};
Basin basin(const Model& model, const std::vector<std::uint8_t>& policy);

/// One rollout with its measures (learning, "Fields and measures").
struct Rollout {
  spatial::CellIndex start;
  RolloutEnd end = RolloutEnd::kDeadEnd;
  CellSequence cells;  ///< Start and end included; a loop is followed once round.
  double length_m = 0.0;
  double straightness = 0.0;     ///< Distance start–end over length, 0 … 1.
  double max_deviation_m = 0.0;  ///< From the first expert's cells.
  double mean_deviation_m = 0.0;
  double frechet_m = 0.0;    ///< Discrete Fréchet distance to the first expert.
  double hausdorff_m = 0.0;  ///< The farthest that a cell of either is from the other's nearest.
  /// Mean distance of the matched cells where both are warped to each other at the least sum (DTW).
  double warped_m = 0.0;
  bool from_above = false;
  double reward_sum = 0.0;
  int outside_steps = 0;     ///< That end outside of the safe set.
  int divergence_step = -1;  ///< First step at which it leaves the expert's cells; −1 if never.
};
Rollout rollout(const Model& model, const std::vector<std::uint8_t>& policy, spatial::CellIndex start);

/// Starts within ± k cells (Chebyshev) of the model's start, by CellIndex.
std::vector<spatial::CellIndex> starts_around(const Model& model, int k);

/// `arrived`, `looped`, `dead_end` and `outside` add up to `count`.
struct RolloutSummary {
  int count = 0;
  int arrived = 0;
  int looped = 0;
  int dead_end = 0;
  int outside = 0;     ///< Starts outside of the safe set that the model cannot leave.
  int from_above = 0;  ///< Of the arrived.
};
RolloutSummary summarise(const Basin& basin, const std::vector<spatial::CellIndex>& starts);

/// How many starts end so with A (rows) and so with B (columns), by `RolloutEnd`.
using OutcomeTable = std::array<std::array<int, 4>, 4>;
OutcomeTable outcome_table(const Basin& a, const Basin& b, const std::vector<spatial::CellIndex>& starts);

/// Paired comparison of two models over the same starts, and McNemar's exact two-sided p.
struct PairedComparison {
  int wins_a = 0;  ///< Only A arrives.
  int wins_b = 0;
  int ties = 0;
  double mcnemar_p = 1.0;
};
PairedComparison compare(const Basin& a, const Basin& b, const std::vector<spatial::CellIndex>& starts);

}  // namespace trocar::learning
