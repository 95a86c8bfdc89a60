/// The pegs as cells of the lattice.
#pragma once

#include "engine/spatial/grid.h"

namespace trocar::peg_board {

/// The cells that a peg or the board touches; blocks, which are moved, are none.
spatial::CellSet obstacle_cells(const spatial::Grid& grid);

}  // namespace trocar::peg_board
