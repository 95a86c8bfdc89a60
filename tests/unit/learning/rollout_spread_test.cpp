#include "engine/learning/rollout_spread.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;

namespace {

Model spreading(Method method) {
  TrainOptions options;
  options.method = method;
  options.episodes = 2000;
  Progress progress;
  return train(spatial::Grid{}, {testing::sample_demonstrations()[2]}, options, progress).value();
}

std::vector<Rollout> followed(const Model& model, const std::vector<spatial::CellIndex>& starts) {
  const auto policy = greedy_policy(model);
  std::vector<Rollout> rollouts;
  for (const auto start : starts) rollouts.push_back(rollout(model, policy, start));
  return rollouts;
}

}  // namespace

TEST_CASE("the band holds the middle one of the deviations, step by step") {
  const Model model = spreading(Method::kEgMaxentPlus);
  const auto rollouts = followed(model, starts_around(model, 2));
  const DeviationBand band = spread_of_rollouts(model, rollouts, {}).band;
  REQUIRE_FALSE(band.median.empty());
  CHECK(band.count.front() == static_cast<int>(rollouts.size()));
  for (std::size_t step = 0; step < band.median.size(); ++step) {
    REQUIRE(band.low[step] <= band.lower[step]);
    REQUIRE(band.lower[step] <= band.median[step]);
    REQUIRE(band.median[step] <= band.upper[step]);
    REQUIRE(band.upper[step] <= band.high[step]);
    // Those that take at least so many steps.
    REQUIRE(band.count[step] == std::count_if(rollouts.begin(), rollouts.end(),
                                              [step](const auto& one) { return one.cells.size() > step; }));
    REQUIRE(band.count[step] >= kLeastInBand);
  }
  // At the start: how far the starts are from the expert's cells, by hand.
  std::vector<double> first;
  for (const Rollout& one : rollouts) {
    double nearest = 1e9;
    for (const auto cell : model.experts.front()) {
      nearest = std::min(nearest, (model.grid.centre(cell) - model.grid.centre(one.start)).norm());
    }
    first.push_back(nearest);
  }
  std::sort(first.begin(), first.end());
  CHECK(band.median.front() == doctest::Approx(first[first.size() / 2]));
  CHECK(spread_of_rollouts(model, {rollouts.front()}, {}).band.median.empty());
}

TEST_CASE("the band as rows says what it holds, and how many still go on") {
  DeviationBand band;
  band.low = {0.0, 0.001};
  band.lower = {0.001, 0.002};
  band.median = {0.002, 0.0025};
  band.upper = {0.003, 0.004};
  band.high = {0.01, 0.0125};
  band.count = {8, 6};
  CHECK(band_csv(band) ==
        "step,n,share,p05_mm,p25_mm,median_mm,p75_mm,p95_mm\n0,8,1,0,1,2,3,10\n1,6,0.75,1,2,2.5,4,12.5\n");
}

TEST_CASE("the spread of values is known by hand, and what is not finite is left out") {
  const Spread spread = spread_of({4.0, 1.0, std::nan(""), 3.0, 2.0, 5.0});
  CHECK(spread.count == 5);
  CHECK(spread.least == 1.0);
  CHECK(spread.low == 2.0);
  CHECK(spread.median == 3.0);
  CHECK(spread.high == 4.0);
  CHECK(spread.most == 5.0);
  CHECK(spread_of({1.0, 2.0}).median == 1.5);
  CHECK(spread_of({std::nan("")}).count == 0);
}

TEST_CASE("what rollouts come to is told apart by how they end, and the same whether they are kept or not") {
  const Model model = spreading(Method::kEgMaxent);
  const auto starts = starts_around(model, 3);
  const auto rollouts = followed(model, starts);
  Progress progress;
  const std::vector<double> clearance_m(static_cast<std::size_t>(model.grid.cell_count()), 0.004);
  const RolloutSpread spread = spread_from(model, greedy_policy(model), starts, clearance_m, progress).value();
  const RolloutSpread kept = spread_of_rollouts(model, rollouts, clearance_m);
  CHECK(spread.starts == starts.size());
  CHECK(spread.band.median == kept.band.median);
  CHECK(spread.band.count == kept.band.count);
  const std::vector<RolloutMeasure> measures = spread_measures();
  CHECK(spread_csv_rows("m", spread, measures) == spread_csv_rows("m", kept, measures));
  for (const RolloutMeasure of : measures) {
    for (const RolloutEnd end : {RolloutEnd::kArrives, RolloutEnd::kLoops}) {
      std::vector<double> values;
      for (const Rollout& one : rollouts) {
        const double value = measure(one, of, model.grid, clearance_m);
        const bool never = of == RolloutMeasure::kDivergence && value < 0.0;
        if (one.end == end && !never) values.push_back(value);
      }
      const Spread by_hand = spread_of(values);
      CAPTURE(words_of(of).word);
      REQUIRE(spread.of(of, end).spread.count == by_hand.count);
      REQUIRE(spread.of(of, end).spread.median == by_hand.median);
      REQUIRE(spread.of(of, end).spread.most == by_hand.most);
      REQUIRE(spread.of(of, end).some.size() == std::min<std::size_t>(values.size(), kMostPoints));
    }
  }
  CHECK(spread.of(RolloutMeasure::kMaxDeviation, RolloutEnd::kLoops).spread.count > 0);
}

TEST_CASE("the numbers of boxes are rows in the unit of their measure, with the model's name as it is") {
  RolloutSpread spread;
  const auto at = static_cast<std::size_t>(RolloutMeasure::kMaxDeviation);
  spread.by_end[at][1] = {{3, 0.001, 0.002, 0.003, 0.004, 0.005}, {}};
  CHECK(spread_csv_header() + spread_csv_rows("a, \"b\"", spread, {RolloutMeasure::kMaxDeviation}) ==
        "model,measure,unit,end,n,least,p25,median,p75,most\n\"a, \"\"b\"\"\",max_deviation,mm,loops,3,1,2,3,4,5\n");
}

TEST_CASE("starts are taken evenly, and a spread that is stopped says so") {
  std::vector<spatial::CellIndex> starts;
  for (int i = 0; i < 10; ++i) starts.push_back({i});
  CHECK(evenly(starts, 10) == starts);
  CHECK(evenly(starts, 99) == starts);
  CHECK(evenly(starts, 5) == std::vector<spatial::CellIndex>{{0}, {2}, {4}, {6}, {8}});
  const Model model = spreading(Method::kExact);
  Progress progress;
  progress.cancel();
  const auto stopped = spread_from(model, greedy_policy(model), starts, {}, progress);
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().code() == ErrorCode::kCancelled);
}
