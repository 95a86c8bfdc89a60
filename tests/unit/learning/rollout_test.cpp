#include "engine/learning/rollout.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "engine/core/random.h"
#include "engine/learning/policy.h"
#include "engine/learning/training_input.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;
using spatial::Action;
using spatial::CellIndex;

namespace {

Model trained(Method method, const CellSequence& expert, const spatial::Grid& grid = {}) {
  TrainOptions options;
  options.method = method;
  options.episodes = 2000;
  Progress progress;
  return train(grid, {expert}, options, progress).value();
}

/// A model of 3³ cells whose only path runs straight down the middle column, safe radius 0.
Model column_model() {
  const spatial::Grid grid = spatial::Grid::with_cells(3);
  TrainOptions options;
  options.safe_radius = 0;
  return untrained_model(grid, {{grid.index({1, 1, 2}), grid.index({1, 1, 1}), grid.index({1, 1, 0})}}, options);
}

/// The least sum over warpings of `a` from i and `b` from j on, and how many pairs it has, by trying all.
std::pair<double, int> warped_by_hand(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b,
                                      std::size_t i, std::size_t j) {
  const double here = (a[i] - b[j]).norm();
  if (i + 1 == a.size() && j + 1 == b.size()) return {here, 1};
  std::pair<double, int> best{1e9, 0};
  const auto take = [&](std::size_t next_i, std::size_t next_j) {
    if (next_i == a.size() || next_j == b.size()) return;
    const auto rest = warped_by_hand(a, b, next_i, next_j);
    if (rest.first < best.first) best = rest;
  };
  take(i + 1, j + 1);
  take(i + 1, j);
  take(i, j + 1);
  return {best.first + here, best.second + 1};
}

}  // namespace

TEST_CASE("distances from the expert are those that trying everything finds") {
  const Model model = column_model();
  const spatial::Grid& grid = model.grid;
  std::vector<std::uint8_t> policy(27, kNoAction);
  const auto lead = [&](spatial::CellCoordinates from, Action action) {
    policy[static_cast<std::size_t>(grid.index(from).value)] = static_cast<std::uint8_t>(action);
  };
  // Round the column and in from the side.
  lead({0, 0, 2}, Action::kMinusZ);
  lead({0, 0, 1}, Action::kMinusZ);
  lead({0, 0, 0}, Action::kPlusX);
  lead({1, 0, 0}, Action::kPlusY);
  const Rollout one = rollout(model, policy, grid.index({0, 0, 2}));
  REQUIRE(one.end == RolloutEnd::kArrives);
  std::vector<Eigen::Vector3d> way;
  std::vector<Eigen::Vector3d> expert;
  for (const CellIndex cell : one.cells) way.push_back(grid.centre(cell));
  for (const CellIndex cell : model.experts.front()) expert.push_back(grid.centre(cell));
  const double diagonal = grid.cell_m * std::sqrt(2.0);
  CHECK(one.hausdorff_m == doctest::Approx(diagonal));
  CHECK(one.frechet_m == doctest::Approx(diagonal));
  CHECK(one.max_deviation_m == doctest::Approx(diagonal));
  const auto warped = warped_by_hand(way, expert, 0, 0);
  CHECK(one.warped_m == doctest::Approx(warped.first / warped.second));
  CHECK(one.warped_m < one.hausdorff_m);
  // All but the goal are outside of a safe set of radius 0; the start is no step.
  CHECK(one.outside_steps == 3);
}

TEST_CASE("how starts end with two models is counted pair by pair") {
  Basin a;
  Basin b;
  a.end = {RolloutEnd::kArrives, RolloutEnd::kArrives, RolloutEnd::kLoops, RolloutEnd::kDeadEnd};
  b.end = {RolloutEnd::kArrives, RolloutEnd::kLoops, RolloutEnd::kArrives, RolloutEnd::kArrives};
  const OutcomeTable table = outcome_table(a, b, {{0}, {1}, {2}, {2}});
  CHECK(table[0][0] == 1);
  CHECK(table[0][1] == 1);
  CHECK(table[1][0] == 2);
  CHECK(table[2][0] == 0);
}

TEST_CASE("no method's policy ever leaves the lattice or steps out of the safe set") {
  CHECK(rc::check([] {
    const spatial::Grid grid = spatial::Grid::with_cells(*rc::gen::inRange(6, 12));
    const int top = grid.n - 1;
    const spatial::CellCoordinates start{*rc::gen::inRange(0, grid.n), *rc::gen::inRange(0, grid.n), top};
    const spatial::CellCoordinates goal{*rc::gen::inRange(0, grid.n), *rc::gen::inRange(0, grid.n), 1};
    const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1000);
    const auto method = static_cast<Method>(*rc::gen::inRange(0, 3));
    TrainOptions options;
    options.method = method;
    options.episodes = 100;
    options.safe_radius = *rc::gen::inRange(0, 3);
    Progress progress;
    const Model model =
        train(grid, {testing::approach_from_above(grid, start, goal, 3, seed)}, options, progress).value();
    const auto policy = greedy_policy(model);
    for (int cell = 0; cell < grid.cell_count(); ++cell) {
      const auto action = policy[static_cast<std::size_t>(cell)];
      if (action == kNoAction) continue;
      const auto next = grid.neighbour({cell}, static_cast<Action>(action));
      RC_ASSERT(next.has_value());
      RC_ASSERT(!model.safe.contains({cell}) || model.safe.contains(*next));
      if (method == Method::kEgMaxent) RC_ASSERT(model.safe.contains({cell}));
    }
  }));
}

TEST_CASE("a move that would leave the safe set is not taken even if its Q is the best") {
  Model model = column_model();
  model.options.method = Method::kExact;
  const auto start = static_cast<std::size_t>(model.start.value);
  model.tried[start] = 0b111111;
  for (std::size_t a = 0; a < 6; ++a) model.q[6 * start + a] = -1.0;
  model.q[6 * start + static_cast<std::size_t>(Action::kMinusZ)] = -9.0;
  CHECK(greedy_policy(model)[start] == static_cast<std::uint8_t>(Action::kMinusZ));
}

TEST_CASE("equal values are decided by the order of the actions, and the goal has none") {
  const spatial::Grid grid;
  TrainOptions options;
  Model model = untrained_model(grid, {testing::sample_demonstrations()[0]}, options);
  const auto start = static_cast<std::size_t>(model.start.value);
  model.tried[start] = 1;
  CHECK(greedy_policy(model)[start] == static_cast<std::uint8_t>(Action::kPlusX));
  model.q[6 * start] = -1.0;
  CHECK(greedy_policy(model)[start] == static_cast<std::uint8_t>(Action::kMinusX));
  model.tried.assign(model.tried.size(), 0b111111);
  CHECK(greedy_policy(model)[static_cast<std::size_t>(model.goal.value)] == kNoAction);
}

TEST_CASE("the basin says for every cell what a rollout from it does") {
  for (const Method method : {Method::kEgMaxent, Method::kEgMaxentPlus, Method::kExact}) {
    const spatial::Grid grid = spatial::Grid::with_cells(9);
    const Model model = trained(method, testing::approach_from_above(grid, {1, 1, 8}, {6, 5, 1}, 4, 2), grid);
    const auto policy = greedy_policy(model);
    const Basin all = basin(model, policy);
    for (int cell = 0; cell < grid.cell_count(); ++cell) {
      const auto s = static_cast<std::size_t>(cell);
      const Rollout one = rollout(model, policy, {cell});
      REQUIRE(one.end == all.end[s]);
      REQUIRE(one.from_above == (all.from_above[s] == 1));
      REQUIRE(all.steps[s] == (one.end == RolloutEnd::kArrives ? one.cells.size() - 1 : 0));
    }
  }
}

TEST_CASE("the basin of any policy agrees with its rollouts") {
  CHECK(rc::check([] {
    const spatial::Grid grid = spatial::Grid::with_cells(4);
    TrainOptions options;
    options.safe_radius = 1;
    const Model model =
        untrained_model(grid, {testing::approach_from_above(grid, {0, 0, 3}, {2, 1, 0}, 3, 1)}, options);
    Random random(*rc::gen::inRange<std::uint64_t>(0, 1'000'000));
    std::vector<std::uint8_t> policy(64, kNoAction);
    for (int cell = 0; cell < 64; ++cell) {
      const auto action = static_cast<std::uint8_t>(random.below(7));
      if (action < 6 && grid.neighbour({cell}, static_cast<Action>(action))) {
        policy[static_cast<std::size_t>(cell)] = action;
      }
    }
    const Basin all = basin(model, policy);
    for (int cell = 0; cell < 64; ++cell) {
      const Rollout one = rollout(model, policy, {cell});
      RC_ASSERT(one.end == all.end[static_cast<std::size_t>(cell)]);
      RC_ASSERT(one.from_above == (all.from_above[static_cast<std::size_t>(cell)] == 1));
    }
  }));
}

TEST_CASE("a rollout along the expert has no deviation, its length, and the sum of its rewards") {
  const spatial::Grid grid = spatial::Grid::with_cells(6);
  TrainOptions options;
  Model model = untrained_model(grid,
                                {{grid.index({0, 0, 4}), grid.index({1, 0, 4}), grid.index({1, 0, 3}),
                                  grid.index({1, 0, 2}), grid.index({1, 0, 1})}},
                                options);
  std::vector<std::uint8_t> policy(216, kNoAction);
  policy[static_cast<std::size_t>(model.start.value)] = static_cast<std::uint8_t>(Action::kPlusX);
  for (int z = 4; z > 1; --z) {
    policy[static_cast<std::size_t>(grid.index({1, 0, z}).value)] = static_cast<std::uint8_t>(Action::kMinusZ);
  }
  model.theta.assign(216, -0.5);
  const Rollout along = rollout(model, policy, model.start);
  CHECK(along.end == RolloutEnd::kArrives);
  CHECK(along.cells == model.experts[0]);
  CHECK(along.from_above);
  CHECK(along.length_m == doctest::Approx(4 * grid.cell_m).epsilon(1e-12));
  CHECK(along.straightness == doctest::Approx(std::sqrt(10.0) / 4.0).epsilon(1e-12));
  CHECK(along.max_deviation_m == 0.0);
  CHECK(along.frechet_m == 0.0);
  CHECK(along.divergence_step == -1);
  CHECK(along.reward_sum == -2.0);

  // From two cells aside there is no move: a dead end at 2 cells from the path, 4 from its far end.
  const Rollout aside = rollout(model, policy, grid.index({1, 2, 4}));
  CHECK(aside.end == RolloutEnd::kDeadEnd);
  CHECK(aside.max_deviation_m == doctest::Approx(2 * grid.cell_m).epsilon(1e-12));
  CHECK(aside.frechet_m == doctest::Approx(std::sqrt(13.0) * grid.cell_m).epsilon(1e-12));
  CHECK(aside.divergence_step == 0);
}

TEST_CASE("a start outside of the safe set that the model cannot leave is counted by itself, and all counts add up") {
  const Model model = column_model();
  const Basin all = basin(model, greedy_policy(model));
  CHECK(all.end[0] == RolloutEnd::kOutsideSafeSet);
  const RolloutSummary summary = summarise(all, starts_around(model, 1));
  CHECK(summary.count == 18);
  CHECK(summary.outside == 16);
  CHECK(summary.dead_end == 2);  // of the column, where nothing was learned
  const RolloutSummary whole = summarise(all, starts_around(model, 5));
  CHECK(whole.arrived + whole.looped + whole.dead_end + whole.outside == whole.count);
  CHECK(whole.dead_end > 0);
}

TEST_CASE("starts within ±k are the cells of a cube cut at the lattice's faces") {
  const Model model = trained(Method::kEgMaxent, testing::sample_demonstrations()[0]);
  CHECK(starts_around(model, 0) == std::vector<CellIndex>{model.start});
  CHECK(starts_around(model, 1).size() == 27);
  CHECK(starts_around(model, 3).size() == 7 * 7 * 6);  // the start lies two cells below the top
}

TEST_CASE("a comparison counts pairs and is its own mirror image") {
  Basin a;
  Basin b;
  for (int i = 0; i < 12; ++i) {
    a.end.push_back(i < 9 ? RolloutEnd::kArrives : RolloutEnd::kLoops);
    b.end.push_back(i == 0 || i == 11 ? RolloutEnd::kArrives : RolloutEnd::kDeadEnd);
  }
  std::vector<CellIndex> starts;
  for (int i = 0; i < 12; ++i) starts.push_back({i});
  const PairedComparison forward = compare(a, b, starts);
  CHECK(forward.wins_a == 8);
  CHECK(forward.wins_b == 1);
  CHECK(forward.ties == 3);
  CHECK(forward.mcnemar_p == doctest::Approx(2.0 * 10.0 / 512.0).epsilon(1e-12));
  CHECK(compare(b, a, starts).wins_b == 8);
}
