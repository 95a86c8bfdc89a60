#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/learning/model.h"
#include "engine/learning/rollout.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;
using trocar::testing::sample_demonstrations;

namespace {

Model trained(const CellSequence& expert, const TrainOptions& options) {
  Progress progress;
  return train(spatial::Grid{}, {expert}, options, progress).value();
}

TrainOptions paper(double epsilon, std::uint64_t seed, int episodes = 10000) {
  TrainOptions options;
  options.method = Method::kEgMaxent;
  options.epsilon = epsilon;
  options.seed = seed;
  options.episodes = episodes;
  return options;
}

TrainOptions product() {
  TrainOptions options;
  options.method = Method::kEgMaxentPlus;
  return options;
}

}  // namespace

TEST_CASE("the defaults are the paper's hyperparameters") {  // Table I
  const TrainOptions options;
  CHECK(options.theta_rate == 0.3);
  CHECK(options.q_rate == 0.3);
  CHECK(options.discount == 0.99);
  CHECK(options.epsilon <= 0.1);
  CHECK(spatial::Grid{}.cell_count() == 10648);
}

TEST_CASE("ε = 0.1 explores more states fully and leaves fewer untouched than ε = 0, for each of 20 seeds") {  // V.A
  const auto demonstrations = sample_demonstrations();
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const CellSequence& expert = demonstrations[seed % demonstrations.size()];
    const Exploration with = exploration(trained(expert, paper(0.1, seed)));
    const Exploration without = exploration(trained(expert, paper(0.0, seed)));
    CAPTURE(seed);
    CHECK(with.fully_explored > without.fully_explored);
    CHECK(with.fully_unexplored < without.fully_unexplored);
  }
}

TEST_CASE("the classes of exploration cover every state but the goal") {
  const Exploration counts = exploration(trained(sample_demonstrations()[0], paper(0.1, 1, 200)));
  CHECK(counts.fully_explored + counts.partly_explored + counts.fully_unexplored == 10647);
}

TEST_CASE("θ never rises above 0 in the paper's mode, nor above −0.2 in the product's") {
  const CellSequence expert = sample_demonstrations()[3];
  const Model by_paper = trained(expert, paper(0.1, 5));
  CHECK(*std::max_element(by_paper.theta.begin(), by_paper.theta.end()) <= 0.0);
  const Model by_product = trained(expert, product());
  CHECK(*std::max_element(by_product.theta.begin(), by_product.theta.end()) <= -0.2);
}

TEST_CASE("in the paper's mode V is the largest Q of each cell") {
  const Model model = trained(sample_demonstrations()[1], paper(0.1, 2, 2000));
  for (std::size_t s = 0; s < model.value.size(); ++s) {
    const auto q = model.q.begin() + static_cast<std::ptrdiff_t>(6 * s);
    REQUIRE(model.value[s] == *std::max_element(q, q + 6));
  }
}

TEST_CASE("one episode without exploration obeys equations (1) and (2)") {
  // Two cells: the only start leads to the goal by +x; all other moves from it leave a lattice of 2 or lead elsewhere.
  spatial::Grid grid = spatial::Grid::with_cells(2);
  TrainOptions options = paper(0.0, 9, 1);
  Progress progress;
  const CellSequence expert{grid.index({0, 0, 0}), grid.index({1, 0, 0})};
  const Model model = train(grid, {expert}, options, progress).value();
  // T = floor(1.25 · 2) = 2 steps at most, so the visits are 2 or 3, the start's own included.
  std::uint32_t visits = 0;
  for (const std::uint32_t count : model.visits) visits += count;
  CHECK(visits >= 2);
  CHECK(visits <= 3);
  Random random(9);
  std::vector<double> theta(8);
  for (double& value : theta) value = -random.uniform();
  for (std::size_t s = 0; s < 8; ++s) {
    const double f = s == 0 || s == static_cast<std::size_t>(expert[1].value) ? 1.0 : 0.0;
    const bool touched = f > 0.0 || model.visits[s] > 0;
    const double expected = touched ? std::min(0.0, theta[s] + 0.3 * (f - model.visits[s])) : theta[s];
    CHECK(model.theta[s] == expected);
  }
  // The first step was taken with Q = 0 everywhere: Q(start, a) = α θ(start).
  int changed = 0;
  for (std::size_t a = 0; a < 6; ++a) {
    if (model.q[a] == 0.0) continue;
    ++changed;
    CHECK(model.q[a] == doctest::Approx(0.3 * theta[0]).epsilon(1e-15));
  }
  CHECK(changed >= 1);
}

TEST_CASE("the product's mode arrives from every start within ±3 cells, mostly from above") {
  for (const CellSequence& expert : sample_demonstrations()) {
    const Model model = trained(expert, product());
    const RolloutSummary summary = summarise(basin(model, greedy_policy(model)), starts_around(model, 3));
    CHECK(summary.arrived == summary.count);
    CHECK(summary.from_above >= 0.9 * summary.arrived);
  }
}

TEST_CASE("the same seed gives the same bytes, another seed others") {
  const CellSequence expert = sample_demonstrations()[2];
  for (TrainOptions options : {paper(0.1, 4, 3000), product()}) {
    options.episodes = 3000;
    const std::uint64_t first = trained(expert, options).hash();
    CHECK(trained(expert, options).hash() == first);
    options.seed += 1;
    CHECK(trained(expert, options).hash() != first);
  }
}

TEST_CASE("the curve has one mismatch for each hundred episodes, the rest in a last one") {
  const Model model = trained(sample_demonstrations()[0], paper(0.1, 1, 1050));
  CHECK(model.curve.size() == 11);
  CHECK(std::all_of(model.curve.begin(), model.curve.end(), [](double y) { return std::isfinite(y) && y >= 0.0; }));
}
