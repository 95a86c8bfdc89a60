/// The pegs as cells of the lattice.
#pragma once

#include <vector>

#include "engine/spatial/grid.h"

namespace trocar::peg_board {

/// The cells that a peg or the board touches; blocks, which are moved, are none.
spatial::CellSet obstacle_cells(const spatial::Grid& grid);

/// Of a tool tip at Q from the nearest peg or the board, metres; negative within them. Blocks, which are moved, do not
/// count. Precondition: Q is above the board's edges or inside of them (the lattice is).
double clearance_m(const Eigen::Vector3d& p_WQ);
/// The same of the middle of each cell, by CellIndex.
std::vector<double> clearances_m(const spatial::Grid& grid);

}  // namespace trocar::peg_board
