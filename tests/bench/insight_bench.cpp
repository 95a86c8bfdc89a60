// What the window does while a waypoint is dragged: the exact model is solved again on the demonstration as it would
// become, and field, policy, success map and rollouts follow (must reach: 16 ms for the solving).
#include <benchmark/benchmark.h>

#include <memory>

#include "engine/demonstration/edits.h"
#include "engine/workbench/insight.h"
#include "engine/workbench/jobs/train_job.h"
#include "tests/support/recorded_transfer.h"

namespace {

using namespace trocar;

using Shown = std::shared_ptr<const demonstration::Demonstration>;

/// The approach with a waypoint in its middle moved aside, by another step each time.
std::vector<Shown> dragged(const Shown& shown, int count) {
  std::vector<Shown> steps;
  const auto span = shown->segment(demonstration::Segment::kA);
  for (int i = 1; i <= count; ++i) {
    demonstration::MoveTool move;
    move.at_s = 0.5 * (span->begin_s + span->end_s);
    move.by_m = {0.0, 1e-3 * i, 0.0};
    steps.push_back(
        std::make_shared<const demonstration::Demonstration>(demonstration::transformed(*shown, move, 0).value()));
  }
  return steps;
}

void drag_waypoint(benchmark::State& state) {
  const auto shown = std::make_shared<const demonstration::Demonstration>(testing::transfer(1));
  workbench::Project project;
  project.demonstrations[shown->id] = shown;
  workbench::TrainModel request;
  request.demonstrations = {shown->id};
  request.options.method = learning::Method::kExact;
  Progress progress;
  workbench::ModelEntry entry = workbench::train_model(project, request, progress).value();
  entry.id = {7};
  workbench::InsightRequest wanted;
  wanted.entry = std::make_shared<const workbench::ModelEntry>(std::move(entry));
  workbench::InsightMaker maker;
  benchmark::DoNotOptimize(maker.make(wanted));
  const std::vector<Shown> steps = dragged(shown, 8);
  std::size_t next = 0;
  double worst_s = 0.0;
  for (auto _ : state) {
    wanted.experts = {steps[next++ % steps.size()]};
    const auto insight = maker.make(wanted);
    if (!insight->following || !insight->following->error.empty()) state.SkipWithError("it did not follow");
    worst_s = std::max(worst_s, insight->following->seconds);
  }
  state.counters["solving_worst_ms"] = 1e3 * worst_s;
}
BENCHMARK(drag_waypoint)->Name("retrain_while_dragging_22")->Unit(benchmark::kMillisecond);

}  // namespace
