/// From a continuous path to the agent's lattice: a legal 6-connected sequence of cells.
#pragma once

#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/spatial/grid.h"

namespace trocar::demonstration {

struct CellPath {
  std::vector<spatial::CellIndex> cells;  ///< Consecutive cells differ by one action; none twice in a row.
  double max_error_m = 0.0;               ///< From a sample to the centre of its cell.
  double mean_error_m = 0.0;
  int outside = 0;  ///< Samples outside of the lattice, left out.
};

/// The cells after `from` up to `to`, one action each, in the order in which the line between the two centres crosses
/// the faces; ties x, y, z. Empty if they are the same.
std::vector<spatial::CellIndex> steps_between(const spatial::Grid& grid, spatial::CellIndex from,
                                              spatial::CellIndex to);

/// How far beyond its face a cell is still kept, in widths of a cell: a tool that rests on a face, or goes down along
/// one, does not go to and fro with the noise of its encoders.
constexpr double kCellHysteresis = 0.2;

/// The left tool tip's measured path during `label`, as cells, kept as `kCellHysteresis` says. Diagonal steps are
/// filled with single actions along the line between the two cell centres, ties broken x, y, z. Errors:
/// kInvalidArgument if the segment is missing, or fewer than 2 cells remain.
Result<CellPath> discretise(const Demonstration& demonstration, Segment label, const spatial::Grid& grid);

}  // namespace trocar::demonstration
