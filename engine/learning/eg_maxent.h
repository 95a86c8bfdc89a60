/// EG MaxEnt IRL by sampled episodes: the paper's Algorithm 1 and the product's variant of it.
#pragma once

#include "engine/core/progress.h"
#include "engine/learning/model.h"

namespace trocar::learning {

/// Fills an untrained model with method `kEgMaxent` or `kEgMaxentPlus` by `options.episodes` episodes.
///
/// For each step, equation (2): Q(s,a) += α (θ(s) + γ max Q(s',·) − Q(s,a)), with max Q(goal,·) = 0.
/// After each episode, equation (1): θ(s) = min(limit, θ(s) + β (f(s) − D(s))) for s in episode or demonstration,
/// where D counts the episode's visits, its final cell included.
///
/// Random numbers, in this order from `Random(options.seed)`: one θ(s) = −U(0,1) for each cell by CellIndex; then for
/// each episode the start (`kEgMaxentPlus` only), and for each step one U for ε, followed by the action if U < ε, or
/// by the choice among tied actions if more than one is best.
///
/// `kEgMaxentPlus` ends with value iteration on the frozen θ (`value_iteration.h`).
/// Errors: kCancelled. Precondition: `check_training` passed.
Status train_eg_maxent(Model& model, Progress& progress);
/// Stops after `epochs` of `kEpisodesPerEpoch` episodes each, or at the last episode.
Status train_eg_maxent(Model& model, int epochs, Progress& progress);
constexpr int kEpisodesPerEpoch = 100;

}  // namespace trocar::learning
