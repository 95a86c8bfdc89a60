/// What never moves: the table, the board and the twelve pegs.
#pragma once

#include <array>

#include "engine/peg_board/peg_board.h"
#include "engine/simulation/ode_handles.h"

namespace trocar::simulation {

struct Board {
  OdeGeom table;
  OdeGeom board;
  std::array<OdeGeom, peg_board::kPegCount> pegs;  ///< Start pegs, then goal pegs.
  std::array<Eigen::Vector3d, peg_board::kPegCount> feet;
};
Board make_board();

}  // namespace trocar::simulation
