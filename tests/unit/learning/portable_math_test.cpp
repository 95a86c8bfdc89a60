#include "engine/learning/portable_math.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "engine/core/random.h"

using namespace trocar::learning;

namespace {

/// |a − b| in units of b's last place.
double in_last_places(double a, double b) {
  const double place = std::nextafter(std::abs(b), std::numeric_limits<double>::infinity()) - std::abs(b);
  return std::abs(a - b) / place;
}

}  // namespace

TEST_CASE("portable exp and log are within 2 units in the last place of the C library's") {
  trocar::Random random(1);
  for (int i = 0; i < 100000; ++i) {
    const double x = random.uniform(-700.0, 700.0);
    REQUIRE(in_last_places(portable_exp(x), std::exp(x)) <= 2.0);
    const double y = std::exp(random.uniform(-700.0, 700.0));
    REQUIRE(in_last_places(portable_log(y), std::log(y)) <= 2.0);
    const double near_one = random.uniform(0.5, 2.0);
    REQUIRE(std::abs(portable_log(near_one) - std::log(near_one)) <= 4e-16);
  }
}

TEST_CASE("portable exp and log are exact where they must be, and safe beyond the range") {
  CHECK(portable_exp(0.0) == 1.0);
  CHECK(portable_log(1.0) == 0.0);
  CHECK(portable_exp(-800.0) == 0.0);
  CHECK(portable_exp(800.0) == std::numeric_limits<double>::infinity());
  CHECK(std::isnan(portable_exp(std::nan(""))));
}
