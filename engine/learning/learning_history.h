/// The learning of a model played again: what it had learned after some of its epochs.
#pragma once

#include "engine/learning/model.h"

namespace trocar::learning {

/// Epochs that the training of `model` took: 100 episodes each, or one iteration of the solver each.
int epoch_count(const Model& model);

/// As `epoch_count` before the training; 0 for a method that ends when it has converged.
int expected_epochs(const TrainOptions& options);

/// What training with the model's options had learned after `epoch` epochs, by training again that far: every method
/// gives the same numbers each time, so that nothing of this needs to be stored. Its curve has `epoch` entries.
///
/// At `epoch_count` it is the model itself, also where that was trained warm; the epochs before are those of a training
/// that began cold, and the last of them if there are fewer. `epoch` is clamped to 0 … `epoch_count`; 0 is what there
/// was before the first. Errors: kCancelled.
Result<Model> model_at_epoch(const Model& model, int epoch, Progress& progress);

}  // namespace trocar::learning
