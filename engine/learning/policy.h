/// Which moves the agent may execute: the one place where the safe set is enforced.
#pragma once

#include "engine/learning/model.h"

namespace trocar::learning {

/// True if lattice and safe set allow `action` in `cell`: the move stays on the lattice, and from a safe cell in the
/// safe set. Whether the model knows the move is another question.
bool allowed(const Model& model, spatial::CellIndex cell, spatial::Action action);

/// The allowed moves among which the greedy policy chooses, as bits by action; 0 at the goal.
///
/// `eg-maxent`: all allowed moves of a safe cell in which at least one action was tried; none outside of the safe set.
/// The others: the tried moves with a finite Q, outside of the safe set too.
std::uint8_t candidate_moves(const Model& model, spatial::CellIndex cell);

}  // namespace trocar::learning
