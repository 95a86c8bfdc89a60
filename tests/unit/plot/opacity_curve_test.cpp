#include "engine/plot/opacity_curve.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace trocar;
using namespace trocar::plot;

TEST_CASE("a curve is straight between its knots and level beyond, and its highest place may lie within a span") {
  const OpacityCurve curve{{{0.2, 0.0}, {0.4, 1.0}, {0.8, 0.5}}};
  CHECK(curve.at(0.0) == 0.0);
  CHECK(curve.at(0.3) == doctest::Approx(0.5));
  CHECK(curve.at(0.4) == 1.0);
  CHECK(curve.at(0.6) == doctest::Approx(0.75));
  CHECK(curve.at(1.0) == 0.5);
  CHECK(curve.highest(0.0, 0.1) == 0.0);
  CHECK(curve.highest(0.3, 0.6) == 1.0);
  CHECK(curve.highest(0.9, 1.0) == 0.5);
}

TEST_CASE("presets and knots are read as they are written, and what is no curve is refused") {
  for (const OpacityPreset preset : kOpacityPresets) {
    const OpacityCurve curve = opacity_curve(preset);
    CHECK(preset_of(curve) == preset);
    CHECK(to_string(curve) == to_string(preset));
    CHECK(opacity_curve_from(to_string(preset)).value() == curve);
  }
  const OpacityCurve drawn{{{0.0, 0.25}, {0.6, 0.1}, {1.0, 1.0}}};
  CHECK(to_string(drawn) == "0:0.25/0.6:0.1/1:1");
  CHECK(opacity_curve_from("0:0.25/0.6:0.1/1:1").value() == drawn);
  CHECK_FALSE(preset_of(drawn));
  CHECK(opacity_curve_from("0.5:1").value().at(0.1) == 1.0);
  for (const char* wrong : {"", "hill", "0:0/", "0:0/0:1", "0.5:0/0.2:1", "0:1.5", "-0.1:0", "0:nan", "0", "0:0,1:1",
                            "0:0/.01:0/.02:0/.03:0/.04:0/.05:0/.06:0/.07:0/.08:0/.09:0/.1:0/.11:0/.12:0/.13:0/.14:0/"
                            ".15:0/.16:0"}) {
    CAPTURE(wrong);
    CHECK_FALSE(opacity_curve_from(wrong));
  }
}

TEST_CASE("the fitted curve is clear where most values lie, and highest far from there") {
  Colouring colouring;
  colouring.scale = {ScaleKind::kLinear, 0.0, 1.0};
  // As of a value that was learned in few cells: the rest holds zero, the top of the scale.
  std::vector<double> values(1000, 1.0);
  for (int i = 0; i < 200; ++i) values[static_cast<std::size_t>(i)] = i / 200.0;
  const OpacityCurve rim = fitted_opacity(colouring, values);
  CHECK(rim.at(1.0) == 0.0);
  CHECK(rim.at(0.0) == 1.0);
  CHECK(rim.at(0.5) > 0.2);
  // Spread evenly: what is low stays faint, and the far end is thick.
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i) / 999.0;
  const OpacityCurve even = fitted_opacity(colouring, values);
  CHECK(even.at(0.0) == 0.0);
  CHECK(even.at(0.7) <= 0.13);
  CHECK(even.at(1.0) == 1.0);
  // Most in the middle: both sides stand out, the nearer one less.
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = i < 800 ? 0.3 : static_cast<double>(i) / 999.0;
  const OpacityCurve middle = fitted_opacity(colouring, values);
  CHECK(middle.at(0.3) < 0.02);
  CHECK(middle.at(1.0) == 1.0);
  CHECK(middle.at(0.0) > 0.2);
  CHECK(middle.at(0.0) < 0.6);
  colouring.map = ColourMap::kDiverging;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i) / 999.0;
  const OpacityCurve both = fitted_opacity(colouring, values);
  CHECK(both.at(0.5) == 0.0);
  CHECK(both.at(0.0) == 1.0);
  CHECK(both.at(1.0) == 1.0);
  // Where all is alike there is nothing to stand out from.
  CHECK(fitted_opacity({}, {1.0, 1.0, 1.0}).at(1.0) == 1.0);
  CHECK(fitted_opacity(colouring, {std::numeric_limits<double>::quiet_NaN()}) == OpacityCurve{});
}

TEST_CASE("a fitted curve can be written and read whatever the values are") {
  Colouring colouring;
  colouring.scale = {ScaleKind::kLinear, 0.0, 1.0};
  for (int k = 0; k <= 40; ++k) {
    std::vector<double> values(500, k / 40.0);
    for (std::size_t i = 0; i < 200; ++i) values[i] = std::pow(static_cast<double>(i) / 199.0, 1.0 + k);
    const OpacityCurve curve = fitted_opacity(colouring, values);
    CAPTURE(to_string(curve));
    REQUIRE(opacity_curve_from(to_string(curve)));
    CHECK(opacity_curve_from(to_string(curve)).value() == curve);
  }
}
