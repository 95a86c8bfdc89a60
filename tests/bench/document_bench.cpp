// What the document costs: opening an hour at 200 Hz (must reach: 2 s) and one undo in a history of 10,000 edits
// (must reach: 16 ms).
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "engine/workbench/project_file.h"

namespace {

using namespace trocar;
using namespace trocar::workbench;

constexpr int kSamplesInAnHour = 3600 * 200;
constexpr int kEdits = 10'000;

/// A project beside the others of this run, removed at the end.
class Scratch {
 public:
  explicit Scratch(const std::string& name)
      : path_(std::filesystem::temp_directory_path() /
              ("trocar_bench_" + std::to_string(::getpid()) + "_" + name + ".trocar")) {}
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

demonstration::Sample sample_at(int index) {
  demonstration::Sample sample;
  sample.tick = std::int64_t{index} * demonstration::kTicksPerSample;
  sample.arms[0].setpoint_p = {0.02 * std::sin(0.001 * index), -0.02, 0.03};
  sample.arms[0].measured.p = {static_cast<float>(sample.arms[0].setpoint_p[0]), -0.02F, 0.03F};
  return sample;
}

/// A project with one demonstration of `samples`; nothing if the disk does not take it.
std::optional<DemonstrationId> write_project(const std::filesystem::path& path, int samples) {
  Result<ProjectFile> file = ProjectFile::create(path, std::make_shared<SystemClock>());
  if (!file) return std::nullopt;
  Result<RecordingWriter> writer = file->begin_recording({}, "");
  if (!writer) return std::nullopt;
  for (int i = 0; i < samples; ++i) {
    if (!writer->add(sample_at(i))) return std::nullopt;
  }
  const auto recording = writer->finish(demonstration::Outcome::kSuccess, true);
  const auto node = recording ? file->commit(AddDemonstration{*recording, "Hour"})
                              : Result<std::int64_t>(tl::unexpected(recording.error()));
  return node ? std::optional(DemonstrationId{*node}) : std::nullopt;
}

void open_project(benchmark::State& state) {
  const Scratch scratch("hour");
  if (!write_project(scratch.path(), kSamplesInAnHour)) {
    state.SkipWithError("the project could not be written");
    return;
  }
  for (auto _ : state) {
    Diagnostics diagnostics;
    auto file = ProjectFile::open(scratch.path(), std::make_shared<SystemClock>(), diagnostics);
    if (!file || file->project()->demonstrations.size() != 1) state.SkipWithError("the project could not be opened");
    benchmark::DoNotOptimize(file);
  }
  state.counters["samples"] = kSamplesInAnHour;
}
BENCHMARK(open_project)->Name("open_project_1h")->Unit(benchmark::kMillisecond);

void undo(benchmark::State& state) {
  const Scratch scratch("undo");
  const std::optional<DemonstrationId> id = write_project(scratch.path(), 3000);
  Diagnostics diagnostics;
  auto file = ProjectFile::open(scratch.path(), std::make_shared<SystemClock>(), diagnostics);
  if (!id || !file) {
    state.SkipWithError("the project could not be written");
    return;
  }
  for (int i = 0; i < kEdits; ++i) {
    const double end_s = 14.9 - 0.001 * (i % 5000);
    if (!file->commit(EditDemonstration{*id, demonstration::Trim{0.0, end_s}})) state.SkipWithError("an edit failed");
  }
  const std::int64_t newest = file->head();
  double worst_s = 0.0;
  for (auto _ : state) {
    if (file->head() <= id->value) {
      state.PauseTiming();
      if (!file->go_to(newest)) state.SkipWithError("the history could not be walked");
      state.ResumeTiming();
    }
    const auto begin = std::chrono::steady_clock::now();
    if (!file->undo()) state.SkipWithError("an undo failed");
    worst_s = std::max(worst_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  state.counters["worst_ms"] = 1e3 * worst_s;
}
BENCHMARK(undo)->Name("undo_10000")->Unit(benchmark::kMicrosecond);

}  // namespace
