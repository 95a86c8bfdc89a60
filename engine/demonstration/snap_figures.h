/// What snapping a path to the agent's lattice costs and gives, to be told before and after it is done.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/edit.h"

namespace trocar::demonstration {

/// Of one arm in the span of the edit.
struct SnapFigures {
  std::size_t arm = 0;
  int actions = 0;           ///< Steps of the agent from the first cell to the last.
  double max_error_m = 0.0;  ///< How far samples move; 0 where the path lies on the lattice already.
  double mean_error_m = 0.0;
  int skipped_cells = 0;   ///< Filled in: the tool went from one sample to the next past them.
  int repeated_cells = 0;  ///< Visits to a cell in which the path was before.
};

/// Of what `edit` would make of `document`, one for each of its arms. Errors: those of `transformed`.
Result<std::vector<SnapFigures>> snap_figures(const Demonstration& document, const SnapToGrid& edit);

/// "left tool: 112 actions, error at most 1.93 mm, 0.84 mm on average; cells skipped: 3, repeated: 0".
std::string sentence_of(const SnapFigures& figures);

}  // namespace trocar::demonstration
