/// What a model says when it is looked at: exploration, policy, outcome of every start, and some rollouts to draw;
/// beside another model, at an earlier epoch, or as it follows a demonstration that is being edited.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/learning/explanation.h"
#include "engine/learning/field.h"
#include "engine/learning/model_comparison.h"
#include "engine/learning/rollout.h"
#include "engine/learning/rollout_spread.h"
#include "engine/learning/rollout_table.h"
#include "engine/workbench/command.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

constexpr int kLargestAround = 5;
constexpr int kMostListed = 12'000;

/// Which field, and in which cells.
struct ShownField {
  learning::Layer layer = learning::Layer::kReward;
  learning::FieldMask mask = learning::FieldMask::kNone;
  bool operator==(const ShownField&) const = default;
};

/// The model that the first is compared with.
struct SecondModel {
  std::shared_ptr<const ModelEntry> entry;
  std::shared_ptr<const learning::Field> field;  ///< Of the layer in `FieldSettings`.
  std::shared_ptr<const std::vector<std::uint8_t>> policy;
  std::vector<learning::Rollout> ghosts;                        ///< From the starts of the first one's.
  std::shared_ptr<const learning::Field> difference;            ///< This one's layer less the first's.
  std::shared_ptr<const learning::ModelComparison> comparison;  ///< A: the first, B: this one.
  std::shared_ptr<const learning::Field> outcomes;              ///< Of each start, with the first and with this one.
  learning::PairedComparison paired;                            ///< Over the chosen starts.
  learning::OutcomeTable ends{};                                ///< Likewise: how each ends with both.
  /// From the starts of `ModelInsight::listed`, in their order.
  std::shared_ptr<const std::vector<learning::Rollout>> listed;
  std::shared_ptr<const learning::RolloutSpread> spread;  ///< As the first one's, of this one.
  std::optional<learning::Rollout> selected;              ///< From the selected start, with this one.
  std::optional<int> parts_at;                            ///< First step at which the two go different ways.
};

/// How a model keeps up with a demonstration that is being edited.
struct Following {
  double seconds = 0.0;    ///< Of learning anew; 0 where the cells were the same.
  int cells_changed = 0;   ///< Cells that the experts go through now and did not when it was trained, and the reverse.
  int policy_changed = 0;  ///< Cells in which the greedy action is another than that of the stored model.
  std::string error;       ///< Why it cannot; the stored model is shown then.
};

/// Worked out anew when the model, the layer or the starts change.
struct ModelInsight {
  /// As stored; or, with `following`, as it would be learned from what is shown now; or at an epoch.
  std::shared_ptr<const ModelEntry> entry;
  bool stale = false;
  std::optional<Following> following;
  int epoch = 0;  ///< Of `epochs`; equal: the end of the training.
  int epochs = 0;
  learning::Exploration exploration;
  std::shared_ptr<const learning::Field> field;  ///< Of the layer in `FieldSettings`.
  /// Of `WorkbenchState::field_layers`, in their order.
  std::vector<std::shared_ptr<const learning::Field>> layers;
  std::vector<ShownField> layers_of;  ///< What they are.
  std::shared_ptr<const std::vector<std::uint8_t>> policy;
  std::shared_ptr<const learning::Basin> basin;
  std::array<learning::RolloutSummary, kLargestAround> around;  ///< k = 1 … 5.
  learning::RolloutSummary all;
  std::vector<spatial::CellIndex> starts;  ///< Of `RolloutSettings::starts`.
  std::string starts_error;                ///< Why they are none.
  learning::RolloutSummary chosen;         ///< Of `starts`.
  std::vector<learning::Rollout> ghosts;   ///< For `RolloutSettings`, evenly over the starts.
  /// Of the starts, evenly over them if there are more than `kMostListed`; while a demonstration is edited, the ghosts.
  std::shared_ptr<const std::vector<learning::Rollout>> listed;
  /// Of all starts; while a demonstration is edited, of the ghosts.
  std::shared_ptr<const learning::RolloutSpread> spread;
  std::shared_ptr<const std::vector<double>> clearance_m;  ///< Of each cell from pegs and board.
  std::optional<learning::Rollout> selected;               ///< Of `RolloutSettings::selected`.
  std::optional<learning::Explanation> why;                ///< If that one does not arrive.
  std::optional<SecondModel> second;
  std::string second_error;  ///< Why it cannot be compared.
};

struct InsightRequest {
  std::shared_ptr<const ModelEntry> entry;  ///< Null: nothing is selected.
  bool stale = false;
  ShownField shown;
  std::vector<ShownField> layers;
  RolloutSettings rollouts;
  int epoch = -1;                            ///< Of the training; −1: its end.
  std::shared_ptr<const ModelEntry> second;  ///< Null: none.
  /// What `entry` would be trained on now, if it is to follow; null where one of its demonstrations is gone.
  std::vector<std::shared_ptr<const demonstration::Demonstration>> experts;
  /// Cancelled when another request has come: what all starts come to together is then left out. Null: never.
  std::shared_ptr<Progress> wanted;
};

/// Keeps what depends on the model alone, so that a change of layer or of starts costs little; and the last model that
/// followed, from which the next one starts warm.
/// Threads: one at a time.
class InsightMaker {
 public:
  /// Nothing if no model is selected.
  std::shared_ptr<const ModelInsight> make(const InsightRequest& request);

 private:
  std::shared_ptr<const ModelEntry> followed(const InsightRequest& request, Following& following);
  std::shared_ptr<const ModelEntry> at_epoch(const InsightRequest& request);
  void add_rollouts(const InsightRequest& request, ModelInsight& insight);
  void add_second(const InsightRequest& request, ModelInsight& insight);

  std::shared_ptr<const ModelInsight> of_model_;
  std::shared_ptr<const ModelEntry> stored_;    ///< Whose `followed_` and `early_` are.
  std::shared_ptr<const ModelEntry> followed_;  ///< Null: none yet.
  std::shared_ptr<const ModelEntry> early_;
  int early_epoch_ = -1;
  struct Listed {
    std::shared_ptr<const ModelEntry> of;
    std::vector<spatial::CellIndex> starts;
    bool brief = false;
    std::shared_ptr<const std::vector<learning::Rollout>> rollouts;
    std::shared_ptr<const learning::RolloutSpread> spread;
    std::shared_ptr<const std::vector<double>> clearance_m;
  } listed_;
  Listed second_listed_;  ///< Of the second model; without clearance.
  struct Compared {
    std::shared_ptr<const ModelEntry> a;
    std::shared_ptr<const ModelEntry> b;
    std::shared_ptr<const learning::ModelComparison> comparison;
    std::shared_ptr<const learning::Field> outcomes;
    std::shared_ptr<const std::vector<std::uint8_t>> policy_b;
  } compared_;
};

/// `count` of the starts, evenly through their list (all, if there are fewer).
std::vector<learning::Rollout> sample_rollouts(const learning::Model& model, const std::vector<std::uint8_t>& policy,
                                               const std::vector<spatial::CellIndex>& starts, int count);

/// The layer of a model on this board.
learning::Field field_of(const learning::Model& model, learning::Layer layer);

}  // namespace trocar::workbench
