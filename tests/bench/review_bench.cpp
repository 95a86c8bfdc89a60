// What the Problems of a demonstration cost: a minute of both arms at 200 Hz from nothing (must reach: 100 ms), and
// again after an edit of one second of it.
#include <benchmark/benchmark.h>

#include "engine/demonstration/edits.h"
#include "engine/review/clearance.h"
#include "tests/support/recorded_transfer.h"

namespace {

using namespace trocar;

constexpr std::size_t kSamplesInAMinute = 60 * 200;

/// An expert's transfers one after the other, as long as a minute.
demonstration::Demonstration minute() {
  const demonstration::Demonstration one = testing::transfer(1);
  demonstration::Recording recording = *one.recording;
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
BENCHMARK(clearance_minute)->Name("clearance_minute")->Unit(benchmark::kMillisecond);

}  // namespace
