#include "engine/learning/rollout_table.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "engine/learning/start_file.h"
#include "engine/statistics/proportion.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;

namespace {

Model listed(Method method = Method::kEgMaxentPlus) {
  TrainOptions options;
  options.method = method;
  options.episodes = 2000;
  Progress progress;
  return train(spatial::Grid{}, {testing::sample_demonstrations()[2]}, options, progress).value();
}

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::string field;
    for (const char c : line + ",") {
      if (c != ',') {
        field += c;
        continue;
      }
      rows.back().push_back(field);
      field.clear();
    }
  }
  return rows;
}

std::string csv_for(const Model& model, const std::vector<spatial::CellIndex>& starts, RolloutTableOptions options) {
  Progress progress;
  return rollout_csv(model, greedy_policy(model), starts, options, progress).value();
}

std::vector<Rollout> rolled_out(const Model& model, const std::vector<spatial::CellIndex>& starts) {
  const auto policy = greedy_policy(model);
  std::vector<Rollout> rollouts;
  for (const auto start : starts) rollouts.push_back(rollout(model, policy, start));
  return rollouts;
}

}  // namespace

TEST_CASE("every start has one row with as many fields as the header, and the rows name the starts again") {
  const Model model = listed();
  const auto starts = starts_around(model, 2);
  const std::vector<double> clearance(static_cast<std::size_t>(model.grid.cell_count()), 0.004);
  const std::string csv = csv_for(model, starts, {clearance, nullptr});
  const auto rows = rows_of(csv);
  REQUIRE(rows.size() == starts.size() + 1);
  for (const auto& row : rows) REQUIRE(row.size() == rows.front().size());
  CHECK(std::count(rows.front().begin(), rows.front().end(), "hausdorff_mm") == 1);
  CHECK(std::count(rows.front().begin(), rows.front().end(), "dtw_mm") == 1);
  CHECK(rows.front().back() == "clearance_mm");
  CHECK(rows[1].back() == "4");
  CHECK(parse_starts(csv, model.grid).value() == starts);
}

TEST_CASE("what is not known is an empty field") {
  const Model model = listed();
  const auto rows = rows_of(csv_for(model, {model.start}, {}));
  CHECK(rows[1].back().empty());
}

TEST_CASE("the columns of random rollouts hold the counts and Wilson's interval, and nothing for starts not finished") {
  const Model model = listed();
  const auto starts = starts_around(model, 1);
  MonteCarloOptions options;
  options.runs = 20;
  Progress progress;
  MonteCarlo erring = monte_carlo(model, starts, options, progress).value();
  erring.finished = 5;
  const auto rows = rows_of(csv_for(model, starts, {{}, &erring}));
  const std::size_t at = rows.front().size() - 5;
  CHECK(rows.front()[at - 1] == "runs");
  CHECK(rows.front()[at] == "runs_arrived");
  CHECK(rows.front()[at + 4] == "mean_steps");
  CHECK(rows[1][at - 1] == "20");
  CHECK(rows[1][at] == std::to_string(erring.arrived[0]));
  const auto interval = statistics::wilson_interval(erring.arrived[0], 20);
  CHECK(std::stod(rows[1][at + 2]) == doctest::Approx(interval.low).epsilon(1e-5));
  CHECK(std::stod(rows[1][at + 3]) == doctest::Approx(interval.high).epsilon(1e-5));
  for (const auto& row : rows) REQUIRE(row.size() == rows.front().size());
  for (std::size_t i = at - 1; i < rows.front().size(); ++i) CHECK(rows[6][i].empty());
  CHECK_FALSE(rows[5][at].empty());
}

TEST_CASE("a rollout is from above exactly where its last three moves are down") {
  const Model model = listed(Method::kExact);
  int above = 0;
  for (const Rollout& one : rolled_out(model, starts_around(model, 3))) {
    const bool down = last_moves(model.grid, one.cells) == "-z -z -z";
    CHECK(down == one.from_above);
    above += one.from_above ? 1 : 0;
  }
  CHECK(above > 0);
  CHECK(last_moves(model.grid, {model.goal}).empty());
}

TEST_CASE("sorting goes by the measure, in both directions, with unknown ones last and ties in their order") {
  const Model model = listed();
  const auto rollouts = rolled_out(model, starts_around(model, 2));
  for (int m = 0; m < kRolloutMeasures; ++m) {
    const auto by = static_cast<RolloutMeasure>(m);
    for (const bool descending : {false, true}) {
      const auto order = sorted_by(rollouts, by, descending, model.grid, {});
      REQUIRE(order.size() == rollouts.size());
      for (std::size_t i = 0; i + 1 < order.size(); ++i) {
        const double a = measure(rollouts[order[i]], by, model.grid, {});
        const double b = measure(rollouts[order[i + 1]], by, model.grid, {});
        if (std::isnan(a) || a == b) {
          REQUIRE(order[i] < order[i + 1]);
        } else {
          REQUIRE((descending ? a > b : a < b));
        }
      }
    }
  }
}

TEST_CASE("a rollout lies in ranges if every measure does, and what is not known lies in none") {
  const Model model = listed();
  const auto rollouts = rolled_out(model, starts_around(model, 2));
  const Rollout& one = rollouts.front();
  const auto steps = static_cast<double>(one.cells.size() - 1);
  const RolloutRange of_steps{RolloutMeasure::kSteps, steps, steps};
  CHECK(lies_in(one, {}, model.grid, {}));
  CHECK(lies_in(one, {of_steps}, model.grid, {}));
  CHECK_FALSE(lies_in(one, {{RolloutMeasure::kSteps, steps + 0.5, steps + 9.0}}, model.grid, {}));
  CHECK_FALSE(lies_in(one, {of_steps, {RolloutMeasure::kReward, 1e6, 2e6}}, model.grid, {}));
  CHECK_FALSE(lies_in(one, {{RolloutMeasure::kClearance, -1e6, 1e6}}, model.grid, {}));
}

TEST_CASE("arrivals grow step by step to what arrives at all, each rollout counted from its own last step on") {
  const Model model = listed(Method::kEgMaxent);
  const auto starts = starts_around(model, 3);
  const Basin outcomes = basin(model, greedy_policy(model));
  const std::vector<int> by_step = arrivals_by_step(outcomes, starts);
  const auto rollouts = rolled_out(model, starts);
  REQUIRE(by_step.size() > 1);
  for (std::size_t step = 0; step < by_step.size(); ++step) {
    const auto within = std::count_if(rollouts.begin(), rollouts.end(), [step](const Rollout& one) {
      return one.end == RolloutEnd::kArrives && one.cells.size() - 1 <= step;
    });
    REQUIRE(by_step[step] == within);
  }
  CHECK(by_step.back() == summarise(outcomes, starts).arrived);
  CHECK(by_step[by_step.size() - 2] < by_step.back());
  CHECK(by_step.back() < static_cast<int>(starts.size()));
  CHECK(arrivals_by_step(outcomes, {}) == std::vector<int>{0});
}

TEST_CASE("a way until a step has its cells, a part of the next one, and ends where the rollout ends") {
  const Model model = listed(Method::kExact);
  const Rollout one = rolled_out(model, {model.start}).front();
  REQUIRE(one.cells.size() > 4);
  CHECK(way_until(one, model.grid, -1.0).size() == 1);
  const auto part = way_until(one, model.grid, 2.25);
  REQUIRE(part.size() == 4);
  const Eigen::Vector3d second = model.grid.centre(one.cells[2]);
  const Eigen::Vector3d third = model.grid.centre(one.cells[3]);
  CHECK((part[2] - second).norm() == 0.0);
  CHECK((part[3] - second).norm() == doctest::Approx(0.25 * model.grid.cell_m));
  CHECK((part[3] - third).norm() == doctest::Approx(0.75 * model.grid.cell_m));
  const auto whole = way_until(one, model.grid, 1e9);
  CHECK(whole.size() == one.cells.size());
  CHECK((whole.back() - model.grid.centre(model.goal)).norm() == 0.0);
}

TEST_CASE("a table that is cancelled is none") {
  const Model model = listed();
  Progress progress;
  progress.cancel();
  CHECK(rollout_csv(model, greedy_policy(model), {model.start}, {}, progress).error().code() == ErrorCode::kCancelled);
}
