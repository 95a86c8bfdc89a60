// What must hold of policies whatever is demonstrated.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "engine/learning/model.h"
#include "engine/learning/policy.h"
#include "engine/learning/rollout.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;

namespace {

/// A walk of single steps across a lattice of 9³, which may cross itself, to a cell that it did not pass before.
CellSequence any_demonstration(const spatial::Grid& grid) {
  CellSequence cells{{*rc::gen::inRange(0, grid.cell_count())}};
  const auto steps = static_cast<std::size_t>(*rc::gen::inRange(4, 40));
  for (std::size_t i = 0; i < steps; ++i) {
    const auto next = grid.neighbour(cells.back(), static_cast<spatial::Action>(*rc::gen::inRange(0, 6)));
    if (next) cells.push_back(*next);
  }
  while (cells.size() > 1 && std::count(cells.begin(), cells.end(), cells.back()) > 1) cells.pop_back();
  RC_PRE(cells.size() >= 2);
  return cells;
}

Model trained(Method method, const spatial::Grid& grid, const CellSequence& expert) {
  TrainOptions options;
  options.method = method;
  options.episodes = 300;
  options.safe_radius = 2;
  options.start_spread = 2;
  Progress progress;
  return train(grid, {expert}, options, progress).value();
}

}  // namespace

TEST_CASE("the exact method arrives from every cell, and each of its steps climbs, whatever is demonstrated") {
  const spatial::Grid grid = spatial::Grid::with_cells(9);
  CHECK(rc::check([&grid] {
    const Model model = trained(Method::kExact, grid, any_demonstration(grid));
    const std::vector<std::uint8_t> policy = greedy_policy(model);
    const Basin all = basin(model, policy);
    for (int s = 0; s < grid.cell_count(); ++s) {
      const auto cell = static_cast<std::size_t>(s);
      RC_ASSERT(all.end[cell] == RolloutEnd::kArrives);
      if (s == model.goal.value) continue;
      const auto next = grid.neighbour({s}, static_cast<spatial::Action>(policy[cell]));
      RC_ASSERT(next.has_value());
      RC_ASSERT(model.value[static_cast<std::size_t>(next->value)] > model.value[cell]);
    }
  }));
}

TEST_CASE("no move of the product's method is better than its policy's, and V is what its rollouts collect") {
  const spatial::Grid grid = spatial::Grid::with_cells(9);
  CHECK(rc::check([&grid] {
    const Model model = trained(Method::kEgMaxentPlus, grid, any_demonstration(grid));
    const std::vector<std::uint8_t> policy = greedy_policy(model);
    for (int s = 0; s < grid.cell_count(); ++s) {
      const auto cell = static_cast<std::size_t>(s);
      if (s == model.goal.value || policy[cell] == kNoAction) continue;
      const double chosen = model.q_at({s}, static_cast<spatial::Action>(policy[cell]));
      for (int a = 0; a < spatial::kActionCount; ++a) {
        RC_ASSERT(model.q_at({s}, static_cast<spatial::Action>(a)) <= chosen);
      }
      RC_ASSERT(model.value[cell] == chosen);
      const Rollout way = rollout(model, policy, {s});
      RC_ASSERT(way.end == RolloutEnd::kArrives);
      double sum = 0.0;
      double weight = 1.0;
      for (std::size_t i = 0; i + 1 < way.cells.size(); ++i) {
        sum += weight * model.theta[static_cast<std::size_t>(way.cells[i].value)];
        weight *= model.options.discount;
      }
      RC_ASSERT(std::abs(sum - model.value[cell]) <= 1e-9 * (1.0 + std::abs(sum)));
    }
  }));
}
