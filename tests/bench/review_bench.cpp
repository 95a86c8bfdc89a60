// What the Problems of a demonstration cost: a minute of both arms at 200 Hz from nothing (must reach: 100 ms), and
// again after an edit of one second of it.
#include <benchmark/benchmark.h>

#include "engine/demonstration/edits.h"
#include "engine/review/review.h"
#include "tests/support/document_samples.h"
#include "tests/support/recorded_transfer.h"

namespace {

using namespace trocar;

constexpr std::size_t kSamplesInAMinute = 60 * 200;

/// An expert's transfers one after the other, as long as a minute.
demonstration::Demonstration minute() {
  const demonstration::Demonstration one = testing::transfer(1);
  demonstration::Recording recording = testing::recording_of(one);
  const std::vector<demonstration::Sample> samples = recording.samples;
  while (recording.samples.size() < kSamplesInAMinute) {
    demonstration::Sample next = samples[recording.samples.size() % samples.size()];
    next.tick = recording.samples.back().tick + demonstration::kTicksPerSample;
    recording.samples.push_back(next);
  }
  recording.samples.resize(kSamplesInAMinute);
  return demonstration::make_demonstration({1}, "Minute",
                                           std::make_shared<const demonstration::Recording>(std::move(recording)))
      .value();
}

void clearance_minute(benchmark::State& state) {
  const demonstration::Demonstration document = minute();
  for (auto _ : state) {
    review::ClearanceMaker maker;
    benchmark::DoNotOptimize(maker.make(document));
  }
}
/// The whole list, with fixes.
void problems_minute(benchmark::State& state) {
  const demonstration::Demonstration document = minute();
  for (auto _ : state) {
    review::Reviewer reviewer;
    benchmark::DoNotOptimize(reviewer.make(document));
  }
}
BENCHMARK(problems_minute)->Name("problems_minute")->Unit(benchmark::kMillisecond);

/// As while somebody drags a waypoint: the same minute with a second of it moved, again and again elsewhere.
void problems_edit(benchmark::State& state) {
  const demonstration::Demonstration document = minute();
  std::vector<demonstration::Demonstration> versions;
  for (int i = 0; i < 8; ++i) {
    demonstration::MoveTool move;
    move.at_s = 5.0;
    move.by_m = {0.0, 0.0, 0.0005 * (i + 1)};
    versions.push_back(demonstration::apply(document, move).value());
  }
  review::Reviewer reviewer;
  std::size_t next = 0;
  for (auto _ : state) benchmark::DoNotOptimize(reviewer.make(versions[next++ % versions.size()]));
}
BENCHMARK(problems_edit)->Name("problems_edit")->Unit(benchmark::kMillisecond);

BENCHMARK(clearance_minute)->Name("clearance_minute")->Unit(benchmark::kMillisecond);

}  // namespace
