#include "engine/workbench/review_goals.h"

namespace trocar::workbench {

std::vector<review::SegmentGoal> goals_of(const ModelEntry* entry) {
  if (entry == nullptr || !entry->model || entry->model->safe.empty()) return {};
  const learning::Model& model = *entry->model;
  return {{entry->name, entry->segment, model.grid, model.safe, model.goal}};
}

}  // namespace trocar::workbench
