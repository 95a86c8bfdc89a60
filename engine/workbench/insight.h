/// What a model says when it is looked at: exploration, policy, outcome of every start, and some rollouts to draw.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "engine/learning/field.h"
#include "engine/learning/rollout.h"
#include "engine/workbench/command.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

constexpr int kLargestAround = 5;

/// Worked out anew when the model, the layer or the starts change.
struct ModelInsight {
  std::shared_ptr<const ModelEntry> entry;
  bool stale = false;
  learning::Exploration exploration;
  std::shared_ptr<const learning::Field> field;  ///< Of the layer in `FieldSettings`.
  std::shared_ptr<const std::vector<std::uint8_t>> policy;
  std::shared_ptr<const learning::Basin> basin;
  std::array<learning::RolloutSummary, kLargestAround> around;  ///< k = 1 … 5.
  learning::RolloutSummary all;
  std::vector<learning::Rollout> ghosts;  ///< For `RolloutSettings`, evenly over the starts.
};

struct InsightRequest {
  std::shared_ptr<const ModelEntry> entry;  ///< Null: nothing is selected.
  bool stale = false;
  learning::Layer layer = learning::Layer::kReward;
  RolloutSettings rollouts;
};

/// Keeps what depends on the model alone, so that a change of layer or of starts costs little.
/// Threads: one at a time.
class InsightMaker {
 public:
  /// Nothing if no model is selected.
  std::shared_ptr<const ModelInsight> make(const InsightRequest& request);

 private:
  std::shared_ptr<const ModelInsight> of_model_;
};

/// `count` of the starts within ± `around` cells, evenly through their list (all, if there are fewer).
std::vector<learning::Rollout> sample_rollouts(const learning::Model& model, const std::vector<std::uint8_t>& policy,
                                               const RolloutSettings& settings);

}  // namespace trocar::workbench
