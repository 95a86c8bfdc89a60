/// What every training method starts from: checked options, the expert's counts and the places that matter.
#pragma once

#include <vector>

#include "engine/learning/model.h"

namespace trocar::learning {

/// Checks everything that a caller can get wrong, so that no trainer has to.
/// Errors: kInvalidArgument, one sentence naming the option or the sequence.
Status check_training(const spatial::Grid& grid, const std::vector<CellSequence>& experts, const TrainOptions& options);

/// A model with the parts that do not depend on training: options, grid, experts, start, goal, safe set; all vectors
/// at their size and zero. Precondition: `check_training` passed.
Model untrained_model(const spatial::Grid& grid, const std::vector<CellSequence>& experts, const TrainOptions& options);

enum class Counting { kEveryVisit, kFirstVisit };
/// f of equation (1): visits for each cell, the mean over the experts, the last cell included.
std::vector<double> feature_counts(const Model& model, Counting counting);

/// Cells within ± `spread` (Chebyshev) of the start, without the goal, by CellIndex.
std::vector<spatial::CellIndex> training_starts(const Model& model, int spread);

/// The largest θ of `exact`: every cell then passes on less than it gets from its best neighbour (METHODS.md).
double exact_reward_limit();

}  // namespace trocar::learning
