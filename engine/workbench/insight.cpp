#include "engine/workbench/insight.h"

#include <algorithm>

namespace trocar::workbench {
namespace {

std::vector<spatial::CellIndex> all_cells(const spatial::Grid& grid) {
  std::vector<spatial::CellIndex> cells(static_cast<std::size_t>(grid.cell_count()));
  for (int i = 0; i < grid.cell_count(); ++i) cells[static_cast<std::size_t>(i)] = {i};
  return cells;
}

ModelInsight insight_of(const std::shared_ptr<const ModelEntry>& entry) {
  const learning::Model& model = *entry->model;
  ModelInsight insight;
  insight.entry = entry;
  insight.exploration = learning::exploration(model);
  insight.policy = std::make_shared<const std::vector<std::uint8_t>>(learning::greedy_policy(model));
  insight.basin = std::make_shared<const learning::Basin>(learning::basin(model, *insight.policy));
  for (int k = 1; k <= kLargestAround; ++k) {
    insight.around[static_cast<std::size_t>(k - 1)] =
        learning::summarise(*insight.basin, learning::starts_around(model, k));
  }
  insight.all = learning::summarise(*insight.basin, all_cells(model.grid));
  return insight;
}

}  // namespace

std::vector<learning::Rollout> sample_rollouts(const learning::Model& model, const std::vector<std::uint8_t>& policy,
                                               const RolloutSettings& settings) {
  const std::vector<spatial::CellIndex> starts = learning::starts_around(model, settings.around);
  const std::size_t count = std::min(starts.size(), static_cast<std::size_t>(std::max(0, settings.ghost_count)));
  std::vector<learning::Rollout> rollouts;
  rollouts.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    rollouts.push_back(learning::rollout(model, policy, starts[i * starts.size() / count]));
  }
  return rollouts;
}

std::shared_ptr<const ModelInsight> InsightMaker::make(const InsightRequest& request) {
  if (!request.entry) {
    of_model_.reset();
    return nullptr;
  }
  if (!of_model_ || of_model_->entry != request.entry) {
    of_model_ = std::make_shared<const ModelInsight>(insight_of(request.entry));
  }
  auto insight = std::make_shared<ModelInsight>(*of_model_);
  insight->stale = request.stale;
  insight->field = std::make_shared<const learning::Field>(learning::field(*request.entry->model, request.layer));
  insight->ghosts = sample_rollouts(*request.entry->model, *insight->policy, request.rollouts);
  return insight;
}

}  // namespace trocar::workbench
