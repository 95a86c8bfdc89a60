// What the library and the history cost: frames with a thousand rows and ten thousand points (must reach: 16 ms), a
// filter over a thousand rows, and the measures of one demonstration.
#include <benchmark/benchmark.h>

#include <memory>

#include "engine/workbench/history_graph.h"
#include "engine/workbench/library_query.h"
#include "tests/support/ui_state.h"
#include "ui/session.h"
#include "ui/window/osmesa_window.h"

namespace {

using namespace trocar;

constexpr int kRows = 1000;
constexpr int kPoints = 10'000;

workbench::WorkbenchState many_rows() {
  workbench::WorkbenchState state = testing::made_state();
  auto project = std::make_shared<workbench::Project>(*state.project);
  for (int i = 10; i < 10 + kRows; ++i) {
    auto copy = std::make_shared<demonstration::Demonstration>(*project->demonstrations.begin()->second);
    copy->id = {i};
    copy->name = "Copy " + std::to_string(i);
    project->demonstrations[copy->id] = copy;
  }
  state.project = project;
  state.library = workbench::LibraryMaker().make({project, {}}, 1'000'000);
  state.library_on = true;
  return state;
}

/// Every tenth point begins a branch three points back.
workbench::WorkbenchState many_points() {
  workbench::WorkbenchState state = testing::made_state();
  state.history.clear();
  for (int id = 1; id <= kPoints; ++id) {
    const int parent = id % 10 == 0 && id > 10 ? id - 4 : id - 1;
    state.history.push_back({id, parent, "edit", "Trim Expert 1 to 0.40–12.30 s", "2026-03-01T12:03:41Z"});
  }
  state.head = kPoints;
  return state;
}

/// Frames of the Library workspace, drawn to pixels.
void frames(benchmark::State& run, workbench::WorkbenchState state) {
  auto window = ui::OsmesaWindow::create({1600, 900});
  if (!window) return run.SkipWithError(window.error().text().c_str());
  (*window)->always_draw(true);
  ui::Settings settings;
  settings.scale = 1.0F;
  settings.workspace = ui::Workspace::kLibrary;
  auto session = ui::Session::create(**window, settings);
  if (!session) return run.SkipWithError(session.error().text().c_str());
  for (auto _ : run) {
    (*window)->poll(0.0);
    if (!(*session)->frame(state)) return run.SkipWithError("a frame could not be drawn");
  }
}

void library_rows(benchmark::State& run) {
  frames(run, many_rows());
}
BENCHMARK(library_rows)->Name("gui_frame_library_1000")->Unit(benchmark::kMillisecond);

void history_points(benchmark::State& run) {
  frames(run, many_points());
}
BENCHMARK(history_points)->Name("gui_frame_history_10000")->Unit(benchmark::kMillisecond);

void graph(benchmark::State& run) {
  const workbench::WorkbenchState state = many_points();
  for (auto _ : run) benchmark::DoNotOptimize(workbench::history_graph(state.history, state.head));
}
BENCHMARK(graph)->Name("history_graph_10000")->Unit(benchmark::kMillisecond);

void filter(benchmark::State& run) {
  const workbench::WorkbenchState state = many_rows();
  for (auto _ : run) {
    const auto query = workbench::LibraryQuery::parse("jerk>0.01 and segment:C and not tag:bad or duplicate");
    std::size_t undecided = 0;
    benchmark::DoNotOptimize(workbench::matching(*state.library, *query, undecided));
  }
}
BENCHMARK(filter)->Name("library_filter_1000")->Unit(benchmark::kMillisecond);

void measures(benchmark::State& run) {
  const auto shown = testing::made_state().project->demonstrations.begin()->second;
  for (auto _ : run) benchmark::DoNotOptimize(workbench::measures_of(*shown));
}
BENCHMARK(measures)->Name("library_measures_7s")->Unit(benchmark::kMillisecond);

}  // namespace
