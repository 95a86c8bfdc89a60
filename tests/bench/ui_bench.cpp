// What a frame of the window costs: 1600 × 900, real pixels off-screen, drawn anew each time.
#include <benchmark/benchmark.h>

#include <ctime>

#include "tests/support/ui_state.h"
#include "ui/session.h"
#include "ui/window/osmesa_window.h"

namespace {

using namespace trocar;

// A picture as large as the view asks for, with something in every pixel.
std::shared_ptr<const Image> view_picture() {
  auto picture = std::make_shared<Image>(820, 490);
  for (int y = 0; y < picture->height; ++y) {
    for (int x = 0; x < picture->width; ++x) {
      picture->set(x, y, {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 90, 255});
    }
  }
  return picture;
}

void gui_frame(benchmark::State& run) {
  auto window = ui::OsmesaWindow::create({1600, 900});
  if (!window) return run.SkipWithError(window.error().text().c_str());
  (*window)->always_draw(true);
  ui::Settings settings;
  settings.scale = 1.0F;
  auto session = ui::Session::create(**window, settings);
  if (!session) return run.SkipWithError(session.error().text().c_str());
  workbench::WorkbenchState state = testing::made_state_with_model();
  state.picture = view_picture();
  state.picture_number = 1;
  const std::clock_t begin = std::clock();
  for (auto _ : run) {
    (*window)->poll(0.0);
    if (!(*session)->frame(state)) return run.SkipWithError("a frame could not be drawn");
  }
  // Of all threads: what the frame costs where others use the machine too.
  const double cpu_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  run.counters["cpu_ms"] = benchmark::Counter(1000.0 * cpu_s, benchmark::Counter::kAvgIterations);
}
BENCHMARK(gui_frame)->Name("gui_frame_1600x900")->Unit(benchmark::kMillisecond);

// The same frame again: made, found to be equal, and not drawn. Must reach 2 ms: an idle window is nearly free.
void gui_frame_unchanged(benchmark::State& run) {
  auto window = ui::OsmesaWindow::create({1600, 900});
  if (!window) return run.SkipWithError(window.error().text().c_str());
  ui::Settings settings;
  settings.scale = 1.0F;
  auto session = ui::Session::create(**window, settings);
  if (!session) return run.SkipWithError(session.error().text().c_str());
  workbench::WorkbenchState state = testing::made_state_with_model();
  state.jobs.clear();
  for (auto _ : run) {
    (*window)->poll(0.0);
    if (!(*session)->frame(state)) return run.SkipWithError("a frame could not be drawn");
  }
}
BENCHMARK(gui_frame_unchanged)->Name("gui_frame_unchanged")->Unit(benchmark::kMillisecond);

}  // namespace
