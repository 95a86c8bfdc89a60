#include "engine/learning/eg_maxent.h"

#include <algorithm>
#include <cmath>

#include "engine/core/random.h"
#include "engine/learning/training_input.h"
#include "engine/learning/value_iteration.h"

namespace trocar::learning {
namespace {

using spatial::CellIndex;
using spatial::kActionCount;

/// Where each action leads; off the lattice it leads back to the cell itself.
std::vector<std::int32_t> successors(const spatial::Grid& grid) {
  std::vector<std::int32_t> next(static_cast<std::size_t>(grid.cell_count()) * kActionCount);
  for (int cell = 0; cell < grid.cell_count(); ++cell) {
    for (int a = 0; a < kActionCount; ++a) {
      const auto neighbour = grid.neighbour({cell}, static_cast<spatial::Action>(a));
      next[static_cast<std::size_t>(cell) * kActionCount + static_cast<std::size_t>(a)] =
          neighbour ? neighbour->value : cell;
    }
  }
  return next;
}

/// The loop of Algorithm 1, its state between episodes.
class EpisodeTrainer {
 public:
  explicit EpisodeTrainer(Model& model)
      : model_(model),
        plus_(model.options.method == Method::kEgMaxentPlus),
        reward_limit_(plus_ ? -0.2 : 0.0),
        length_limit_(plus_ ? 2 * model.experts.front().size() : 5 * model.experts.front().size() / 4),
        next_(successors(model.grid)),
        f_(feature_counts(model, plus_ ? Counting::kFirstVisit : Counting::kEveryVisit)),
        counts_(model.theta.size(), 0.0),
        random_(model.options.seed) {
    for (std::size_t cell = 0; cell < f_.size(); ++cell) {
      if (f_[cell] > 0.0) expert_cells_.push_back(static_cast<std::int32_t>(cell));
      f_sum_ += f_[cell];
    }
    if (plus_) starts_ = training_starts(model, model.options.start_spread);
    for (double& theta : model_.theta) theta = std::min(reward_limit_, -random_.uniform());
  }

  void run_episode() {
    std::int32_t cell = model_.start.value;
    if (!starts_.empty()) cell = starts_[random_.below(static_cast<std::uint32_t>(starts_.size()))].value;
    visit(cell);
    for (std::size_t step = 0; step < length_limit_ && cell != model_.goal.value; ++step) {
      cell = take_step(cell);
      visit(cell);
    }
  }

  /// Moves θ towards the expert's counts and forgets the episode; returns ‖f − D‖₁ / ‖f‖₁.
  double update_reward() {
    for (const std::int32_t cell : expert_cells_) {
      if (counts_[static_cast<std::size_t>(cell)] == 0.0) touched_.push_back(cell);
    }
    double mismatch = 0.0;
    for (const std::int32_t cell : touched_) {
      const auto s = static_cast<std::size_t>(cell);
      const double visits = plus_ ? std::min(counts_[s], 1.0) : counts_[s];
      const double difference = f_[s] - visits;
      model_.theta[s] = std::min(reward_limit_, model_.theta[s] + model_.options.theta_rate * difference);
      mismatch += std::abs(difference);
      counts_[s] = 0.0;
    }
    touched_.clear();
    return mismatch / f_sum_;
  }

 private:
  void visit(std::int32_t cell) {
    const auto s = static_cast<std::size_t>(cell);
    if (counts_[s] == 0.0) touched_.push_back(cell);
    counts_[s] += 1.0;
    ++model_.visits[s];
  }

  int choose_action(const double* q, double best) {
    if (random_.uniform() < model_.options.epsilon) return static_cast<int>(random_.below(kActionCount));
    int tied[kActionCount];
    int count = 0;
    for (int a = 0; a < kActionCount; ++a) {
      tied[count] = a;
      count += q[a] == best ? 1 : 0;
    }
    return count == 1 ? tied[0] : tied[random_.below(static_cast<std::uint32_t>(count))];
  }

  std::int32_t take_step(std::int32_t cell) {
    const auto s = static_cast<std::size_t>(cell);
    double* q = &model_.q[s * kActionCount];
    const int a = choose_action(q, model_.value[s]);
    const std::int32_t next = next_[s * kActionCount + static_cast<std::size_t>(a)];
    const double future =
        model_.value[static_cast<std::size_t>(next)];  // stays 0 at the goal: no action is taken there
    q[a] += model_.options.q_rate * (model_.theta[s] + model_.options.discount * future - q[a]);
    model_.value[s] = *std::max_element(q, q + kActionCount);
    model_.tried[s] = static_cast<std::uint8_t>(model_.tried[s] | (1U << a));
    return next;
  }

  Model& model_;
  bool plus_;
  double reward_limit_;       ///< θ never rises above it.
  std::size_t length_limit_;  ///< T, in steps.
  std::vector<std::int32_t> next_;
  std::vector<double> f_;
  double f_sum_ = 0.0;
  std::vector<std::int32_t> expert_cells_;
  std::vector<CellIndex> starts_;
  std::vector<double> counts_;         ///< D of the running episode.
  std::vector<std::int32_t> touched_;  ///< Cells with a count.
  Random random_;
};

}  // namespace

Status train_eg_maxent(Model& model, Progress& progress) {
  return train_eg_maxent(model, model.options.episodes / kEpisodesPerEpoch + 1, progress);
}

Status train_eg_maxent(Model& model, int epochs, Progress& progress) {
  EpisodeTrainer trainer(model);
  int episode = 0;
  for (int epoch = 0; epoch < epochs && episode < model.options.episodes; ++epoch) {
    const int in_epoch = std::min(kEpisodesPerEpoch, model.options.episodes - episode);
    double mismatch = 0.0;
    for (int i = 0; i < in_epoch; ++i, ++episode) {
      trainer.run_episode();
      mismatch += trainer.update_reward();
    }
    model.curve.push_back(mismatch / in_epoch);
    progress.tell(model.curve.back());
    if (progress.cancelled()) return fail(ErrorCode::kCancelled, "the training was cancelled");
    progress.set(static_cast<double>(episode) / model.options.episodes);
  }
  if (model.options.method == Method::kEgMaxentPlus) iterate_values(model);
  return {};
}

}  // namespace trocar::learning
