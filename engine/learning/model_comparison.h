/// How two models of one lattice differ: cell by cell, and in numbers.
#pragma once

#include <array>
#include <vector>

#include "engine/learning/field.h"
#include "engine/learning/model.h"
#include "engine/learning/rollout.h"

namespace trocar::learning {

/// B − A in each cell; of classes, 0 where they are the same and 1 where not. NaN where one of them is unknown.
/// Precondition: both are of one grid and layer.
Field difference(const Field& a, const Field& b);

/// Classes: the same action, another action, only A has one, only B has one; NaN where neither has.
Field policy_change(const spatial::Grid& grid, const std::vector<std::uint8_t>& policy_a,
                    const std::vector<std::uint8_t>& policy_b);

/// Classes of each start: both arrive, only A, only B, neither.
Field paired_outcomes(const spatial::Grid& grid, const Basin& a, const Basin& b);

/// Of one model, for the table beside the fields. `exact` explores nothing: its counts of actions say little. Rewards,
/// margin and mismatch are NaN where the model has none (imported).
struct ModelMeasures {
  Exploration exploration;
  double least_reward = 0.0;  ///< Of the cells that are known.
  double mean_reward = 0.0;
  double mean_margin = 0.0;
  double mismatch = 0.0;  ///< The last of the curve: ‖f − D‖₁ / ‖f‖₁.
  RolloutSummary all;
  std::array<RolloutSummary, 5> around;  ///< k = 1 … 5, around A's start for both.
};

struct ModelComparison {
  Basin basin_a;
  Basin basin_b;
  ModelMeasures a;
  ModelMeasures b;
  Field policy_change;
  int policy_changed = 0;   ///< Cells in which the greedy action differs, or only one model has any.
  int policy_compared = 0;  ///< Cells in which both have one.
  int policy_differs = 0;   ///< Of those, where it differs.
  PairedComparison paired;  ///< Over all cells.
};
/// Precondition: both models have one grid.
ModelComparison compare_models(const Model& a, const Model& b);

}  // namespace trocar::learning
