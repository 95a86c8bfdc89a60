#include "engine/workbench/live_trace.h"

#include <doctest/doctest.h>

#include "tests/support/document_samples.h"

using namespace trocar;
using workbench::LiveTracer;

TEST_CASE("a trace of a long recording has few points, evenly in time, from its first sample to its newest") {
  LiveTracer tracer;
  CHECK(tracer.trace() == nullptr);
  constexpr int kCount = 50'000;
  const std::vector<demonstration::Sample> part = testing::moving_recording(100).samples;
  for (int begun = 0; begun < kCount; begun += 100) {
    std::vector<demonstration::Sample> samples = part;
    for (demonstration::Sample& sample : samples) sample.tick += begun * demonstration::kTicksPerSample + 7000;
    tracer.add(samples);
  }
  const auto trace = tracer.trace();
  REQUIRE(trace);
  const auto& points = trace->points;
  CHECK(points.size() <= LiveTracer::kMost);
  CHECK(points.size() >= LiveTracer::kMost / 2 - 1);
  CHECK(points.front().t_s == 0.0);
  const double apart_s = points[1].t_s;
  for (std::size_t i = 1; i < points.size(); ++i) {
    REQUIRE(points[i].t_s - points[i - 1].t_s == doctest::Approx(apart_s));
  }
  CHECK(points.back().t_s > (kCount - 1) * 0.005 - apart_s);
  CHECK(tracer.trace() == trace);
}
