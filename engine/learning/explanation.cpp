#include "engine/learning/explanation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/learning/policy.h"

namespace trocar::learning {
namespace {

using spatial::CellIndex;

double margin_at(const Model& model, CellIndex cell) {
  const unsigned candidates = candidate_moves(model)[static_cast<std::size_t>(cell.value)];
  std::vector<double> q;
  for (int a = 0; a < spatial::kActionCount; ++a) {
    if ((candidates >> a & 1U) != 0) q.push_back(model.q_at(cell, static_cast<spatial::Action>(a)));
  }
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (q.size() < 2) return kNone;
  std::partial_sort(q.begin(), q.begin() + 2, q.end(), std::greater<>());
  return std::isfinite(q[1]) ? q[0] - q[1] : kNone;
}

std::vector<CellIndex> unexplored_beside(const Model& model, const CellSequence& cells) {
  std::vector<CellIndex> found;
  for (const CellIndex cell : cells) {
    for (int a = 0; a < spatial::kActionCount; ++a) {
      const auto next = model.grid.neighbour(cell, static_cast<spatial::Action>(a));
      if (next && *next != model.goal && model.tried[static_cast<std::size_t>(next->value)] == 0) {
        found.push_back(*next);
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace

Explanation explain(const Model& model, const std::vector<std::uint8_t>& policy, CellIndex start) {
  const Rollout path = rollout(model, policy, start);
  Explanation result;
  result.end = path.end;
  auto lost = static_cast<std::ptrdiff_t>(path.cells.size()) - 1;
  if (path.end == RolloutEnd::kLoops) {
    // The last cell is the one that was met before.
    const auto first = std::find(path.cells.begin(), path.cells.end(), path.cells.back());
    result.cycle.assign(first, path.cells.end() - 1);
    lost = first - path.cells.begin();
  }
  result.where = path.cells[static_cast<std::size_t>(lost)];
  result.steps = static_cast<int>(lost);
  result.unexplored = unexplored_beside(model, result.cycle.empty() ? CellSequence{result.where} : result.cycle);
  result.margin = margin_at(model, result.where);
  return result;
}

std::optional<int> first_divergence(const CellSequence& a, const CellSequence& b) {
  const std::size_t both = std::min(a.size(), b.size());
  for (std::size_t i = 0; i < both; ++i) {
    if (a[i] != b[i]) return static_cast<int>(i) - 1;
  }
  return std::nullopt;
}

}  // namespace trocar::learning
