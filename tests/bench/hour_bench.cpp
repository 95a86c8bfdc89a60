// An hour at 200 Hz in the window, without a display: how long it takes to open (must reach: 2 s), what edits, undo and
// redo cost the interface (must reach: 50 ms) and how soon all that is worked out beside it has come to rest, and how
// much memory it takes (must reach: 600 MB). And of any demonstration: how soon the view shows another instant (must
// reach: 50 ms), and what an idle window costs (must reach: 2 % of a core).
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "engine/core/clock.h"
#include "engine/workbench/project_file.h"
#include "tests/support/recorded_transfer.h"
#include "tests/support/scratch_folder.h"
#include "ui/application.h"
#include "ui/session.h"
#include "ui/window/osmesa_window.h"

namespace {

using namespace trocar;
using workbench::DemonstrationId;

constexpr std::size_t kHour_samples = 3600 * 200;
constexpr double kPatience_s = 120.0;

/// In megabytes, of this process.
double memory_mb(const std::string& key) {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    double kilobytes = 0.0;
    if (word == key + ":" && status >> kilobytes) return kilobytes / 1024.0;
  }
  return 0.0;
}

/// The peak is counted from here on.
void forget_peak() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

double cpu_now_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// A transfer there and back, again and again: nothing jumps. 0: the transfer once.
bool write_project(const std::filesystem::path& path, std::size_t count) {
  const demonstration::Demonstration one = testing::transfer(1);
  auto file = workbench::ProjectFile::create(path, std::make_shared<SystemClock>());
  if (!file) return false;
  auto writer = file->begin_recording(one.recording->provenance, "");
  if (!writer) return false;
  const std::size_t length = one.recorded.size();
  for (std::size_t i = 0; i < (count == 0 ? length : count); ++i) {
    const std::size_t at = i % (2 * length - 2);
    demonstration::Sample sample = one.recorded[at < length ? at : 2 * length - 2 - at];
    sample.tick = static_cast<std::int64_t>(i) * demonstration::kTicksPerSample;
    if (!writer->add(sample)) return false;
  }
  const auto recording = writer->finish(demonstration::Outcome::kSuccess, true);
  return recording && file->commit(workbench::AddDemonstration{*recording, "Hour"});
}

/// The window on a project, all of it as a user has it, but for the display.
class OpenWindow {
 public:
  /// `state` is told if it cannot be.
  explicit OpenWindow(benchmark::State& run, std::size_t samples) : run_(run) {
    if (!write_project(folder_ / "hour.trocar", samples)) {
      refuse("the project could not be written");
      return;
    }
    auto window = ui::OsmesaWindow::create({1600, 900});
    if (!window) {
      refuse(window.error().text());
      return;
    }
    window_ = std::move(*window);
    ui::Settings settings;
    settings.scale = 1.0F;
    auto application = ui::Application::create(*window_, workbench_, settings);
    if (!application) {
      refuse(application.error().text());
      return;
    }
    application_ = std::move(*application);
    step();
  }

  bool good() const { return good_; }
  workbench::Workbench& workbench() { return workbench_; }
  const workbench::WorkbenchState& state() const { return workbench_.state(); }

  void open() {
    workbench_.post(workbench::OpenProject{folder_ / "hour.trocar", false});
    while (good_ && state().load != workbench::LoadState::kReady) step();
  }
  void step(double timeout_s = 0.0) {
    if (good_ && !application_->step(timeout_s)) refuse("a frame could not be drawn");
  }
  /// Frames until nothing is worked out any more; returns the longest, in seconds.
  double rest() {
    const double end_s = clock_.now_s() + kPatience_s;
    double longest_s = 0.0;
    for (int calm = 0; good_ && calm < 3;) {
      const double begin_s = clock_.now_s();
      step();
      longest_s = std::max(longest_s, clock_.now_s() - begin_s);
      calm = workbench_.busy() ? 0 : calm + 1;
      if (workbench_.busy()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      if (clock_.now_s() > end_s) refuse("it did not come to rest");
    }
    return longest_s;
  }
  DemonstrationId demonstration() const { return state().project->demonstrations.begin()->first; }
  double now_s() const { return clock_.now_s(); }

 private:
  void refuse(const std::string& why) {
    good_ = false;
    run_.SkipWithError(why.c_str());
  }

  benchmark::State& run_;
  bool good_ = true;
  SystemClock clock_;
  testing::ScratchFolder folder_;
  std::unique_ptr<ui::OsmesaWindow> window_;
  workbench::Workbench workbench_{{}};
  std::unique_ptr<ui::Application> application_;
};

void open_hour(benchmark::State& run) {
  for (auto _ : run) {
    run.PauseTiming();
    OpenWindow window(run, kHour_samples);
    forget_peak();
    run.ResumeTiming();
    window.open();
    window.step();
    run.PauseTiming();
    const double open_s = window.now_s();
    window.rest();
    run.counters["rest_ms"] = 1e3 * (window.now_s() - open_s);
    run.counters["rss_mb"] = memory_mb("VmRSS");
    run.counters["peak_mb"] = memory_mb("VmHWM");
    run.ResumeTiming();
  }
}
BENCHMARK(open_hour)->Name("window_open_1h")->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

/// Time of a row: from the command to the first frame that shows what it did. `interface_ms` is the longest that the
/// window did not answer, `rest_ms` when everything had come to rest, `cpu_ms` what that cost on all cores.
void measure_edit(benchmark::State& run, const demonstration::Edit& edit) {
  OpenWindow window(run, kHour_samples);
  window.open();
  window.rest();
  forget_peak();
  double interface_s = 0.0;
  double rest_s = 0.0;
  double cpu_s = 0.0;
  int steps = 0;
  const auto act = [&](workbench::Command command) {
    const double begin_s = window.now_s();
    const double begin_cpu_s = cpu_now_s();
    window.workbench().post(std::move(command));
    window.step();
    const double first_s = window.now_s() - begin_s;
    interface_s = std::max({interface_s, first_s, window.rest()});
    rest_s += window.now_s() - begin_s;
    cpu_s += cpu_now_s() - begin_cpu_s;
    ++steps;
    return first_s;
  };
  for (auto _ : run) {
    double first_s = act(workbench::CommitEdit{workbench::EditDemonstration{window.demonstration(), edit}});
    for (int i = 0; i < 2; ++i) {
      first_s = std::max(first_s, act(workbench::Undo{}));
      if (i == 0) first_s = std::max(first_s, act(workbench::Redo{}));
    }
    run.SetIterationTime(first_s);
  }
  if (!window.good()) return;
  run.counters["interface_ms"] = 1e3 * interface_s;
  run.counters["rest_ms"] = 1e3 * rest_s / steps;
  run.counters["cpu_ms"] = 1e3 * cpu_s / steps;
  run.counters["rss_mb"] = memory_mb("VmRSS");
  run.counters["peak_mb"] = memory_mb("VmHWM");
}

void trim(benchmark::State& run) {
  measure_edit(run, demonstration::Trim{1.0, 3500.0});
}
void cut(benchmark::State& run) {
  measure_edit(run, demonstration::DeleteSpan{1000.0, 1010.0, true});
}
void move_waypoint(benchmark::State& run) {
  measure_edit(run, demonstration::MoveTool{demonstration::Arms::kLeft, 1800.0, {0.0, 0.0, 0.002}});
}
void smooth(benchmark::State& run) {
  measure_edit(run, demonstration::Smooth{0.0, 3600.0});
}
void offset(benchmark::State& run) {
  measure_edit(run, demonstration::Offset{demonstration::Arms::kBoth, {0.0, 0.0, 0.001}});
}
void add_row(const char* name, void (*row)(benchmark::State&)) {
  benchmark::RegisterBenchmark(name, row)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(5);
}
[[maybe_unused]] const bool kRows = [] {
  add_row("window_edit_1h/trim", trim);
  add_row("window_edit_1h/delete", cut);
  add_row("window_edit_1h/move", move_waypoint);
  add_row("window_edit_1h/smooth", smooth);
  add_row("window_edit_1h/offset", offset);
  return true;
}();

/// The camera stands, the playhead jumps: from the input to the frame with the new picture.
void scrub(benchmark::State& run) {
  OpenWindow window(run, 0);
  window.open();
  window.rest();
  double at_s = 0.0;
  double worst_s = 0.0;
  for (auto _ : run) {
    at_s = at_s > 20.0 ? 0.5 : at_s + 0.37;
    const std::uint64_t before = window.state().picture_number;
    const double begin_s = window.now_s();
    window.workbench().post(workbench::SetPlayhead{at_s});
    // The frame after the picture has come is the one that shows it.
    while (window.good() && window.state().picture_number == before) window.step();
    window.step();
    const double took_s = window.now_s() - begin_s;
    run.SetIterationTime(took_s);
    worst_s = std::max(worst_s, took_s);
    window.rest();
    if (!window.good()) break;
  }
  run.counters["worst_ms"] = 1e3 * worst_s;
}
BENCHMARK(scrub)->Name("scrub_picture")->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(30);

/// A window that nobody touches, for 3 s.
void idle(benchmark::State& run) {
  OpenWindow window(run, 0);
  window.open();
  window.rest();
  for (auto _ : run) {
    const double end_s = window.now_s() + 3.0;
    const double begin_cpu_s = cpu_now_s();
    // As `ui::run` does; without a display nothing ends the pause early.
    while (window.good() && window.now_s() < end_s) {
      window.step();
      std::this_thread::sleep_for(std::chrono::milliseconds(250));
    }
    run.counters["core_share"] = (cpu_now_s() - begin_cpu_s) / 3.0;
  }
}
BENCHMARK(idle)->Name("window_idle_3s")->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

}  // namespace
