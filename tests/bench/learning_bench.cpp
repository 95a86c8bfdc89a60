// What learning costs, at Table I's size and beyond (learning, "must reach").
#include <benchmark/benchmark.h>

#include "engine/learning/model.h"
#include "engine/learning/model_comparison.h"
#include "engine/learning/monte_carlo.h"
#include "engine/learning/rollout.h"
#include "engine/learning/start_set.h"
#include "tests/support/lattice_demonstrations.h"

namespace {

using namespace trocar;
using namespace trocar::learning;

/// The same volume in finer cells: radius and spread keep their metres.
TrainOptions exact_options(int scale) {
  TrainOptions options;
  options.method = Method::kExact;
  options.safe_radius *= scale;
  options.start_spread *= scale;
  return options;
}

void exact_solve(benchmark::State& state) {
  const int scale = static_cast<int>(state.range(0)) / 22;
  const spatial::Grid grid = spatial::Grid::with_cells(22 * scale);
  const auto demonstrations = testing::sample_demonstrations(scale);
  std::size_t next = 0;
  for (auto _ : state) {
    Progress progress;
    auto model = train(grid, {demonstrations[next++ % demonstrations.size()]}, exact_options(scale), progress);
    if (!model) state.SkipWithError(model.error().text().c_str());
    benchmark::DoNotOptimize(model);
  }
}
BENCHMARK(exact_solve)->Arg(22)->Arg(44)->Arg(88)->Unit(benchmark::kMillisecond);

void exact_resolve_warm(benchmark::State& state) {
  const spatial::Grid grid;
  const auto demonstrations = testing::sample_demonstrations();
  std::vector<Model> models;
  std::vector<CellSequence> moved;
  for (const CellSequence& cells : demonstrations) {
    Progress progress;
    models.push_back(train(grid, {cells}, exact_options(1), progress).value());
    moved.push_back(testing::with_moved_waypoint(grid, cells, cells.size() / 2));
  }
  std::size_t next = 0;
  for (auto _ : state) {
    const std::size_t which = next++ % models.size();
    Progress progress;
    auto model = train_warm(models[which], {moved[which]}, exact_options(1), progress);
    if (!model) state.SkipWithError(model.error().text().c_str());
    benchmark::DoNotOptimize(model);
  }
}
BENCHMARK(exact_resolve_warm)->Arg(22)->Unit(benchmark::kMillisecond);

void eg_maxent(benchmark::State& state) {
  const spatial::Grid grid;
  const auto demonstrations = testing::sample_demonstrations();
  TrainOptions options;
  std::size_t next = 0;
  for (auto _ : state) {
    Progress progress;
    auto model = train(grid, {demonstrations[next++ % demonstrations.size()]}, options, progress);
    if (!model) state.SkipWithError(model.error().text().c_str());
    benchmark::DoNotOptimize(model);
  }
}
BENCHMARK(eg_maxent)->Name("eg_maxent_10000")->Unit(benchmark::kMillisecond);

void rollout_all_cells(benchmark::State& state) {
  Progress progress;
  const Model model =
      train(spatial::Grid{}, {testing::sample_demonstrations().front()}, exact_options(1), progress).value();
  for (auto _ : state) benchmark::DoNotOptimize(basin(model, greedy_policy(model)));
}
BENCHMARK(rollout_all_cells)->Unit(benchmark::kMillisecond);

void compare_all_cells(benchmark::State& state) {
  Progress progress;
  const auto demonstrations = testing::sample_demonstrations();
  TrainOptions greedy;
  greedy.epsilon = 0.0;
  const Model a = train(spatial::Grid{}, {demonstrations.front()}, greedy, progress).value();
  const Model b = train(spatial::Grid{}, {demonstrations.front()}, TrainOptions{}, progress).value();
  for (auto _ : state) benchmark::DoNotOptimize(compare_models(a, b));
}
BENCHMARK(compare_all_cells)->Unit(benchmark::kMillisecond);

void monte_carlo_all_cells(benchmark::State& state) {
  Progress progress;
  const Model model =
      train(spatial::Grid{}, {testing::sample_demonstrations().front()}, exact_options(1), progress).value();
  const auto starts = starts_from("all", model).value();
  MonteCarloOptions options;
  options.threads = static_cast<int>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(monte_carlo(model, starts, options, progress));
}
BENCHMARK(monte_carlo_all_cells)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
