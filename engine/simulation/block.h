/// A block: one body of six boxes, three walls and three chamfered corners round a hexagonal hole.
#pragma once

#include <array>

#include "engine/peg_board/peg_board.h"
#include "engine/simulation/ode_handles.h"
#include "engine/simulation/shapes.h"

namespace trocar::simulation {

struct Block {
  OdeBody body;
  std::array<OdeGeom, kBoxesPerBlock> boxes;  ///< Walls 0–2, then corners 0–2; destroyed before the body.
};
/// At rest in W's origin; frame K as `peg_board` says.
Block make_block(dWorldID world);

}  // namespace trocar::simulation
