#include "engine/learning/explanation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/learning/policy.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;

namespace {

Model explained(Method method) {
  TrainOptions options;
  options.method = method;
  options.episodes = 2000;
  Progress progress;
  return train(spatial::Grid{}, {testing::sample_demonstrations()[0]}, options, progress).value();
}

}  // namespace

TEST_CASE("a loop is told with its cells, in the order in which the policy goes round") {
  const Model model = explained(Method::kEgMaxent);
  const auto policy = greedy_policy(model);
  const Basin all = basin(model, policy);
  const auto stride = strides(model.grid);
  int loops = 0;
  for (std::int32_t s = 0; s < model.grid.cell_count() && loops < 20; ++s) {
    if (all.end[static_cast<std::size_t>(s)] != RolloutEnd::kLoops) continue;
    ++loops;
    const Explanation why = explain(model, policy, {s});
    REQUIRE(why.end == RolloutEnd::kLoops);
    REQUIRE(why.cycle.size() >= 2);
    CHECK(why.where == why.cycle.front());
    for (std::size_t i = 0; i < why.cycle.size(); ++i) {
      const auto here = static_cast<std::size_t>(why.cycle[i].value);
      CHECK(why.cycle[i].value + stride[policy[here]] == why.cycle[(i + 1) % why.cycle.size()].value);
    }
    for (const spatial::CellIndex cell : why.unexplored) CHECK(model.tried[static_cast<std::size_t>(cell.value)] == 0);
  }
  CHECK(loops > 0);
}

TEST_CASE("where nothing is known the agent is lost where it stands, and an arrival ends at the goal") {
  const Model model = explained(Method::kEgMaxent);
  const auto policy = greedy_policy(model);
  const Explanation corner = explain(model, policy, {0});
  CHECK(corner.end == RolloutEnd::kOutsideSafeSet);
  CHECK(corner.where.value == 0);
  CHECK(corner.steps == 0);
  CHECK(std::isnan(corner.margin));
  const Model exact = explained(Method::kExact);
  const Explanation fine = explain(exact, greedy_policy(exact), {0});
  CHECK(fine.end == RolloutEnd::kArrives);
  CHECK(fine.where == exact.goal);
}

TEST_CASE("two rollouts part at the last cell that they share") {
  CHECK(first_divergence({{1}, {2}, {3}}, {{1}, {2}, {9}, {3}}) == 1);
  CHECK(first_divergence({{1}, {2}}, {{5}, {2}}) == -1);
  CHECK_FALSE(first_divergence({{1}, {2}}, {{1}, {2}, {3}}));
}
