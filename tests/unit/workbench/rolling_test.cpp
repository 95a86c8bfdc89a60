#include "engine/workbench/rolling.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "engine/workbench/insight.h"
#include "engine/workbench/view_director.h"
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
  REQUIRE(insight->second->listed);
  REQUIRE(insight->second->listed->size() == insight->listed->size());
  int arrive = 0;
  for (std::size_t i = 0; i < insight->listed->size(); ++i) {
    REQUIRE((*insight->second->listed)[i].start == (*insight->listed)[i].start);
    arrive += (*insight->second->listed)[i].end == learning::RolloutEnd::kArrives ? 1 : 0;
  }
  CHECK(arrive == learning::summarise(insight->second->comparison->basin_b, insight->starts).arrived);
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
  CHECK(again->second->listed == insight->second->listed);
  CHECK_FALSE(again->selected);
}

TEST_CASE("played by steps all rollouts have taken as many, by length all are at the same share of their ways") {
  const auto entry = entry_of(learning::Method::kExact);
  const auto policy = learning::greedy_policy(*entry->model);
  const auto all = sample_rollouts(*entry->model, policy, learning::starts_around(*entry->model, 3), 300);
  const auto shorter = [](const auto& a, const auto& b) { return a.cells.size() < b.cells.size(); };
  const learning::Rollout& brief = *std::min_element(all.begin(), all.end(), shorter);
  const learning::Rollout& wide = *std::max_element(all.begin(), all.end(), shorter);
  const auto steps = [](const learning::Rollout& one) { return static_cast<double>(one.cells.size() - 1); };
  REQUIRE(steps(brief) + 2.0 < steps(wide));
  RolloutSettings settings;
  CHECK(steps_taken(wide, settings) == steps(wide));
  settings.reach = steps(brief) + 1.5;
  CHECK(steps_taken(brief, settings) == steps(brief));
  CHECK(steps_taken(wide, settings) == *settings.reach);
  settings.pace = GhostPace::kLength;
  settings.reach = 0.5;
  CHECK(steps_taken(brief, settings) == 0.5 * steps(brief));
  CHECK(steps_taken(wide, settings) == 0.5 * steps(wide));
}

TEST_CASE("what is played is drawn as far as it has come, each rollout with its head, and whole again afterwards") {
  InsightRequest request;
  request.entry = entry_of(learning::Method::kExact);
  request.rollouts.ghost_count = 20;
  PathsRequest paths;
  paths.rollouts = InsightMaker().make(request);
  REQUIRE(paths.rollouts->ghosts.size() == 20);
  PathMaker maker;
  const auto whole = maker.make(paths);
  REQUIRE(whole->size() == 20);
  paths.how.reach = 2.0;
  const auto played = maker.make(paths);
  REQUIRE(played->size() == 40);
  for (std::size_t i = 0; i < 20; ++i) {
    const stage::PathLayer& head = (*played)[2 * i];
    const stage::PathLayer& way = (*played)[2 * i + 1];
    const learning::Rollout& rollout = paths.rollouts->ghosts[i];
    REQUIRE(rollout.cells.size() > 3);
    REQUIRE(way.points.size() == 3);
    CHECK(head.radius_m > way.radius_m);
    CHECK((0.5 * (head.points.front() + head.points.back()) - way.points.back()).norm() < 1e-12);
    CHECK(way.points.back() == request.entry->model->grid.centre(rollout.cells[2]));
  }
  paths.how.reach.reset();
  CHECK(maker.make(paths) == whole);
}

TEST_CASE("ghosts outside of what is brushed step back, grey and thinner, and none is brushed without a range") {
  InsightRequest request;
  request.entry = entry_of(learning::Method::kExact);
  request.rollouts.ghost_count = 20;
  PathsRequest paths;
  paths.rollouts = InsightMaker().make(request);
  const std::vector<learning::Rollout>& ghosts = paths.rollouts->ghosts;
  PathMaker maker;
  const auto whole = maker.make(paths);
  REQUIRE(whole->size() == ghosts.size());
  const auto steps = [](const learning::Rollout& one) { return static_cast<double>(one.cells.size() - 1); };
  const double most = steps(*std::max_element(ghosts.begin(), ghosts.end(),
                                              [&](const auto& a, const auto& b) { return steps(a) < steps(b); }));
  paths.how.brushed = {{learning::RolloutMeasure::kSteps, most, most}};
  const auto brushed = maker.make(paths);
  REQUIRE(brushed->size() == ghosts.size());
  int stepped_back = 0;
  for (std::size_t i = 0; i < ghosts.size(); ++i) {
    const bool kept = steps(ghosts[i]) == most;
    CHECK((*brushed)[i].points == (*whole)[i].points);
    CHECK(((*brushed)[i].colours == (*whole)[i].colours) == kept);
    CHECK(((*brushed)[i].radius_m < (*whole)[i].radius_m) == !kept);
    stepped_back += kept ? 0 : 1;
  }
  CHECK(stepped_back > 0);
  CHECK(stepped_back < static_cast<int>(ghosts.size()));
  paths.how.brushed.clear();
  CHECK(maker.make(paths) == whole);
}

TEST_CASE("the band of rollouts has a row for each step, and too few starts have none") {
  const auto entry = entry_of(learning::Method::kExact);
  const auto starts = learning::starts_around(*entry->model, 2);
  Progress progress;
  const Result<std::string> rows = band_rows(*entry->model, starts, progress);
  REQUIRE(rows);
  CHECK(rows->find("\n0," + std::to_string(starts.size()) + ",1,") != std::string::npos);
  const auto few = band_rows(*entry->model, {starts[0], starts[1]}, progress);
  REQUIRE_FALSE(few);
  CHECK(few.error().code() == ErrorCode::kInvalidArgument);
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
