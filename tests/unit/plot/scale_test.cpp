#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "engine/plot/colour_map.h"

using namespace trocar::plot;

namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// RapidCheck prints what it found; doctest fails the case.
template <typename Property>
void holds(const char* name, Property property) {
  CHECK(rc::check(name, property));
}

double from_thousandths(int n) {
  return n / 1000.0;
}

}  // namespace

TEST_CASE("a value goes to its position and back on every kind of scale") {
  holds("round trip", [] {
    const auto kind = *rc::gen::element(ScaleKind::kLinear, ScaleKind::kSymlog, ScaleKind::kPercentile);
    const double low = from_thousandths(*rc::gen::inRange(-900000, 900000));
    const double width = from_thousandths(*rc::gen::inRange(1, 900000));
    const Scale scale{kind, low, low + width, from_thousandths(*rc::gen::inRange(1, 50000))};
    const double value = low + width * from_thousandths(*rc::gen::inRange(0, 1001));
    RC_ASSERT(std::abs(scale.value(scale.position(value)) - value) <= 1e-9 * (std::abs(low) + width));
  });
}

TEST_CASE("log and rank bring the values they were fitted to back from their positions") {
  holds("log", [] {
    const double sign = *rc::gen::element(-1.0, 1.0);
    std::vector<double> values;
    for (const int e : *rc::gen::nonEmpty<std::vector<int>>()) values.push_back(sign * std::pow(10.0, e % 200 / 10.0));
    values.push_back(0.0);
    const Scale scale = fit_scale(ScaleKind::kLog, values, false);
    RC_ASSERT(scale.kind == ScaleKind::kLog);
    RC_ASSERT(scale.low < scale.high);
    for (const double v : values) {
      if (v == 0.0) continue;
      RC_ASSERT(std::abs(scale.value(scale.position(v)) / v - 1.0) <= 1e-9);
    }
    RC_ASSERT(scale.position(0.0) == (sign > 0.0 ? 0.0 : 1.0));
  });
  holds("rank", [] {
    const auto numbers = *rc::gen::nonEmpty<std::vector<int>>();
    const std::vector<double> values(numbers.begin(), numbers.end());
    const Scale scale = fit_scale(ScaleKind::kRank, values, false);
    for (const double v : values) RC_ASSERT(scale.value(scale.position(v)) == doctest::Approx(v).epsilon(1e-9));
  });
}

TEST_CASE("rank spends its colours evenly on the values, however far apart") {
  const Scale scale = fit_scale(ScaleKind::kRank, {1.0, 2.0, 3.0, 1e9, kNotANumber}, false);
  CHECK(scale.position(1.0) == 0.0);
  CHECK(scale.position(2.0) == doctest::Approx(1.0 / 3.0));
  CHECK(scale.position(3.0) == doctest::Approx(2.0 / 3.0));
  CHECK(scale.position(1e9) == 1.0);
  CHECK(scale.position(-5.0) == 0.0);
  CHECK(scale.position(2.5) == doctest::Approx(0.5));
  CHECK(ticks(scale, 4) == std::vector<double>{1.0, 2.0, 3.0, 1e9});
}

TEST_CASE("what the values do not allow becomes the nearest kind that they do") {
  CHECK(fit_scale(ScaleKind::kLog, {-1.0, 2.0}, false).kind == ScaleKind::kSymlog);
  CHECK(fit_scale(ScaleKind::kLog, {0.0}, false).kind == ScaleKind::kSymlog);
  CHECK(fit_scale(ScaleKind::kLog, {1.0, 2.0}, true).kind == ScaleKind::kSymlog);
  CHECK(fit_scale(ScaleKind::kRank, {1.0, 2.0}, true).kind == ScaleKind::kPercentile);
  CHECK(fit_scale(ScaleKind::kRank, {}, false).kind == ScaleKind::kPercentile);
}

TEST_CASE("the ticks of a log scale are powers of ten, on either side of zero") {
  CHECK(ticks(fit_scale(ScaleKind::kLog, {1.0, 1000.0}, false), 5) == std::vector<double>{1.0, 10.0, 100.0, 1000.0});
  CHECK(ticks(fit_scale(ScaleKind::kLog, {-1.0, -100.0}, false), 5) == std::vector<double>{-100.0, -10.0, -1.0});
}

TEST_CASE("a scale never turns round, and clamps what is outside") {
  const Scale scale{ScaleKind::kSymlog, -100.0, 1000.0, 0.1};
  double before = -1.0;
  for (double v = -100.0; v <= 1000.0; v += 0.7) {
    CHECK(scale.position(v) > before);
    before = scale.position(v);
  }
  CHECK(scale.position(-1e9) == 0.0);
  CHECK(scale.position(1e9) == 1.0);
  CHECK(scale.position(kNotANumber) == 0.0);
}

TEST_CASE("symlog gives every decade the same width beyond its linear part") {
  const Scale scale{ScaleKind::kSymlog, 0.0, 1000.0, 1.0};
  const double decade = scale.position(10.0) - scale.position(1.0);
  CHECK(scale.position(100.0) - scale.position(10.0) == doctest::Approx(decade));
  CHECK(scale.position(1000.0) - scale.position(100.0) == doctest::Approx(decade));
  CHECK(scale.position(0.5) == doctest::Approx(scale.position(1.0) / 2.0));
}

TEST_CASE("limits are fitted to the finite values only") {
  const Scale scale =
      fit_scale(ScaleKind::kLinear, {kNotANumber, 3.0, -1.0, std::numeric_limits<double>::infinity()}, false);
  CHECK(scale.low == -1.0);
  CHECK(scale.high == 3.0);
}

TEST_CASE("a centred scale puts zero in the middle") {
  const Scale scale = fit_scale(ScaleKind::kLinear, {-1.0, 4.0}, true);
  CHECK(scale.low == -4.0);
  CHECK(scale.position(0.0) == 0.5);
}

TEST_CASE("nothing finite, or one value only, still gives a scale of some width") {
  for (const bool centred : {false, true}) {
    const std::vector<std::vector<double>> cases{{}, {kNotANumber}, {0.0, 0.0}, {7.0}, {-2.0, -2.0}, {1e300}};
    for (const auto& values : cases) {
      const Scale scale = fit_scale(ScaleKind::kSymlog, values, centred);
      CHECK(scale.low < scale.high);
      CHECK(scale.linear > 0.0);
    }
  }
  CHECK(fit_scale(ScaleKind::kLinear, {7.0}, false).high == 8.0);
}

TEST_CASE("the percentile scale leaves two hundredths of the values out at each end") {
  std::vector<double> values;
  for (int i = 0; i <= 100; ++i) values.push_back(i);
  values[100] = 1e6;
  const Scale scale = fit_scale(ScaleKind::kPercentile, values, false);
  CHECK(scale.low == doctest::Approx(2.0));
  CHECK(scale.high == doctest::Approx(98.0));
}

TEST_CASE("ticks are inside their limits, evenly spaced and about as many as asked for") {
  holds("ticks", [] {
    const double low = from_thousandths(*rc::gen::inRange(-900000, 900000));
    const double high = low + from_thousandths(*rc::gen::inRange(1, 900000));
    const int count = *rc::gen::inRange(2, 12);
    const auto found = ticks(low, high, count);
    const double slack = 1e-6 * (high - low);
    RC_ASSERT(found.size() <= static_cast<std::size_t>(count) + 1);
    RC_ASSERT(3 * found.size() + 2 >= static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < found.size(); ++i) {
      RC_ASSERT(found[i] >= low - slack && found[i] <= high + slack);
      if (i >= 2) RC_ASSERT(std::abs(found[i] - 2 * found[i - 1] + found[i - 2]) <= slack);
    }
  });
}

TEST_CASE("ticks are the round numbers a person would write") {
  CHECK(ticks(0.0, 1.0, 5) == std::vector<double>{0.0, 0.2, 0.4, 0.6, 0.8, 1.0});
  CHECK(ticks(-37.5, 17.5, 6) == std::vector<double>{-30.0, -20.0, -10.0, 0.0, 10.0});
  CHECK(ticks(1.0, 1.0, 5).empty());
  CHECK(ticks(Scale{ScaleKind::kSymlog, -100.0, 100.0, 1.0}, 7) ==
        std::vector<double>{-100.0, -10.0, -1.0, 0.0, 1.0, 10.0, 100.0});
}

TEST_CASE("tick labels carry as many digits as the step needs, and a true minus") {
  CHECK(format_tick(0.5, 0.1) == "0.5");
  CHECK(format_tick(2.0, 0.25) == "2.0");
  CHECK(format_tick(20.0, 10.0) == "20");
  CHECK(format_tick(-3.0, 1.0) == "\u22123");
  CHECK(format_tick(0.0, 0.1) == "0");
  CHECK(format_tick(-1e-17, 0.1) == "0");
  CHECK(format_tick(2e6, 1e6) == "2e6");
  CHECK(format_tick(2.5e6, 5e5) == "2.5e6");
  CHECK(format_tick(-1e-5, 1e-5) == "\u22121e\u22125");
}

TEST_CASE("neighbouring ticks never share a label") {
  holds("labels differ", [] {
    const double low = from_thousandths(*rc::gen::inRange(-900000, 900000));
    const double high = low + from_thousandths(*rc::gen::inRange(1, 900000));
    const Scale scale{*rc::gen::element(ScaleKind::kLinear, ScaleKind::kSymlog, ScaleKind::kPercentile), low, high, 0.01};
    const auto found = ticks(scale, *rc::gen::inRange(2, 10));
    const auto labels = format_ticks(scale, found);
    for (std::size_t i = 1; i < labels.size(); ++i) RC_ASSERT(labels[i] != labels[i - 1]);
  });
}
