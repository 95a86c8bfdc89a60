// Curves of an hour at 200 Hz: what the window does in a frame (must reach: 16 ms for both arms), and what the worker
// does beside it; and matching two minutes of motion by dynamic time warping.
#include <benchmark/benchmark.h>

#include <cmath>

#include "engine/demonstration/time_warping.h"
#include "engine/workbench/curves.h"

namespace {

using namespace trocar;

constexpr int kHour = 3600 * 200;

const demonstration::SampleTrack& hour() {
  static const demonstration::SampleTrack track = [] {
    std::vector<demonstration::Sample> samples(kHour);
    for (int i = 0; i < kHour; ++i) {
      demonstration::Sample& sample = samples[static_cast<std::size_t>(i)];
      sample.tick = std::int64_t{i} * demonstration::kTicksPerSample;
      for (auto& arm : sample.arms) {
        arm.measured.p = {static_cast<float>(0.02 * std::sin(0.003 * i)), static_cast<float>(1e-4 * std::sin(1.7 * i)),
                          0.03F};
      }
    }
    return demonstration::SampleTrack(std::move(samples));
  }();
  return track;
}

void lines(benchmark::State& run) {
  const auto curve = workbench::plotted(hour(), 0, workbench::CurveKind::kX, 0);
  // 800 columns of all of it, for both arms, and the range of the value axis.
  for (auto _ : run) {
    for (int arm = 0; arm < 2; ++arm) {
      benchmark::DoNotOptimize(curve->extent(0.0, 3600.0));
      benchmark::DoNotOptimize(curve->lines(0.0, 3600.0, 800));
    }
  }
}

void work_out(benchmark::State& run) {
  for (auto _ : run) benchmark::DoNotOptimize(workbench::plotted(hour(), 0, workbench::CurveKind::kJerk, 0));
}

void warp(benchmark::State& run) {
  std::vector<demonstration::TipPair> first;
  std::vector<demonstration::TipPair> second;
  for (int i = 0; i < 12000; ++i) {
    first.push_back({Eigen::Vector3d(0.02 * std::sin(0.003 * i), 0.0, 0.0), Eigen::Vector3d::Zero()});
    second.push_back({Eigen::Vector3d(0.02 * std::sin(0.0031 * i), 0.001, 0.0), Eigen::Vector3d::Zero()});
  }
  for (auto _ : run) benchmark::DoNotOptimize(demonstration::warp(first, second));
}

BENCHMARK(lines)->Name("curve_lines_1h")->Unit(benchmark::kMicrosecond);
BENCHMARK(work_out)->Name("curve_jerk_1h")->Unit(benchmark::kMillisecond);
BENCHMARK(warp)->Name("warp_1min")->Unit(benchmark::kMillisecond);

}  // namespace
