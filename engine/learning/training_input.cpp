#include "engine/learning/training_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/learning/rollout.h"

namespace trocar::learning {
namespace {

using spatial::CellCoordinates;
using spatial::CellIndex;
using spatial::Grid;

constexpr int kMaxCellsASide = 192;
constexpr int kMaxEpisodes = 10'000'000;
constexpr double kLowestPrior = -50.0;

Status check_range(const char* name, double value, double low, double high) {
  if (std::isfinite(value) && value >= low && value <= high) return {};
  return fail(ErrorCode::kInvalidArgument, fmt::format("{} is {}, but must lie in {} … {}", name, value, low, high));
}

Status check_options(const TrainOptions& options) {
  constexpr double kSmallest = 1e-6;
  TROCAR_RETURN_IF_ERROR(check_range("the θ learning rate", options.theta_rate, kSmallest, 10.0));
  TROCAR_RETURN_IF_ERROR(check_range("the Q learning rate", options.q_rate, kSmallest, 1.0));
  TROCAR_RETURN_IF_ERROR(check_range("the discount", options.discount, 0.0, 1.0));
  TROCAR_RETURN_IF_ERROR(check_range("epsilon", options.epsilon, 0.0, 1.0));
  TROCAR_RETURN_IF_ERROR(check_range("the number of episodes", options.episodes, 1, kMaxEpisodes));
  TROCAR_RETURN_IF_ERROR(check_range("the safe radius", options.safe_radius, 0, kMaxCellsASide));
  TROCAR_RETURN_IF_ERROR(check_range("the start spread", options.start_spread, 0, kMaxCellsASide));
  TROCAR_RETURN_IF_ERROR(check_range("the prior of θ", options.theta_prior, kLowestPrior, exact_reward_limit()));
  return check_range("the regularisation", options.regularisation, kSmallest, 1e6);
}

int steps_between(const Grid& grid, CellIndex a, CellIndex b) {
  const CellCoordinates p = grid.coordinates(a);
  const CellCoordinates q = grid.coordinates(b);
  return std::abs(p.x - q.x) + std::abs(p.y - q.y) + std::abs(p.z - q.z);
}

int chebyshev(const Grid& grid, CellIndex a, CellIndex b) {
  const CellCoordinates p = grid.coordinates(a);
  const CellCoordinates q = grid.coordinates(b);
  return std::max({std::abs(p.x - q.x), std::abs(p.y - q.y), std::abs(p.z - q.z)});
}

Status check_sequence(const Grid& grid, const CellSequence& cells, std::size_t number) {
  if (cells.size() < 2) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("expert sequence {} has {} cells, but needs at least 2", number, cells.size()));
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].value < 0 || cells[i].value >= grid.cell_count()) {
      return fail(ErrorCode::kInvalidArgument,
                  fmt::format("cell {} of expert sequence {} is not on the lattice", i, number));
    }
    if (i > 0 && steps_between(grid, cells[i - 1], cells[i]) != 1) {
      return fail(ErrorCode::kInvalidArgument,
                  fmt::format("cells {} and {} of expert sequence {} are not neighbours", i - 1, i, number));
    }
  }
  if (cells.front() == cells.back()) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("expert sequence {} ends where it starts", number));
  }
  return {};
}

}  // namespace

double exact_reward_limit() {
  constexpr double kLogOfSix = 1.791759469228055;
  return -kLogOfSix - 1e-3;
}

Status check_training(const Grid& grid, const std::vector<CellSequence>& experts, const TrainOptions& options) {
  TROCAR_RETURN_IF_ERROR(check_options(options));
  TROCAR_RETURN_IF_ERROR(check_range("the number of cells a side", grid.n, 2, kMaxCellsASide));
  TROCAR_RETURN_IF_ERROR(check_range("the width of a cell in metres", grid.cell_m, 1e-9, 1e3));
  if (!grid.p_WGo.allFinite()) return fail(ErrorCode::kInvalidArgument, "the origin of the lattice is not finite");
  if (experts.empty()) return fail(ErrorCode::kInvalidArgument, "there is no expert sequence to learn from");
  for (std::size_t i = 0; i < experts.size(); ++i) {
    TROCAR_RETURN_IF_ERROR(check_sequence(grid, experts[i], i + 1));
    const int apart = chebyshev(grid, experts[i].back(), experts.front().back());
    if (apart > options.safe_radius) {
      return fail(
          ErrorCode::kInvalidArgument,
          fmt::format("expert sequence {} ends {} cells from the goal of the first, beyond the safe radius of {}",
                      i + 1, apart, options.safe_radius));
    }
  }
  return {};
}

Model untrained_model(const Grid& grid, const std::vector<CellSequence>& experts, const TrainOptions& options) {
  Model model;
  model.options = options;
  model.grid = grid;
  model.experts = experts;
  model.start = experts.front().front();
  model.goal = experts.front().back();
  CellSequence all;
  for (const CellSequence& cells : experts) all.insert(all.end(), cells.begin(), cells.end());
  model.safe = spatial::cells_within(grid, all, options.safe_radius);
  const auto count = static_cast<std::size_t>(grid.cell_count());
  model.theta.assign(count, 0.0);
  model.q.assign(count * spatial::kActionCount, 0.0);
  model.value.assign(count, 0.0);
  model.visits.assign(count, 0);
  model.tried.assign(count, 0);
  return model;
}

std::vector<double> feature_counts(const Model& model, Counting counting) {
  std::vector<double> counts(model.theta.size(), 0.0);
  const double share = 1.0 / static_cast<double>(model.experts.size());
  for (const CellSequence& cells : model.experts) {
    CellSequence counted = cells;
    if (counting == Counting::kFirstVisit) {
      std::sort(counted.begin(), counted.end());
      counted.erase(std::unique(counted.begin(), counted.end()), counted.end());
    }
    for (const CellIndex cell : counted) counts[static_cast<std::size_t>(cell.value)] += share;
  }
  return counts;
}

std::vector<CellIndex> training_starts(const Model& model, int spread) {
  std::vector<CellIndex> starts = starts_around(model, spread);
  std::erase(starts, model.goal);
  return starts;
}

}  // namespace trocar::learning
