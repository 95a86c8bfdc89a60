#include "engine/plot/curve.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/plot/axis.h"

using namespace trocar::plot;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

Curve noisy(int count, std::vector<int> gaps = {}) {
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i < count; ++i) {
    x.push_back(0.005 * i);
    y.push_back(std::sin(0.37 * i) + 0.1 * std::sin(1234.5 * i));
  }
  for (const int gap : gaps) y[static_cast<std::size_t>(gap)] = kNan;
  return {x, y};
}

struct Ends {
  double low = kInfinite;
  double high = -kInfinite;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Of the points with x in [begin, end).
Ends of_points(const std::vector<std::vector<CurvePoint>>& lines, double begin, double end) {
  Ends ends;
  for (const auto& line : lines) {
    for (const CurvePoint& point : line) {
      if (point.x >= begin && point.x < end) ends.add(point.y);
    }
  }
  return ends;
}

Ends of_samples(const Curve& curve, double begin, double end) {
  Ends ends;
  for (std::size_t i = 0; i < curve.x().size(); ++i) {
    if (curve.x()[i] >= begin && curve.x()[i] < end && std::isfinite(curve.y()[i])) ends.add(curve.y()[i]);
  }
  return ends;
}

}  // namespace

TEST_CASE("the drawn line keeps the lowest and the highest sample of every column, however many gaps there are") {
  for (const Curve& curve : {noisy(10000), noisy(10000, {17, 18, 640, 4096, 9999}), noisy(70, {0})}) {
    for (const int columns : {7, 100, 333}) {
      const double begin = 0.011;
      const double end = 0.9 * curve.x().back();
      const auto lines = curve.lines(begin, end, columns);
      for (int c = 0; c < columns; ++c) {
        const double from = begin + (end - begin) * c / columns;
        const double to = begin + (end - begin) * (c + 1) / columns;
        const Ends drawn = of_points(lines, from, to);
        const Ends sampled = of_samples(curve, from, to);
        REQUIRE(drawn.low == sampled.low);
        REQUIRE(drawn.high == sampled.high);
      }
    }
  }
}

TEST_CASE("the drawn line has at most four points a column and goes forward") {
  const Curve curve = noisy(100000);
  const auto lines = curve.lines(0.0, 400.0, 200);
  REQUIRE(lines.size() == 1);
  // And the neighbour beyond the end.
  CHECK(lines[0].size() <= 4 * 200 + 1);
  CHECK(lines[0].back().x > 400.0);
  CHECK(std::is_sorted(lines[0].begin(), lines[0].end(), [](auto& a, auto& b) { return a.x < b.x; }));
}

TEST_CASE("no line is drawn across a gap, and few samples are drawn as they are") {
  const Curve curve({0, 1, 2, 3, 4, 5}, {1, 2, kNan, 4, 5, kInfinite});
  const auto lines = curve.lines(0.0, 5.0, 2);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].size() == 2);
  CHECK(lines[1].front().x == 3.0);
  CHECK(lines[1].back().y == 5.0);
}

TEST_CASE("a line that is seen from inside goes on to both edges") {
  const auto lines = Curve({0, 10}, {0, 100}).lines(4.0, 5.0, 100);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].front().x == 0.0);
  CHECK(lines[0].back().x == 10.0);
}

TEST_CASE("a value is read between samples, and none in a gap or beyond the ends") {
  const Curve curve({0, 1, 2, 3, 4}, {0, 10, kNan, 30, 40});
  CHECK(curve.value_at(0.25) == 2.5);
  CHECK(curve.value_at(1.0) == 10.0);
  CHECK(curve.value_at(4.0) == 40.0);
  for (const double x : {-0.1, 1.5, 2.0, 2.5, 4.1, kNan}) CHECK_FALSE(curve.value_at(x));
  CHECK_FALSE(Curve().value_at(0.0));
}

TEST_CASE("the extent over a range is that of its finite samples, as if each were looked at") {
  CHECK(rc::check("extents agree", [] {
    const int count = *rc::gen::inRange(1, 700);
    const auto gaps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, count));
    const Curve curve = noisy(count, gaps);
    const double begin = 0.005 * *rc::gen::inRange(-5, count);
    const double end = begin + 0.005 * *rc::gen::inRange(0, 300);
    const Ends expected = of_samples(curve, begin, std::nextafter(end, kInfinite));
    const std::optional<Extent> extent = curve.extent(begin, end);
    RC_ASSERT(extent.has_value() == (expected.low <= expected.high));
    if (extent) RC_ASSERT(extent->low == expected.low);
    if (extent) RC_ASSERT(extent->high == expected.high);
  }));
}

TEST_CASE("an axis has at least two marks where there is room for them") {
  for (const double high : {0.3, 1.0, 97.0, 412.0}) {
    for (const double pixels : {40.0, 90.0, 400.0}) {
      const Axis axis = axis_over(0.0, high, pixels, 30.0);
      CAPTURE(high);
      CAPTURE(pixels);
      CHECK(axis.ticks.size() >= 2);
      CHECK(axis.labels.size() == axis.ticks.size());
    }
  }
  CHECK(axis_over(2.0, 4.0, 100.0, 30.0).position(3.0) == 0.5);
}

TEST_CASE("the value range takes in a limit that the data come near to, and no other") {
  const std::vector<Band> limit{{-kInfinite, 250.0, "limit"}};
  CHECK(value_range({0.0, 200.0}, true, limit).high > 250.0);
  CHECK(value_range({0.0, 100.0}, true, limit).high < 110.0);
  CHECK(value_range({5.0, 100.0}, true, {}).low == 0.0);
  const Extent cube = value_range({-30.0, 16.0}, false, {{-37.5, 17.5, "cube"}});
  CHECK(cube.low < -37.5);
  CHECK(cube.high > 17.5);
}

TEST_CASE("a flat line has a value range of some height around it") {
  for (const double value : {0.0, 3.0, -3.0}) {
    for (const bool from_zero : {false, true}) {
      const Extent range = value_range({value, value}, from_zero, {});
      CHECK(range.low <= value);
      CHECK(range.high > value);
      CHECK(range.high - range.low > 1e-4);
    }
  }
}
