// What a frame of the window costs: 1600 × 900, real pixels off-screen, drawn anew each time.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <thread>
#include <vector>

#include "engine/core/clock.h"
#include "engine/film/composition.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/ui_state.h"
#include "ui/application.h"
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
  // Without one a spinner turns, and no two frames are equal.
  state.picture = view_picture();
  state.picture_number = 1;
  for (auto _ : run) {
    (*window)->poll(0.0);
    if (!(*session)->frame(state)) return run.SkipWithError("a frame could not be drawn");
  }
}
BENCHMARK(gui_frame_unchanged)->Name("gui_frame_unchanged")->Unit(benchmark::kMillisecond);

// The window while the simulator runs at 1 kHz and is recorded: every frame drawn, as fast as they come, for 5 s.
// Must reach 30 frames a second on average.
void gui_live(benchmark::State& run) {
  auto window = ui::OsmesaWindow::create({1600, 900});
  if (!window) return run.SkipWithError(window.error().text().c_str());
  (*window)->always_draw(true);
  const testing::ScratchFolder folder;
  workbench::Workbench workbench({});
  workbench.post(workbench::OpenProject{folder.path() / "live.trocar", true});
  if (!workbench.wait_idle(20.0)) return run.SkipWithError("the project was not made");
  ui::Settings settings;
  settings.scale = 1.0F;
  auto application = ui::Application::create(**window, workbench, settings);
  if (!application) return run.SkipWithError(application.error().text().c_str());
  const SystemClock clock;
  std::vector<double> frames_s;
  for (auto _ : run) {
    workbench.post(workbench::RecordScripted{{}, "Live", true});
    const double begin_s = clock.now_s();
    for (double last_s = begin_s; last_s < begin_s + 5.0;) {
      if (!(*application)->step(0.0)) return run.SkipWithError("a frame could not be drawn");
      const double now_s = clock.now_s();
      frames_s.push_back(now_s - last_s);
      last_s = now_s;
    }
    workbench.post(workbench::StopRecording{false});
    if (!workbench.wait_idle(20.0)) return run.SkipWithError("the recording did not end");
  }
  const auto nth = frames_s.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(frames_s.size()));
  std::nth_element(frames_s.begin(), nth, frames_s.end());
  run.counters["frames_per_s"] = static_cast<double>(frames_s.size()) / (5.0 * static_cast<double>(run.iterations()));
  run.counters["p95_ms"] = 1e3 * *nth;
}
BENCHMARK(gui_live)->Name("gui_live_1600x900")->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

/// Waits for what was posted; false if the last job failed or it takes too long.
bool done(workbench::Workbench& workbench) {
  if (!workbench.wait_idle(120.0)) return false;
  const auto& jobs = workbench.state().jobs;
  return jobs.empty() || jobs.front().state == workbench::JobState::kDone;
}

/// Ten seconds of a demonstration, once or beside itself.
bool prepare(workbench::Workbench& workbench, film::Composition& film, std::size_t sides) {
  workbench.post(workbench::RecordScripted{{}, "One", false});
  film.sources.assign(sides, film::recording_of("One"));
  film.layout = film::layout_for(film.layout, sides);
  for (film::Source& source : film.sources) source.out_s = 10.0;
  return done(workbench);
}

/// A manual transfer beside one of shared control, whole, together by segment and at double speed.
bool prepare_trials(workbench::Workbench& workbench, film::Composition& film) {
  workbench.post(workbench::RecordScripted{{}, "One", false});
  if (!done(workbench)) return false;
  for (const demonstration::Segment segment : {demonstration::Segment::kA, demonstration::Segment::kC}) {
    learning::TrainOptions exact;
    exact.method = learning::Method::kExact;
    const demonstration::DemonstrationId expert = workbench.state().project->demonstrations.begin()->first;
    workbench.post(workbench::TrainModel{{expert}, segment, exact, 22, ""});
    if (!done(workbench)) return false;
  }
  for (const trial::Mode mode : {trial::Mode::kManual, trial::Mode::kShared}) {
    workbench::StartTrials start;
    start.plan.options.mode = mode;
    start.realtime = false;
    workbench.post(start);
    if (!done(workbench)) return false;
  }
  film = *film::preset_from("mt-vs-sc");
  film.sources = {film::recording_of("MT 1"), film::recording_of("SC 1")};
  film.pace.speed = 2.0;
  return true;
}

// A film of 1280 × 720 while the window, drawn anew each time, wants 30 frames a second. The film must reach 25 and the
// window keep its 30; `late` is the share of the window's frames that took longer than 1/30 s. With one or two sides of
// a demonstration; 0: two trials.
void film_beside_window(benchmark::State& run) {
  constexpr double kFrame_s = 1.0 / 30.0;
  auto window = ui::OsmesaWindow::create({1600, 900});
  if (!window) return run.SkipWithError(window.error().text().c_str());
  (*window)->always_draw(true);
  const testing::ScratchFolder folder;
  workbench::Workbench workbench({});
  workbench.post(workbench::OpenProject{folder.path() / "film.trocar", true});
  if (!done(workbench)) return run.SkipWithError("the project was not made");
  film::Composition film;
  const auto sides = static_cast<std::size_t>(run.range(0));
  if (!(sides > 0 ? prepare(workbench, film, sides) : prepare_trials(workbench, film))) {
    return run.SkipWithError("what is to be filmed was not made");
  }
  film.path = folder.path() / "film.mp4";
  ui::Settings settings;
  settings.scale = 1.0F;
  auto application = ui::Application::create(**window, workbench, settings);
  if (!application) return run.SkipWithError(application.error().text().c_str());
  const SystemClock clock;
  // The first frames load the scene and the fonts: they are the start of the program, not its pace.
  for (int i = 0; i < 30; ++i) {
    if (!(*application)->step(0.0)) return run.SkipWithError("a frame could not be drawn");
  }
  int drawn = 0;
  int late = 0;
  for (auto _ : run) {
    workbench.post(workbench::RenderFilm{film});
    const double begin_s = clock.now_s();
    int frames = 0;
    const auto ended = [&] {
      const auto& jobs = workbench.state().jobs;
      if (jobs.empty() || jobs.front().film.empty()) return false;
      frames = std::max(frames, jobs.front().of);
      return jobs.front().state != workbench::JobState::kQueued && jobs.front().state != workbench::JobState::kRunning;
    };
    for (double next_s = begin_s; !ended();) {
      const double before_s = clock.now_s();
      if (!(*application)->step(0.0)) return run.SkipWithError("a frame could not be drawn");
      const double after_s = clock.now_s();
      ++drawn;
      late += after_s - before_s > kFrame_s ? 1 : 0;
      next_s = std::max(next_s + kFrame_s, after_s);
      std::this_thread::sleep_for(std::chrono::duration<double>(next_s - after_s));
    }
    const double took_s = clock.now_s() - begin_s;
    run.counters["film_frames_per_s"] = frames / took_s;
    run.counters["window_frames_per_s"] = drawn / took_s;
    run.counters["late"] = static_cast<double>(late) / drawn;
  }
  const workbench::JobView& job = workbench.state().jobs.front();
  if (job.state != workbench::JobState::kDone) run.SkipWithError(job.message.c_str());
}
BENCHMARK(film_beside_window)
    ->Name("film_beside_window_1280x720")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1)
    ->Arg(1)
    ->Arg(2)
    ->Arg(0);

}  // namespace
