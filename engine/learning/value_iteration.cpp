#include "engine/learning/value_iteration.h"

#include <algorithm>
#include <limits>

#include "engine/learning/policy.h"

namespace trocar::learning {
namespace {

using spatial::kActionCount;

constexpr double kUnreached = -std::numeric_limits<double>::infinity();

struct Move {
  std::int32_t from;
  std::int32_t to;
  std::uint8_t action;
};

std::vector<Move> usable_moves(const Model& model) {
  std::vector<Move> moves;
  const std::vector<std::uint8_t> allowed = allowed_moves(model.grid, model.safe);
  const auto stride = strides(model.grid);
  for (std::int32_t cell = 0; cell < model.grid.cell_count(); ++cell) {
    const auto s = static_cast<std::size_t>(cell);
    for (std::size_t a = 0; a < kActionCount; ++a) {
      if (cell == model.goal.value || (allowed[s] & model.tried[s] & 1U << a) == 0) continue;
      moves.push_back({cell, cell + stride[a], static_cast<std::uint8_t>(a)});
    }
  }
  return moves;
}

/// Takes one move into account; true if it was the best yet.
bool relax(const Model& model, const Move& move, std::vector<double>& value) {
  const double future = value[static_cast<std::size_t>(move.to)];
  if (future == kUnreached) return false;
  const auto s = static_cast<std::size_t>(move.from);
  const double offer = model.theta[s] + model.options.discount * future;
  if (!(offer > value[s])) return false;
  value[s] = offer;
  return true;
}

}  // namespace

void iterate_values(Model& model) {
  const std::vector<Move> moves = usable_moves(model);
  std::vector<double> value(model.value.size(), kUnreached);
  value[static_cast<std::size_t>(model.goal.value)] = 0.0;
  for (bool improved = true; improved;) {
    improved = false;
    for (const Move& move : moves) improved = relax(model, move, value) || improved;
    for (auto move = moves.rbegin(); move != moves.rend(); ++move) improved = relax(model, *move, value) || improved;
  }
  std::fill(model.q.begin(), model.q.end(), kUnreached);
  for (const Move& move : moves) {
    const auto s = static_cast<std::size_t>(move.from);
    const double future = value[static_cast<std::size_t>(move.to)];
    model.q[s * kActionCount + move.action] = model.theta[s] + model.options.discount * future;
  }
  model.value = std::move(value);
}

}  // namespace trocar::learning
