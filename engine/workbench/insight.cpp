#include "engine/workbench/insight.h"

#include <algorithm>
#include <utility>

#include "engine/learning/learning_history.h"
#include "engine/learning/start_file.h"
#include "engine/peg_board/obstacles.h"
#include "engine/workbench/jobs/train_job.h"

namespace trocar::workbench {
namespace {

using Cells = std::vector<spatial::CellIndex>;

Cells all_cells(const spatial::Grid& grid) {
  Cells cells(static_cast<std::size_t>(grid.cell_count()));
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

/// How many cells are on the path of one and not of the other.
int cells_apart(const learning::Model& a, const learning::Model& b) {
  const auto visited = [](const learning::Model& model) {
    spatial::CellSet cells(model.grid);
    for (const learning::CellSequence& expert : model.experts) {
      for (const spatial::CellIndex cell : expert) cells.insert(cell);
    }
    return cells;
  };
  const spatial::CellSet of_a = visited(a);
  const spatial::CellSet of_b = visited(b);
  int apart = 0;
  for (std::size_t s = 0; s < of_a.flags().size(); ++s) apart += of_a.flags()[s] != of_b.flags()[s] ? 1 : 0;
  return apart;
}

int actions_apart(const learning::Model& a, const learning::Model& b) {
  const std::vector<std::uint8_t> of_a = learning::greedy_policy(a);
  const std::vector<std::uint8_t> of_b = learning::greedy_policy(b);
  int apart = 0;
  for (std::size_t s = 0; s < of_a.size(); ++s) apart += of_a[s] != of_b[s] ? 1 : 0;
  return apart;
}

/// Of all starts, or, to be `brief`, of those that are listed; null when it is no longer wanted.
std::shared_ptr<const learning::RolloutSpread> spread_of(const learning::Model& model,
                                                         const std::vector<std::uint8_t>& policy, const Cells& starts,
                                                         const std::vector<learning::Rollout>& listed, bool brief,
                                                         const std::vector<double>& clearance_m,
                                                         const std::shared_ptr<Progress>& wanted) {
  if (brief) {
    return std::make_shared<const learning::RolloutSpread>(learning::spread_of_rollouts(model, listed, clearance_m));
  }
  Progress never_cancelled;
  auto spread = learning::spread_from(model, policy, starts, clearance_m, wanted ? *wanted : never_cancelled);
  return spread ? std::make_shared<const learning::RolloutSpread>(std::move(*spread)) : nullptr;
}

/// What is shown of one that was given up.
std::shared_ptr<const learning::RolloutSpread> or_none(std::shared_ptr<const learning::RolloutSpread> spread) {
  static const auto kNone = std::make_shared<const learning::RolloutSpread>();
  return spread ? std::move(spread) : kNone;
}

std::shared_ptr<const ModelEntry> with_model(const ModelEntry& entry, learning::Model model) {
  auto made = std::make_shared<ModelEntry>(entry);
  made->model = std::make_shared<const learning::Model>(std::move(model));
  return made;
}

}  // namespace

learning::Field field_of(const learning::Model& model, learning::Layer layer) {
  if (layer != learning::Layer::kObstacles) return learning::field(model, layer);
  const spatial::CellSet obstacles = peg_board::obstacle_cells(model.grid);
  return learning::field(model, layer, &obstacles);
}

std::vector<learning::Rollout> sample_rollouts(const learning::Model& model, const std::vector<std::uint8_t>& policy,
                                               const std::vector<spatial::CellIndex>& starts, int count) {
  const Cells drawn = learning::evenly(starts, static_cast<std::size_t>(std::max(0, count)));
  std::vector<learning::Rollout> rollouts;
  rollouts.reserve(drawn.size());
  for (const spatial::CellIndex start : drawn) rollouts.push_back(learning::rollout(model, policy, start));
  return rollouts;
}

std::shared_ptr<const ModelEntry> InsightMaker::followed(const InsightRequest& request, Following& following) {
  const learning::Model& stored = *request.entry->model;
  const bool whole = std::all_of(request.experts.begin(), request.experts.end(), [](const auto& one) { return one; });
  auto experts = whole ? expert_cells(request.experts, request.entry->segment, stored.grid)
                       : Result<std::vector<learning::CellSequence>>(
                             fail(ErrorCode::kNotFound, "a demonstration that it was learned from is gone"));
  if (!experts) {
    following.error = experts.error().text();
    return request.entry;
  }
  if (*experts == stored.experts) return request.entry;
  if (!followed_ || followed_->model->experts != *experts) {
    const learning::Model& warm = followed_ ? *followed_->model : stored;
    Progress never_cancelled;
    Result<learning::Model> learned = learning::train_warm(warm, *experts, stored.options, never_cancelled);
    if (!learned) {
      following.error = learned.error().text();
      return request.entry;
    }
    followed_ = with_model(*request.entry, std::move(*learned));
  }
  following.seconds = followed_->model->seconds;
  following.cells_changed = cells_apart(*followed_->model, stored);
  following.policy_changed = actions_apart(*followed_->model, stored);
  return followed_;
}

std::shared_ptr<const ModelEntry> InsightMaker::at_epoch(const InsightRequest& request) {
  if (early_ && early_epoch_ == request.epoch) return early_;
  Progress never_cancelled;
  Result<learning::Model> early = learning::model_at_epoch(*request.entry->model, request.epoch, never_cancelled);
  if (!early) return request.entry;
  early_ = with_model(*request.entry, std::move(*early));
  early_epoch_ = request.epoch;
  return early_;
}

void InsightMaker::add_second(const InsightRequest& request, ModelInsight& insight) {
  if (!request.second) return;
  const learning::Model& a = *insight.entry->model;
  const learning::Model& b = *request.second->model;
  if (a.grid != b.grid) {
    insight.second_error = "The models have different lattices";
    return;
  }
  if (compared_.a != insight.entry || compared_.b != request.second) {
    auto comparison = std::make_shared<const learning::ModelComparison>(learning::compare_models(a, b));
    auto outcomes = std::make_shared<const learning::Field>(
        learning::paired_outcomes(a.grid, comparison->basin_a, comparison->basin_b));
    compared_ = {insight.entry, request.second, std::move(comparison), std::move(outcomes),
                 std::make_shared<const std::vector<std::uint8_t>>(learning::greedy_policy(b))};
  }
  SecondModel second;
  second.entry = request.second;
  second.comparison = compared_.comparison;
  second.outcomes = compared_.outcomes;
  second.policy = compared_.policy_b;
  for (const learning::Rollout& ghost : insight.ghosts) {
    second.ghosts.push_back(learning::rollout(b, *second.policy, ghost.start));
  }
  second.paired = learning::compare(second.comparison->basin_a, second.comparison->basin_b, insight.starts);
  second.ends = learning::outcome_table(second.comparison->basin_a, second.comparison->basin_b, insight.starts);
  if (!second_listed_.rollouts || second_listed_.of != request.second || second_listed_.starts != insight.starts ||
      second_listed_.brief != listed_.brief || !second_listed_.spread) {
    second_listed_.of = request.second;
    second_listed_.starts = insight.starts;
    second_listed_.brief = listed_.brief;
    const int count = static_cast<int>(insight.listed->size());
    second_listed_.rollouts = std::make_shared<const std::vector<learning::Rollout>>(
        sample_rollouts(b, *second.policy, insight.starts, count));
    second_listed_.spread = spread_of(b, *second.policy, insight.starts, *second_listed_.rollouts, listed_.brief,
                                      *insight.clearance_m, request.wanted);
  }
  second.listed = second_listed_.rollouts;
  second.spread = or_none(second_listed_.spread);
  if (insight.selected) {
    second.selected = learning::rollout(b, *second.policy, insight.selected->start);
    second.parts_at = learning::first_divergence(insight.selected->cells, second.selected->cells);
  }
  second.field = std::make_shared<const learning::Field>(
      learning::masked(field_of(b, request.shown.layer), b, second.comparison->basin_b, request.shown.mask));
  second.difference = std::make_shared<const learning::Field>(learning::difference(*insight.field, *second.field));
  insight.second = std::move(second);
}

void InsightMaker::add_rollouts(const InsightRequest& request, ModelInsight& insight) {
  const learning::Model& model = *insight.entry->model;
  // What follows an edit has to keep up with the mouse.
  const bool brief = insight.following.has_value();
  if (!listed_.rollouts || listed_.of != insight.entry || listed_.starts != insight.starts || listed_.brief != brief ||
      !listed_.spread) {
    listed_.of = insight.entry;
    listed_.starts = insight.starts;
    listed_.brief = brief;
    listed_.rollouts = std::make_shared<const std::vector<learning::Rollout>>(
        brief ? insight.ghosts : sample_rollouts(model, *insight.policy, insight.starts, kMostListed));
    listed_.clearance_m = std::make_shared<const std::vector<double>>(peg_board::clearances_m(model.grid));
    listed_.spread = spread_of(model, *insight.policy, insight.starts, *listed_.rollouts, brief, *listed_.clearance_m,
                               request.wanted);
  }
  insight.listed = listed_.rollouts;
  insight.spread = or_none(listed_.spread);
  insight.clearance_m = listed_.clearance_m;
  const auto& selected = request.rollouts.selected;
  if (!selected || selected->value < 0 || selected->value >= model.grid.cell_count()) return;
  insight.selected = learning::rollout(model, *insight.policy, *selected);
  if (insight.selected->end != learning::RolloutEnd::kArrives) {
    insight.why = learning::explain(model, *insight.policy, *selected);
  }
}

std::shared_ptr<const ModelInsight> InsightMaker::make(const InsightRequest& request) {
  if (!request.entry) {
    *this = {};
    return nullptr;
  }
  if (stored_ != request.entry) {
    stored_ = request.entry;
    followed_.reset();
    early_.reset();
  }
  std::optional<Following> following;
  std::shared_ptr<const ModelEntry> shown = request.entry;
  const int epochs = learning::epoch_count(*request.entry->model);
  const bool early = request.epoch >= 0 && request.epoch < epochs;
  if (early) {
    shown = at_epoch(request);
  } else if (!request.experts.empty()) {
    shown = followed(request, following.emplace());
  }
  if (!of_model_ || of_model_->entry != shown) {
    of_model_ = std::make_shared<const ModelInsight>(insight_of(shown));
  }
  auto insight = std::make_shared<ModelInsight>(*of_model_);
  const learning::Model& model = *shown->model;
  insight->stale = request.stale;
  insight->following = std::move(following);
  insight->epochs = epochs;
  insight->epoch = early ? request.epoch : epochs;
  const auto shown_field = [&](const ShownField& of) {
    return std::make_shared<const learning::Field>(
        learning::masked(field_of(model, of.layer), model, *insight->basin, of.mask));
  };
  insight->field = shown_field(request.shown);
  for (const ShownField& of : request.layers) insight->layers.push_back(shown_field(of));
  insight->layers_of = request.layers;
  if (auto starts = learning::read_starts(request.rollouts.starts, model)) {
    insight->starts = std::move(*starts);
  } else {
    insight->starts_error = starts.error().text();
  }
  insight->chosen = learning::summarise(*insight->basin, insight->starts);
  insight->ghosts = sample_rollouts(model, *insight->policy, insight->starts, request.rollouts.ghost_count);
  add_rollouts(request, *insight);
  add_second(request, *insight);
  return insight;
}

}  // namespace trocar::workbench
