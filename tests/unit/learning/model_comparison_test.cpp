#include "engine/learning/model_comparison.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;

namespace {

Model compared(Method method, double epsilon) {
  TrainOptions options;
  options.method = method;
  options.epsilon = epsilon;
  options.episodes = 2000;
  Progress progress;
  return train(spatial::Grid{}, {testing::sample_demonstrations()[0]}, options, progress).value();
}

int count_of(const Field& field, double value) {
  return static_cast<int>(std::count(field.values.begin(), field.values.end(), value));
}

}  // namespace

TEST_CASE("a model does not differ from itself") {
  const Model model = compared(Method::kEgMaxentPlus, 0.1);
  const ModelComparison same = compare_models(model, model);
  CHECK(same.policy_changed == 0);
  CHECK(same.policy_differs == 0);
  CHECK(same.paired.wins_a == 0);
  CHECK(same.paired.mcnemar_p == 1.0);
  for (const Layer layer : {Layer::kReward, Layer::kValue, Layer::kPolicy}) {
    const Field field = learning::field(model, layer);
    const Field change = difference(field, field);
    for (const double value : change.values) {
      if (std::isfinite(value)) REQUIRE(value == 0.0);
    }
  }
}

TEST_CASE("what differs is counted cell by cell, the other way round with the other sign") {
  const Model a = compared(Method::kEgMaxent, 0.0);
  const Model b = compared(Method::kEgMaxent, 0.1);
  const ModelComparison there = compare_models(a, b);
  const ModelComparison back = compare_models(b, a);
  CHECK(there.policy_differs > 0);
  CHECK(there.policy_changed == back.policy_changed);
  CHECK(there.policy_compared == back.policy_compared);
  CHECK(there.paired.wins_a == back.paired.wins_b);
  CHECK(count_of(there.policy_change, 2.0) == count_of(back.policy_change, 3.0));
  CHECK(count_of(there.policy_change, 1.0) == there.policy_differs);
  const auto policy_a = greedy_policy(a);
  const auto policy_b = greedy_policy(b);
  int changed = 0;
  for (std::size_t s = 0; s < policy_a.size(); ++s) changed += policy_a[s] != policy_b[s] ? 1 : 0;
  CHECK(changed == there.policy_changed);
  const Field of_a = field(a, Layer::kReward);
  const Field of_b = field(b, Layer::kReward);
  const Field ab = difference(of_a, of_b);
  const Field ba = difference(of_b, of_a);
  int known = 0;
  for (std::size_t s = 0; s < ab.values.size(); ++s) {
    REQUIRE(std::isnan(ab.values[s]) == (std::isnan(of_a.values[s]) || std::isnan(of_b.values[s])));
    if (std::isnan(ab.values[s])) continue;
    REQUIRE(ab.values[s] == -ba.values[s]);
    ++known;
  }
  CHECK(known > 100);
}

TEST_CASE("classes differ or not, and every start has one of four outcomes") {
  const Model a = compared(Method::kEgMaxent, 0.1);
  const Model b = compared(Method::kExact, 0.0);
  const Field change = difference(field(a, Layer::kBasin), field(b, Layer::kBasin));
  CHECK(change.categorical);
  const ModelComparison both = compare_models(a, b);
  const Field outcomes = paired_outcomes(a.grid, both.basin_a, both.basin_b);
  CHECK(count_of(outcomes, 2.0) == both.paired.wins_b);
  CHECK(count_of(outcomes, 1.0) == both.paired.wins_a);
  CHECK(count_of(outcomes, 0.0) + count_of(outcomes, 3.0) == both.paired.ties);
  CHECK(both.b.all.arrived == 10648);
  CHECK(both.a.around[0].count == both.b.around[0].count);
}
