#include "engine/learning/learning_history.h"

#include <algorithm>

#include "engine/learning/eg_maxent.h"
#include "engine/learning/exact_maxent.h"
#include "engine/learning/training_input.h"

namespace trocar::learning {

int epoch_count(const Model& model) {
  return static_cast<int>(model.curve.size());
}

int expected_epochs(const TrainOptions& options) {
  if (options.method == Method::kExact) return 0;
  return (options.episodes + kEpisodesPerEpoch - 1) / kEpisodesPerEpoch;
}

Result<Model> model_at_epoch(const Model& model, int epoch, Progress& progress) {
  const int wanted = std::clamp(epoch, 0, epoch_count(model));
  if (wanted == epoch_count(model)) return model;
  Model early = untrained_model(model.grid, model.experts, model.options);
  const Status trained = model.options.method == Method::kExact ? solve_exact(early, nullptr, wanted, progress)
                                                                : train_eg_maxent(early, wanted, progress);
  TROCAR_RETURN_IF_ERROR(trained);
  progress.set(1.0);
  return early;
}

}  // namespace trocar::learning
