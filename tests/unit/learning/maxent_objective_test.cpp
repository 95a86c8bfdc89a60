#include "engine/learning/maxent_objective.h"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/learning/bounded_minimiser.h"
#include "engine/learning/policy.h"
#include "engine/learning/training_input.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;

namespace {

TrainOptions exact_options() {
  TrainOptions options;
  options.method = Method::kExact;
  options.safe_radius = 1;  // leaves some of a small lattice outside
  return options;
}

Model untrained(int cells) {
  const spatial::Grid grid = spatial::Grid::with_cells(cells);
  return untrained_model(grid, {testing::approach_from_above(grid, {0, 1, cells - 1}, {cells - 2, 1, 0}, 2, 3)},
                         exact_options());
}

/// Transition weights e^θ(s) of every allowed move, the goal absorbing, as a matrix over all cells.
Eigen::MatrixXd transitions(const Model& model) {
  const auto count = static_cast<Eigen::Index>(model.theta.size());
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(count, count);
  for (int cell = 0; cell < model.grid.cell_count(); ++cell) {
    if (cell == model.goal.value) continue;
    for (int a = 0; a < spatial::kActionCount; ++a) {
      const auto next = model.grid.neighbour({cell}, static_cast<spatial::Action>(a));
      if (!next || (model.safe.contains({cell}) && !model.safe.contains(*next))) continue;
      weights(cell, next->value) = std::exp(model.theta[static_cast<std::size_t>(cell)]);
    }
  }
  return weights;
}

Eigen::VectorXd dense_partition(const Model& model) {
  const Eigen::MatrixXd weights = transitions(model);
  const Eigen::MatrixXd system = Eigen::MatrixXd::Identity(weights.rows(), weights.cols()) - weights;
  return system.partialPivLu().solve(Eigen::VectorXd::Unit(weights.rows(), model.goal.value));
}

std::vector<double> random_reward(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> theta(count);
  for (double& value : theta) value = random.uniform(-5.0, exact_reward_limit());
  return theta;
}

}  // namespace

TEST_CASE("V of an exact model is log Z of a dense linear solve on 5³ and 7³, inside and outside of the safe set") {
  for (const int cells : {5, 7}) {
    CAPTURE(cells);
    const spatial::Grid grid = spatial::Grid::with_cells(cells);
    Progress progress;
    const Model model = train(grid, untrained(cells).experts, exact_options(), progress).value();
    REQUIRE(model.safe.count() < grid.cell_count());
    const Eigen::VectorXd partition = dense_partition(model);
    for (int cell = 0; cell < grid.cell_count(); ++cell) {
      CHECK(model.value[static_cast<std::size_t>(cell)] ==
            doctest::Approx(std::log(partition[cell])).epsilon(1e-9).scale(1.0));
    }
  }
}

namespace {

void check_visits(int cells) {
  Model model = untrained(cells);
  const int count = model.grid.cell_count();
  const std::vector<double> guess(model.theta.size(), -3.0);
  MaxentObjective objective(model, guess);
  const MaxentRegion& region = objective.region();
  const std::vector<double> theta = random_reward(region.count(), 4);
  std::vector<double> gradient(region.count());
  objective.evaluate(theta, gradient, 1e-13);

  model.theta.assign(static_cast<std::size_t>(count),
                     -3.0);  // outside of the safe set any contraction will do: no path goes there
  Eigen::VectorXd starts = Eigen::VectorXd::Zero(count);
  for (std::size_t i = 0; i < region.count(); ++i) {
    model.theta[static_cast<std::size_t>(region.cells()[i])] = theta[i];
    starts[region.cells()[i]] = objective.starts()[i];
  }
  const Eigen::VectorXd partition = dense_partition(model);
  Eigen::MatrixXd policy = transitions(model);
  for (int s = 0; s < count; ++s) {
    for (int t = 0; t < count; ++t) policy(s, t) *= partition[t] / partition[s];
  }
  const Eigen::MatrixXd system = Eigen::MatrixXd::Identity(count, count) - policy.transpose();
  const Eigen::VectorXd visits = system.partialPivLu().solve(starts);
  for (std::size_t i = 0; i < region.count(); ++i) {
    CHECK(region.visits()[i] == doctest::Approx(visits[region.cells()[i]]).epsilon(1e-9).scale(1.0));
  }
  CHECK(region.visits()[0] == doctest::Approx(1.0).epsilon(1e-9));  // every path arrives once
}

}  // namespace

TEST_CASE("expected visits are those of a dense linear solve on 5³ and 7³") {
  check_visits(5);
  check_visits(7);
}

TEST_CASE("the gradient is that of finite differences") {
  const Model model = untrained(4);
  MaxentObjective objective(model, std::vector<double>(model.theta.size(), -3.0));
  const std::size_t count = objective.region().count();
  std::vector<double> theta = random_reward(count, 8);
  std::vector<double> gradient(count);
  std::vector<double> ignored(count);
  objective.evaluate(theta, gradient, 1e-14);
  constexpr double kStep = 1e-4;  // truncation h² ~ 1e-8 against rounding 1e-14 / h ~ 1e-10
  for (std::size_t i = 1; i < count; ++i) {
    const double middle = theta[i];
    theta[i] = middle + kStep;
    const double above = objective.evaluate(theta, ignored, 1e-14);
    theta[i] = middle - kStep;
    const double below = objective.evaluate(theta, ignored, 1e-14);
    theta[i] = middle;
    CHECK(gradient[i] == doctest::Approx((above - below) / (2.0 * kStep)).epsilon(1e-6).scale(1.0));
  }
}

TEST_CASE("the likelihood never falls from one accepted step to the next") {
  const spatial::Grid grid;
  const Model model = untrained_model(grid, {testing::sample_demonstrations()[0]}, TrainOptions{});
  MaxentObjective objective(model, std::vector<double>(model.theta.size(), -6.0));
  const BoundedFunction function = [&](const std::vector<double>& x, std::vector<double>& gradient,
                                       std::vector<double>& curvature) {
    const double value = objective.evaluate(x, gradient, 1e-11);
    for (double& entry : gradient) entry = -entry;
    std::fill(curvature.begin(), curvature.end(), 0.05);
    return -value;
  };
  std::vector<double> theta(objective.region().count(), -6.0);
  BoundedOptions options;
  options.low = lowest_reward();
  options.high = exact_reward_limit();
  options.tolerance = 1e-4;
  const BoundedResult result = minimise(
                                   function, options, theta, [](double) {}, Progress{})
                                   .value();
  REQUIRE(result.values.size() > 5);
  CHECK(result.gradient <= 1e-4);
  CHECK(std::is_sorted(result.values.rbegin(), result.values.rend()));
}

TEST_CASE("a bounded quadratic is minimised at the bound where its middle lies beyond") {
  const std::vector<double> middle{-2.0, 0.25, 0.5, 3.0};
  const BoundedFunction function = [&](const std::vector<double>& x, std::vector<double>& gradient,
                                       std::vector<double>& curvature) {
    double value = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double stiffness = static_cast<double>(i + 1) * static_cast<double>(i + 1);
      value += 0.5 * stiffness * (x[i] - middle[i]) * (x[i] - middle[i]);
      gradient[i] = stiffness * (x[i] - middle[i]);
      curvature[i] = 1.0;
    }
    return value;
  };
  std::vector<double> x(4, 0.9);
  BoundedOptions options;
  options.tolerance = 1e-9;
  CHECK(minimise(
            function, options, x, [](double) {}, Progress{})
            .value()
            .gradient <= 1e-9);
  CHECK(x[0] == 0.0);
  CHECK(x[1] == doctest::Approx(0.25).epsilon(1e-7));
  CHECK(x[2] == doctest::Approx(0.5).epsilon(1e-7));
  CHECK(x[3] == 1.0);
}
