/// Everything of a world that ODE knows.
#pragma once

#include <array>

#include "engine/simulation/block.h"
#include "engine/simulation/board.h"
#include "engine/simulation/gripper.h"

namespace trocar::simulation {

/// Bodies are created in this order, always: ODE's results depend on it.
struct Physics {
  OdeStepper stepper;  ///< Destroyed last.
  OdeJointGroup contacts;
  Board board;
  std::array<Block, peg_board::kBlockCount> blocks;
  std::array<Gripper, 2> grippers;  ///< By `kinematics::index_of`.

  dWorldID world() const { return stepper.world.get(); }
};
Physics make_physics();

}  // namespace trocar::simulation
