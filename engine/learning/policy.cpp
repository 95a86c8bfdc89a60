#include "engine/learning/policy.h"

#include <cmath>

#include "engine/learning/rollout.h"

namespace trocar::learning {

using spatial::kActionCount;

bool allowed(const Model& model, spatial::CellIndex cell, spatial::Action action) {
  const auto next = model.grid.neighbour(cell, action);
  return next && (!model.safe.contains(cell) || model.safe.contains(*next));
}

std::uint8_t candidate_moves(const Model& model, spatial::CellIndex cell) {
  const std::uint8_t tried = model.tried[static_cast<std::size_t>(cell.value)];
  if (cell == model.goal || tried == 0) return 0;
  const bool paper = model.options.method == Method::kEgMaxent;
  if (paper && !model.safe.contains(cell)) return 0;
  unsigned candidates = 0;
  for (unsigned a = 0; a < kActionCount; ++a) {
    const auto action = static_cast<spatial::Action>(a);
    const bool known = paper || ((tried >> a & 1U) != 0 && std::isfinite(model.q_at(cell, action)));
    if (known && allowed(model, cell, action)) candidates |= 1U << a;
  }
  return static_cast<std::uint8_t>(candidates);
}

std::vector<std::uint8_t> greedy_policy(const Model& model) {
  std::vector<std::uint8_t> policy(model.theta.size(), kNoAction);
  for (int cell = 0; cell < model.grid.cell_count(); ++cell) {
    const unsigned candidates = candidate_moves(model, {cell});
    const auto s = static_cast<std::size_t>(cell);
    double best = 0.0;
    for (unsigned a = 0; a < kActionCount; ++a) {
      if ((candidates >> a & 1U) == 0) continue;
      const double q = model.q[s * kActionCount + a];
      if (policy[s] != kNoAction && !(q > best)) continue;
      best = q;
      policy[s] = static_cast<std::uint8_t>(a);
    }
  }
  return policy;
}

}  // namespace trocar::learning
