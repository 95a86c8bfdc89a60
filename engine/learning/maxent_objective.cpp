#include "engine/learning/maxent_objective.h"

#include <algorithm>
#include <cmath>

#include "engine/learning/training_input.h"

namespace trocar::learning {
namespace {

std::vector<double> counts_before_goal(const Model& model) {
  std::vector<double> counts(model.theta.size(), 0.0);
  const double share = 1.0 / static_cast<double>(model.experts.size());
  for (const CellSequence& cells : model.experts) {
    for (const spatial::CellIndex cell : cells) {
      if (cell == model.goal) break;
      counts[static_cast<std::size_t>(cell.value)] += share;
    }
  }
  return counts;
}

std::vector<double> start_distribution(const Model& model) {
  std::vector<double> starts(model.theta.size(), 0.0);
  std::vector<spatial::CellIndex> cells = training_starts(model, model.options.start_spread);
  std::erase_if(cells, [&model](spatial::CellIndex cell) { return !model.safe.contains(cell); });
  for (const spatial::CellIndex cell : cells) {
    starts[static_cast<std::size_t>(cell.value)] = 1.0 / static_cast<double>(cells.size());
  }
  return starts;
}

std::vector<double> by_label(const MaxentRegion& region, const std::vector<double>& by_cell) {
  std::vector<double> values(region.count());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = by_cell[static_cast<std::size_t>(region.cells()[i])];
  return values;
}

}  // namespace

double lowest_reward() {
  return -60.0;
}

MaxentObjective::MaxentObjective(const Model& model, const std::vector<double>& theta)
    : prior_(model.options.theta_prior),
      regularisation_(model.options.regularisation),
      region_(model, theta),
      features_(by_label(region_, counts_before_goal(model))),
      starts_(by_label(region_, start_distribution(model))) {}

double MaxentObjective::evaluate(const std::vector<double>& theta, std::vector<double>& gradient, double tolerance) {
  region_.solve_partition(theta, tolerance);
  region_.solve_visits(starts_, tolerance);
  double value = 0.0;
  gradient[0] = 0.0;
  for (std::size_t i = 1; i < theta.size(); ++i) {
    const double away = theta[i] - prior_;
    value += features_[i] * theta[i] - 0.5 * regularisation_ * away * away;
    if (starts_[i] > 0.0) value -= starts_[i] * region_.log_partition(i);
    gradient[i] = features_[i] - region_.visits()[i] - regularisation_ * away;
  }
  return value;
}

double MaxentObjective::mismatch() const {
  double difference = 0.0;
  double total = 0.0;
  for (std::size_t i = 1; i < features_.size(); ++i) {
    difference += std::abs(features_[i] - region_.visits()[i]);
    total += features_[i];
  }
  return difference / total;
}

}  // namespace trocar::learning
