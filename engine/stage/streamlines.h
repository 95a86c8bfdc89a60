/// Where the greedy policy leads, as lines from cell to cell.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/learning/rollout.h"
#include "engine/scene/scene.h"

namespace trocar::stage {

/// One line: it begins at a start, or in a loop, and ends where the agent does or where another line has gone on
/// before.
struct Streamline {
  learning::RolloutEnd end = learning::RolloutEnd::kDeadEnd;  ///< Of the agent, not of the line.
  bool in_loop = false;                                       ///< Its cells are the loop, once round.
  learning::CellSequence cells;                               ///< Two or more, but for a start without a move.
};

/// Of each start once, in their order; no step is in two lines.
/// Precondition: `policy` is of the model (`learning::greedy_policy`), the starts are cells of its grid.
std::vector<Streamline> streamlines(const learning::Model& model, const std::vector<std::uint8_t>& policy,
                                    const std::vector<spatial::CellIndex>& starts);

/// As tubes with arrow heads every few cells, one mesh: what arrives is blue, what loops red and dashed, what comes to
/// a dead end orange with a cube there, what is outside of the safe set grey with a cube.
void add_streamlines(const spatial::Grid& grid, const std::vector<Streamline>& lines, scene::Scene& scene);

}  // namespace trocar::stage
