#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/learning/model.h"
#include "engine/learning/rollout.h"
#include "engine/learning/training_input.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;
using trocar::testing::sample_demonstrations;

namespace {

TrainOptions exact() {
  TrainOptions options;
  options.method = Method::kExact;
  return options;
}

Model exactly_trained(const CellSequence& expert, const TrainOptions& options = exact(),
                      const spatial::Grid& grid = {}) {
  Progress progress;
  return train(grid, {expert}, options, progress).value();
}

}  // namespace

TEST_CASE("an exact model arrives from all 10,648 cells") {
  for (const CellSequence& expert : sample_demonstrations()) {
    const Model model = exactly_trained(expert);
    const Basin all = basin(model, greedy_policy(model));
    CHECK(std::count(all.end.begin(), all.end.end(), RolloutEnd::kArrives) == 10648);
  }
}

TEST_CASE("an exact model on 44³ arrives from all 85,184 cells") {
  TrainOptions options = exact();
  options.safe_radius *= 2;
  options.start_spread *= 2;
  const Model model = exactly_trained(sample_demonstrations(2)[1], options, spatial::Grid::with_cells(44));
  const Basin all = basin(model, greedy_policy(model));
  CHECK(std::count(all.end.begin(), all.end.end(), RolloutEnd::kArrives) == 85184);
}

TEST_CASE("an exact model approaches from above, as it was shown, in 0.95 of ±3 and 0.90 of ±5") {
  const spatial::Grid grid;
  std::vector<CellSequence> demonstrations = sample_demonstrations();
  // Short and long columns, low goals, and a long way across.
  demonstrations.push_back(testing::approach_from_above(grid, {11, 12, 19}, {15, 2, 2}, 3, 21));
  demonstrations.push_back(testing::approach_from_above(grid, {11, 12, 19}, {2, 4, 1}, 8, 22));
  demonstrations.push_back(testing::approach_from_above(grid, {4, 4, 19}, {16, 16, 6}, 5, 23));
  for (const CellSequence& expert : demonstrations) {
    const Model model = exactly_trained(expert);
    const Basin all = basin(model, greedy_policy(model));
    const RolloutSummary near = summarise(all, starts_around(model, 3));
    const RolloutSummary far = summarise(all, starts_around(model, 5));
    CHECK(near.from_above >= 0.95 * near.count);
    CHECK(far.from_above >= 0.90 * far.count);
  }
}

TEST_CASE("an exact model has the same bytes on every run, warm or cold") {
  const CellSequence expert = sample_demonstrations()[4];
  const Model cold = exactly_trained(expert);
  CHECK(exactly_trained(expert).hash() == cold.hash());
  const CellSequence moved = testing::with_moved_waypoint(cold.grid, expert, 5);
  Progress progress;
  const std::uint64_t warm = train_warm(cold, {moved}, exact(), progress).value().hash();
  CHECK(train_warm(cold, {moved}, exact(), progress).value().hash() == warm);
}

TEST_CASE("a warm start ends where a cold start ends") {
  const spatial::Grid grid;
  for (const CellSequence& expert : sample_demonstrations()) {
    const Model before = exactly_trained(expert);
    const CellSequence moved = testing::with_moved_waypoint(grid, expert, expert.size() / 2);
    Progress progress;
    const Model warm = train_warm(before, {moved}, exact(), progress).value();
    const Model cold = exactly_trained(moved);
    double apart = 0.0;
    for (std::size_t s = 0; s < warm.theta.size(); ++s)
      apart = std::max(apart, std::abs(warm.theta[s] - cold.theta[s]));
    // Both stop at a gradient of 1e-5; J is λ-strongly concave, so each θ is within 1e-5 √cells / λ ≈ 0.02 of the
    // optimum.
    CHECK(apart < 0.04);
    CHECK(warm.curve.size() < 2 * cold.curve.size());
    CHECK(greedy_policy(warm) == greedy_policy(cold));
  }
}

TEST_CASE("θ lies between its limits, is the prior outside of the safe set, and 0 at the goal") {
  const Model model = exactly_trained(sample_demonstrations()[0]);
  for (std::size_t s = 0; s < model.theta.size(); ++s) {
    if (static_cast<std::int32_t>(s) == model.goal.value) {
      CHECK(model.theta[s] == 0.0);
      continue;
    }
    REQUIRE(model.theta[s] <= exact_reward_limit());
    if (model.safe.flags()[s] == 0) REQUIRE(model.theta[s] == model.options.theta_prior);
  }
}

TEST_CASE("each exact V is the log of the sum of its e^Q") {
  const Model model = exactly_trained(sample_demonstrations()[5]);
  for (std::size_t s = 0; s < model.value.size(); ++s) {
    if (static_cast<std::int32_t>(s) == model.goal.value) continue;
    double sum = 0.0;
    for (std::size_t a = 0; a < 6; ++a) sum += std::exp(model.q[6 * s + a] - model.value[s]);
    REQUIRE(sum == doctest::Approx(1.0).epsilon(1e-8));
  }
}

TEST_CASE("a prior of −50 leaves the range of a double, and every V is finite all the same") {
  TrainOptions options = exact();
  options.theta_prior = -50.0;
  const Model model = exactly_trained(sample_demonstrations()[0], options);
  CHECK(*std::min_element(model.value.begin(), model.value.end()) < -750.0);
  CHECK(std::all_of(model.value.begin(), model.value.end(), [](double v) { return std::isfinite(v); }));
  const Basin all = basin(model, greedy_policy(model));
  CHECK(std::count(all.end.begin(), all.end.end(), RolloutEnd::kArrives) == 10648);
}

TEST_CASE("two experts with the same goal are learned together") {
  const spatial::Grid grid;
  Progress progress;
  const std::vector<CellSequence> experts{testing::approach_from_above(grid, {11, 12, 19}, {6, 18, 10}, 4, 1),
                                          testing::approach_from_above(grid, {14, 10, 18}, {6, 18, 10}, 5, 2)};
  const Model model = train(grid, experts, exact(), progress).value();
  const Basin all = basin(model, greedy_policy(model));
  CHECK(std::count(all.end.begin(), all.end.end(), RolloutEnd::kArrives) == 10648);
  for (const CellSequence& cells : experts) CHECK(model.safe.contains(cells[cells.size() / 2]));
}

TEST_CASE("exact visits are expected counts: a thousand at the goal, most along the end of the expert's path") {
  const Model model = exactly_trained(sample_demonstrations()[2]);
  CHECK(model.visits[static_cast<std::size_t>(model.goal.value)] == 1000);
  const spatial::CellIndex last = model.experts[0][model.experts[0].size() - 2];
  CHECK(model.visits[static_cast<std::size_t>(last.value)] > 800);
}
