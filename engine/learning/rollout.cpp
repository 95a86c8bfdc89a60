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

/// Of a path from another: what is worked out of the table of all distances between their points, row by row.
struct PathDistances {
  std::vector<double> nearest_m;  ///< Of each point of the path, to the other.
  double frechet_m = 0.0;         ///< Discrete.
  double hausdorff_m = 0.0;
  double warped_m = 0.0;  ///< Mean over the pairs of the cheapest warping.
};

struct Warped {
  double sum = 0.0;
  int pairs = 0;
};

PathDistances distances_between(const std::vector<Eigen::Vector3d>& path, const std::vector<Eigen::Vector3d>& other) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  PathDistances found;
  std::vector<double> reach(other.size());
  std::vector<Warped> warped(other.size());
  std::vector<double> nearest_of_other(other.size(), kFar);
  for (std::size_t i = 0; i < path.size(); ++i) {
    double diagonal = 0.0;  // table entries (i − 1, j − 1)
    Warped warped_diagonal;
    double nearest = kFar;
    for (std::size_t j = 0; j < other.size(); ++j) {
      const double here = (path[i] - other[j]).norm();
      nearest = std::min(nearest, here);
      nearest_of_other[j] = std::min(nearest_of_other[j], here);
      double before = here;
      Warped from;
      if (i > 0 && j > 0) {
        before = std::min({reach[j], reach[j - 1], diagonal});
        from = warped_diagonal;
        if (warped[j].sum < from.sum) from = warped[j];
        if (warped[j - 1].sum < from.sum) from = warped[j - 1];
      } else if (i > 0) {
        before = reach[j];
        from = warped[j];
      } else if (j > 0) {
        before = reach[j - 1];
        from = warped[j - 1];
      }
      diagonal = reach[j];
      warped_diagonal = warped[j];
      reach[j] = std::max(before, here);
      warped[j] = {from.sum + here, from.pairs + 1};
    }
    found.nearest_m.push_back(nearest);
    found.hausdorff_m = std::max(found.hausdorff_m, nearest);
  }
  for (const double nearest : nearest_of_other) found.hausdorff_m = std::max(found.hausdorff_m, nearest);
  found.frechet_m = reach.back();
  found.warped_m = warped.back().sum / warped.back().pairs;
  return found;
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
  const PathDistances distances = distances_between(path, expert);
  double sum_m = 0.0;
  for (const double deviation_m : distances.nearest_m) {
    result.max_deviation_m = std::max(result.max_deviation_m, deviation_m);
    sum_m += deviation_m;
  }
  result.mean_deviation_m = sum_m / static_cast<double>(path.size());
  result.frechet_m = distances.frechet_m;
  result.hausdorff_m = distances.hausdorff_m;
  result.warped_m = distances.warped_m;
  for (std::size_t i = 1; i < result.cells.size(); ++i) {
    result.outside_steps += model.safe.contains(result.cells[i]) ? 0 : 1;
  }
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
