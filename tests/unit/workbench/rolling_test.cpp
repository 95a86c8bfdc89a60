#include "engine/workbench/rolling.h"

#include <doctest/doctest.h>

#include "engine/workbench/insight.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::workbench;

namespace {

std::shared_ptr<const ModelEntry> entry_of(learning::Method method) {
  auto entry = std::make_shared<ModelEntry>();
  entry->id = {method == learning::Method::kExact ? 3 : 4};
  learning::TrainOptions options;
  options.method = method;
  options.episodes = 2000;
  Progress progress;
  entry->model = std::make_shared<const learning::Model>(
      learning::train(spatial::Grid{}, {testing::sample_demonstrations()[2]}, options, progress).value());
  return entry;
}

/// A start from which the paper's agent does not arrive.
spatial::CellIndex failing_start(const learning::Model& model) {
  const learning::Basin basin = learning::basin(model, learning::greedy_policy(model));
  for (const auto start : learning::starts_around(model, 4)) {
    // One that loops goes some way first.
    if (basin.end[static_cast<std::size_t>(start.value)] == learning::RolloutEnd::kLoops) return start;
  }
  FAIL("no start loops");
  return {};
}

}  // namespace

TEST_CASE("what was finished of random rollouts is counted, the rest is not") {
  const auto entry = entry_of(learning::Method::kExact);
  learning::MonteCarloOptions options;
  options.runs = 10;
  Progress progress;
  auto result =
      learning::monte_carlo(*entry->model, learning::starts_around(*entry->model, 2), options, progress).value();
  const MonteCarloView whole = monte_carlo_view(entry, "around:2", result);
  CHECK(whole.whole());
  CHECK(whole.runs == 1250);
  result.finished = 40;
  const MonteCarloView half = monte_carlo_view(entry, "around:2", result);
  CHECK_FALSE(half.whole());
  CHECK(half.runs == 400);
  std::int64_t arrived = 0;
  for (std::size_t i = 0; i < 40; ++i) arrived += result.arrived[i];
  CHECK(half.arrived == arrived);
  const auto interval = statistics::wilson_interval(arrived, 400);
  CHECK(half.interval.low == interval.low);
  CHECK(half.interval.high == interval.high);
}

TEST_CASE("the insight lists every start, brings out the selected one, says why it fails, and where two models part") {
  const auto paper = entry_of(learning::Method::kEgMaxent);
  const auto exact = entry_of(learning::Method::kExact);
  InsightRequest request;
  request.entry = paper;
  request.second = exact;
  request.rollouts.starts = "around:4";
  request.rollouts.selected = failing_start(*paper->model);
  InsightMaker maker;
  const auto insight = maker.make(request);
  REQUIRE(insight->listed);
  CHECK(insight->listed->size() == insight->starts.size());
  REQUIRE(insight->selected);
  CHECK(insight->selected->start == *request.rollouts.selected);
  REQUIRE(insight->why);
  CHECK(insight->why->end == insight->selected->end);
  REQUIRE(insight->second);
  CHECK(insight->second->paired.wins_a + insight->second->paired.wins_b + insight->second->paired.ties ==
        static_cast<int>(insight->starts.size()));
  CHECK(insight->second->paired.wins_b > 0);
  REQUIRE(insight->second->selected);
  CHECK(insight->second->selected->end == learning::RolloutEnd::kArrives);
  REQUIRE(insight->second->parts_at);
  const auto at = static_cast<std::size_t>(*insight->second->parts_at);
  CHECK(insight->selected->cells[at] == insight->second->selected->cells[at]);
  CHECK(insight->selected->cells[at + 1] != insight->second->selected->cells[at + 1]);
  // Another start costs the table nothing.
  request.rollouts.selected.reset();
  const auto again = maker.make(request);
  CHECK(again->listed == insight->listed);
  CHECK_FALSE(again->selected);
}

TEST_CASE("a start of another lattice is not selected, and starts that cannot be read are none with a reason") {
  InsightRequest request;
  request.entry = entry_of(learning::Method::kExact);
  request.rollouts.selected = spatial::CellIndex{44 * 44 * 44 - 1};
  request.rollouts.starts = "file:/nowhere/starts.csv";
  const auto insight = InsightMaker().make(request);
  CHECK_FALSE(insight->selected);
  CHECK(insight->starts.empty());
  CHECK_FALSE(insight->starts_error.empty());
  CHECK(insight->listed->empty());
}
