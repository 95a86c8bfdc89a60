/// Which moves the agent may execute: the one place where the safe set is enforced.
#pragma once

#include <array>

#include "engine/learning/model.h"

namespace trocar::learning {

/// The moves that lattice and safe set allow in each cell, as bits by action: the move stays on the lattice, and from a
/// safe cell in the safe set. Whether the model knows the move is another question.
std::vector<std::uint8_t> allowed_moves(const spatial::Grid& grid, const spatial::CellSet& safe);

/// By how much each action changes the flat index of a cell.
std::array<std::int32_t, spatial::kActionCount> strides(const spatial::Grid& grid);

/// The allowed moves among which the greedy policy chooses, as bits by action; 0 at the goal.
///
/// `eg-maxent`: all allowed moves of a safe cell in which at least one action was tried; none outside of the safe set.
/// The others: the allowed moves that were tried and have a finite Q, outside of the safe set too.
std::vector<std::uint8_t> candidate_moves(const Model& model);

}  // namespace trocar::learning
