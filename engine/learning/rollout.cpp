#include "engine/learning/rollout.h"

#include <algorithm>
#include <limits>

namespace trocar::learning {
namespace {

using spatial::Action;
using spatial::CellIndex;

std::vector<Eigen::Vector3d> centres(const spatial::Grid& grid, const CellSequence& cells) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(cells.size());
  for (const CellIndex cell : cells) points.push_back(grid.centre(cell));
  return points;
}

double distance_to_nearest(const Eigen::Vector3d& point, const std::vector<Eigen::Vector3d>& points) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& other : points) nearest = std::min(nearest, (point - other).norm());
  return nearest;
}

/// Discrete Fréchet distance, one row of its table at a time.
double frechet_distance(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) {
  std::vector<double> row(b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    double diagonal = 0.0;  // table entry (i − 1, j − 1)
    for (std::size_t j = 0; j < b.size(); ++j) {
      const double here = (a[i] - b[j]).norm();
      double reach = here;
      if (i > 0 && j > 0) {
        reach = std::min({row[j], row[j - 1], diagonal});
      } else if (i > 0) {
        reach = row[j];
      } else if (j > 0) {
        reach = row[j - 1];
      }
      diagonal = row[j];
      row[j] = std::max(reach, here);
    }
  }
  return row.back();
}

void follow(const Model& model, const std::vector<std::uint8_t>& policy, Rollout& result) {
  std::vector<std::uint8_t> seen(policy.size(), 0);
  CellIndex cell = result.start;
  for (;;) {
    result.cells.push_back(cell);
    const auto s = static_cast<std::size_t>(cell.value);
    if (cell == model.goal) {
      result.end = RolloutEnd::kArrives;
      return;
    }
    if (seen[s] != 0) {
      result.end = RolloutEnd::kLoops;
      return;
    }
    if (policy[s] == kNoAction) {
      result.end = model.safe.contains(cell) ? RolloutEnd::kDeadEnd : RolloutEnd::kOutsideSafeSet;
      return;
    }
    seen[s] = 1;
    result.reward_sum += model.theta[s];
    cell = *model.grid.neighbour(cell, static_cast<Action>(policy[s]));
  }
}

bool ends_from_above(const Model& model, const CellSequence& cells) {
  constexpr std::size_t kLookedAt = 3;
  if (cells.size() < kLookedAt + 1) return false;
  for (std::size_t i = cells.size() - kLookedAt; i < cells.size(); ++i) {
    if (model.grid.neighbour(cells[i - 1], Action::kMinusZ) != cells[i]) return false;
  }
  return true;
}

int first_departure(const CellSequence& cells, const CellSequence& expert) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (std::find(expert.begin(), expert.end(), cells[i]) == expert.end()) return static_cast<int>(i);
  }
  return -1;
}

void measure(const Model& model, Rollout& result) {
  const std::vector<Eigen::Vector3d> path = centres(model.grid, result.cells);
  const std::vector<Eigen::Vector3d> expert = centres(model.grid, model.experts.front());
  result.length_m = model.grid.cell_m * static_cast<double>(path.size() - 1);
  // A start at the goal is as straight as a path can be.
  result.straightness = result.length_m > 0.0 ? (path.back() - path.front()).norm() / result.length_m : 1.0;
  double sum_m = 0.0;
  for (const Eigen::Vector3d& point : path) {
    const double deviation_m = distance_to_nearest(point, expert);
    result.max_deviation_m = std::max(result.max_deviation_m, deviation_m);
    sum_m += deviation_m;
  }
  result.mean_deviation_m = sum_m / static_cast<double>(path.size());
  result.frechet_m = frechet_distance(path, expert);
  result.from_above = result.end == RolloutEnd::kArrives && ends_from_above(model, result.cells);
  result.divergence_step = first_departure(result.cells, model.experts.front());
}

}  // namespace

std::string_view to_string(RolloutEnd end) {
  constexpr std::array<std::string_view, 4> kNames{"arrives", "loops", "dead end", "outside the safe set"};
  return kNames[static_cast<std::size_t>(end)];
}

Rollout rollout(const Model& model, const std::vector<std::uint8_t>& policy, CellIndex start) {
  Rollout result;
  result.start = start;
  follow(model, policy, result);
  measure(model, result);
  return result;
}

}  // namespace trocar::learning
