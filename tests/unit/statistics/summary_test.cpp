#include "engine/statistics/summary.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace trocar::statistics;

TEST_CASE("mean, standard deviation and median of 2, 4, 4, 4, 5, 5, 7, 9 are 5, 2.138 and 4.5") {
  const std::vector<double> values{9.0, 2.0, 4.0, 5.0, 4.0, 7.0, 4.0, 5.0};
  CHECK(mean(values) == 5.0);
  CHECK(standard_deviation(values) == doctest::Approx(std::sqrt(32.0 / 7.0)).epsilon(1e-15));
  CHECK(median(values) == 4.5);
}

TEST_CASE("the median of an odd count is the middle value") {
  CHECK(median(std::vector<double>{3.0, -1.0, 10.0}) == 3.0);
}

TEST_CASE("too few values have no mean, deviation or median") {
  CHECK(std::isnan(mean({})));
  CHECK(std::isnan(median({})));
  CHECK(std::isnan(standard_deviation(std::vector<double>{1.0})));
}
