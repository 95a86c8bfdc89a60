/// Why a rollout fails, and where two of them part.
#pragma once

#include <optional>
#include <vector>

#include "engine/learning/model.h"
#include "engine/learning/rollout.h"

namespace trocar::learning {

/// What a person asks of a start from which the agent does not arrive.
struct Explanation {
  RolloutEnd end = RolloutEnd::kDeadEnd;
  spatial::CellIndex where;                    ///< The last cell before it is lost: of a loop, the first of the cycle.
  CellSequence cycle;                          ///< Of a loop: its cells once round; else empty.
  std::vector<spatial::CellIndex> unexplored;  ///< Neighbours of `where` (or of the cycle) in which nothing was tried.
  double margin = 0.0;  ///< Q of the best action less that of the second, at `where`; NaN if there are not two.
  int steps = 0;        ///< From the start to `where`.
};
Explanation explain(const Model& model, const std::vector<std::uint8_t>& policy, spatial::CellIndex start);

/// The first step at which two rollouts from one start go to different cells: they share `cells[0 … step]`, and
/// `cells[step + 1]` differ. Nothing if one is the beginning of the other.
std::optional<int> first_divergence(const CellSequence& a, const CellSequence& b);

}  // namespace trocar::learning
