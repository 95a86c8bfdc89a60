/// Maximum entropy IRL without sampling: no seed, one convex problem, an answer for every cell.
#pragma once

#include "engine/core/progress.h"
#include "engine/learning/model.h"

namespace trocar::learning {

/// Fills an untrained model with the θ that maximises J of `maxent_objective.h`.
///
/// V = log Z; Q(s,a) = θ(s) + log Z(s') for the known moves, minus infinity for the others; `visits` are expected
/// visits D × 1000 of paths from the training starts; `tried` holds the known moves; `curve` is ‖f − D‖₁ / ‖f‖₁ at each
/// iteration. θ of a cell outside of the safe set is θ₀: nothing was shown there.
///
/// Greedy on this Q arrives from every cell: with e^θ < 1/6, Z(s) = e^θ Σ Z(s') is less than the largest Z(s') of the
/// at most six known moves, so the best move always leads to a larger Z, and the largest is the goal's.
///
/// `previous`, if given, is an `exact` model of the same grid to start from. Errors: kCancelled.
/// Precondition: `check_training` passed.
Status solve_exact(Model& model, const Model* previous, Progress& progress);
/// Stops after `iterations` of the search, where θ is then not yet the best: to see the learning.
Status solve_exact(Model& model, const Model* previous, int iterations, Progress& progress);

}  // namespace trocar::learning
