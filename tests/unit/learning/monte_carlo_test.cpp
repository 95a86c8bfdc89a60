#include "engine/learning/monte_carlo.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/learning/rollout.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;

namespace {

Model rolling(Method method) {
  TrainOptions options;
  options.method = method;
  options.episodes = 2000;
  Progress progress;
  return train(spatial::Grid{}, {testing::sample_demonstrations()[2]}, options, progress).value();
}

MonteCarlo rolled(const Model& model, const std::vector<spatial::CellIndex>& starts, MonteCarloOptions options) {
  Progress progress;
  return monte_carlo(model, starts, options, progress).value();
}

}  // namespace

TEST_CASE("without errors every run ends as the greedy rollout does") {
  for (const Method method : {Method::kEgMaxent, Method::kEgMaxentPlus, Method::kExact}) {
    const Model model = rolling(method);
    const auto starts = starts_around(model, 3);
    MonteCarloOptions options;
    options.epsilon = 0.0;
    options.runs = 3;
    const MonteCarlo result = rolled(model, starts, options);
    const Basin exact = basin(model, greedy_policy(model));
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const auto s = static_cast<std::size_t>(starts[i].value);
      const bool arrives = exact.end[s] == RolloutEnd::kArrives;
      REQUIRE(result.arrived[i] == (arrives ? 3 : 0));
      REQUIRE(result.steps[i] == (arrives ? 3 * exact.steps[s] : 0));
      if (arrives && exact.steps[s] >= 3) REQUIRE(result.from_above[i] == 3 * exact.from_above[s]);
    }
  }
}

TEST_CASE("the same seed gives the same counts on one and two threads and in any order of the starts") {
  const Model model = rolling(Method::kEgMaxentPlus);
  std::vector<spatial::CellIndex> starts = starts_around(model, 4);
  MonteCarloOptions options;
  options.runs = 20;
  const MonteCarlo one = rolled(model, starts, options);
  options.threads = 2;
  const MonteCarlo two = rolled(model, starts, options);
  CHECK(one.arrived == two.arrived);
  CHECK(one.steps == two.steps);
  CHECK(one.from_above == two.from_above);
  CHECK(one.finished == static_cast<int>(starts.size()));
  std::reverse(starts.begin(), starts.end());
  MonteCarlo turned = rolled(model, starts, options);
  std::reverse(turned.arrived.begin(), turned.arrived.end());
  CHECK(turned.arrived == one.arrived);
  options.seed = 2;
  CHECK(rolled(model, starts, options).steps != turned.steps);
}

TEST_CASE("errors make the exact method take longer, and it still arrives") {
  const Model model = rolling(Method::kExact);
  const auto starts = starts_around(model, 2);
  MonteCarloOptions options;
  options.runs = 50;
  options.epsilon = 0.0;
  const MonteCarlo sure = rolled(model, starts, options);
  options.epsilon = 0.2;
  const MonteCarlo erring = rolled(model, starts, options);
  std::int64_t steps_sure = 0;
  std::int64_t steps_erring = 0;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    CHECK(erring.arrived[i] == 50);
    steps_sure += sure.steps[i];
    steps_erring += erring.steps[i];
  }
  CHECK(steps_erring > steps_sure);
  const Field share = success_share(model.grid, erring);
  CHECK(share.values[static_cast<std::size_t>(model.start.value)] == 1.0);
  CHECK(std::isnan(share.values[0]));
}

TEST_CASE("what was cancelled keeps nothing that is not finished, and options out of range are refused") {
  const Model model = rolling(Method::kExact);
  Progress cancelled;
  cancelled.cancel();
  CHECK(monte_carlo(model, starts_around(model, 2), {}, cancelled)->finished == 0);
  Progress progress;
  for (const MonteCarloOptions& wrong :
       {MonteCarloOptions{1.5}, MonteCarloOptions{0.1, 0}, MonteCarloOptions{0.1, 10, 1, -1},
        MonteCarloOptions{0.1, 10, 1, 0, 0}, MonteCarloOptions{std::nan("")}}) {
    CHECK(monte_carlo(model, {model.start}, wrong, progress).error().code() == ErrorCode::kInvalidArgument);
  }
}
