#include "engine/demonstration/comparison.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/demonstration/edits.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/time_warping.h"
#include "tests/support/document_samples.h"

using namespace trocar;
using namespace trocar::demonstration;
using testing::moving_demonstration;

namespace {

TipPair tips(double x) {
  return {Eigen::Vector3d(x, 0.01 * x, 0.0), Eigen::Vector3d(-x, 0.0, 0.02)};
}

double cost(const std::vector<TipPair>& a, const std::vector<TipPair>& b) {
  double sum = 0.0;
  for (const WarpStep& step : warp(a, b)) sum += distance(a[step.first], b[step.second]);
  return sum;
}

/// The whole table, without windows.
double least_cost(const std::vector<TipPair>& a, const std::vector<TipPair>& b) {
  std::vector<std::vector<double>> table(a.size(), std::vector<double>(b.size(), 0.0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      double best = i == 0 && j == 0 ? 0.0 : 1e9;
      if (i > 0) best = std::min(best, table[i - 1][j]);
      if (j > 0) best = std::min(best, table[i][j - 1]);
      if (i > 0 && j > 0) best = std::min(best, table[i - 1][j - 1]);
      table[i][j] = best + distance(a[i], b[j]);
    }
  }
  return table.back().back();
}

Demonstration edited(const Demonstration& document, const Edit& edit) {
  return apply(document, edit, 7).value();
}

/// Of another recording, `held` samples late: it stands still before it moves.
Demonstration late(int count, int held) {
  Recording recording = testing::moving_recording(count);
  std::vector<Sample> samples;
  for (int i = 0; i < count + held; ++i) {
    Sample sample = recording.samples[static_cast<std::size_t>(std::max(i - held, 0))];
    sample.tick = std::int64_t{i} * kTicksPerSample;
    samples.push_back(sample);
  }
  recording.samples = std::move(samples);
  return make_demonstration({2}, "Late", std::make_shared<const Recording>(std::move(recording))).value();
}

}  // namespace

TEST_CASE("time warping matches a path with itself, held and shifted, at no distance") {
  std::vector<TipPair> path;
  for (int i = 0; i < 300; ++i) path.push_back(tips(0.03 * std::sin(0.02 * i)));
  std::vector<TipPair> shifted(40, path.front());
  shifted.insert(shifted.end(), path.begin(), path.end());
  shifted.insert(shifted.begin() + 200, 25, shifted[200]);
  CHECK(cost(path, path) == 0.0);
  CHECK(cost(path, shifted) == 0.0);
  CHECK(cost(shifted, path) == 0.0);
}

TEST_CASE("time warping finds the least sum of distances and steps by at most one") {
  std::vector<TipPair> a;
  std::vector<TipPair> b;
  for (int i = 0; i < 90; ++i) a.push_back(tips(0.02 * std::sin(0.1 * i) + 0.001 * std::cos(7.0 * i)));
  for (int i = 0; i < 70; ++i) b.push_back(tips(0.02 * std::sin(0.13 * i - 0.2)));
  CHECK(cost(a, b) == doctest::Approx(least_cost(a, b)));
  const std::vector<WarpStep> steps = warp(a, b);
  CHECK(steps.front() == WarpStep{0, 0});
  CHECK(steps.back() == WarpStep{89, 69});
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const std::size_t first = steps[i].first - steps[i - 1].first;
    const std::size_t second = steps[i].second - steps[i - 1].second;
    CHECK(first <= 1);
    CHECK(second <= 1);
    CHECK(first + second >= 1);
  }
}

TEST_CASE("time warping of long paths stays in its corridor and near to the least sum") {
  std::vector<TipPair> a;
  std::vector<TipPair> b;
  for (int i = 0; i < 2600; ++i) a.push_back(tips(0.02 * std::sin(0.004 * i)));
  for (int i = 0; i < 2400; ++i) b.push_back(tips(0.02 * std::sin(0.0043 * i) + 0.0005 * std::sin(0.05 * i)));
  REQUIRE(a.size() * b.size() > 4'000'000);
  CHECK(cost(a, b) <= 1.05 * least_cost(a, b));
}

TEST_CASE("a demonstration that begins later deviates by time, and not by warping, arc length or segment") {
  const Demonstration before = moving_demonstration(500);
  const Demonstration after = late(500, 100);
  const spatial::Grid grid;
  CHECK(compare(before, after, Alignment::kTime, grid).value().both.max_m > 1e-3);
  CHECK(compare(before, after, Alignment::kWarping, grid).value().both.max_m == 0.0);
  // Sums of rounded lengths: a thousandth of a sample's way.
  CHECK(compare(before, after, Alignment::kArcLength, grid).value().both.max_m < 1e-7);
}

TEST_CASE("segments of other lengths answer to each other from end to end") {
  const Demonstration before = moving_demonstration(500);
  const Demonstration after = edited(before, Retime{.from_s = 0.5, .to_s = 1.5, .scale = 2.0});
  const auto matches = match(before, after, Alignment::kSegment).value();
  for (const SegmentSpan& span : after.segments) {
    const auto at = std::find_if(matches.begin(), matches.end(), [&](const Match& m) { return m.t_s >= span.begin_s; });
    REQUIRE(at != matches.end());
    CHECK(at->before_s[0] == doctest::Approx(before.segment(span.label)->begin_s).epsilon(0.02));
  }
  Demonstration bare = before;
  bare.segments.clear();
  CHECK_FALSE(match(bare, after, Alignment::kSegment));
}

TEST_CASE("what is moved, removed and added is counted, with its greatest, mean and 95 % deviation") {
  const Demonstration before = moving_demonstration(1000);
  const spatial::Grid grid;
  const Comparison same = compare(before, before, Alignment::kTime, grid).value();
  CHECK(same.matches.size() == 1000);
  CHECK(same.both.max_m == 0.0);
  CHECK(same.difference.moved == 0);
  CHECK(same.cells_lost + same.cells_gained == 0);

  Demonstration after = before;
  std::vector<Sample> samples = before.samples.to_vector();
  for (std::size_t i = 0; i < 100; ++i) samples[i].arms[0].measured.p[2] += 0.008F;
  samples.resize(900);
  after.samples = SampleTrack(samples);
  const Comparison moved = compare(before, after, Alignment::kTime, grid).value();
  CHECK(moved.matches.size() == 900);
  CHECK(moved.difference.moved == 100);
  CHECK(moved.difference.removed == 100);
  CHECK(moved.deviation[0].max_m == doctest::Approx(0.008).epsilon(1e-5));
  CHECK(moved.deviation[0].mean_m == doctest::Approx(0.008 / 9.0).epsilon(1e-5));
  CHECK(moved.deviation[0].share_95_m == doctest::Approx(0.008).epsilon(1e-5));
  CHECK(moved.both.share_95_m == doctest::Approx(0.008).epsilon(1e-5));
  CHECK(moved.deviation[1].max_m == 0.0);
  CHECK(moved.cells_gained > 0);
  CHECK(moved.cells_lost > 0);
}

TEST_CASE("95 in a hundred matches deviate by no more than the 95 % deviation") {
  const Demonstration before = moving_demonstration(1000);
  Demonstration after = before;
  std::vector<Sample> samples = before.samples.to_vector();
  for (std::size_t i = 0; i < 30; ++i) samples[i].arms[1].measured.p[0] += 0.004F;
  after.samples = SampleTrack(samples);
  const Comparison moved = compare(before, after, Alignment::kTime, spatial::Grid()).value();
  CHECK(moved.deviation[1].share_95_m == 0.0);
  CHECK(moved.deviation[1].max_m > 0.003);
}

TEST_CASE("the Markdown has the numbers of the comparison and what else differs") {
  const Demonstration before = moving_demonstration(1000);
  const Demonstration after = edited(before, Trim{0.5, 4.0});
  const std::string text =
      to_markdown(compare(before, after, Alignment::kTime, spatial::Grid()).value(), "A against B");
  CHECK(text.starts_with("### A against B\n"));
  CHECK(text.find("| duration, s | 4.995 | 3.500 | -1.495 |") != std::string::npos);
  CHECK(text.find("samples: 299 removed, 0 added, 0 moved") != std::string::npos);
}
