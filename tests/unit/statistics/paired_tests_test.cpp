// Paired tests against what SciPy 1.10 says of the same numbers.
#include "engine/statistics/paired_tests.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace trocar::statistics;

namespace {

const std::vector<double> kA{12.1, 14.3, 11.8, 15.2, 13.3, 12.9, 16.1, 14.0, 13.1, 12.2};
const std::vector<double> kB{10.4, 13.1, 11.9, 13.0, 12.8, 11.0, 14.9, 13.2, 13.4, 11.1};

std::vector<double> differences() {
  std::vector<double> d;
  for (std::size_t i = 0; i < kA.size(); ++i) d.push_back(kA[i] - kB[i]);
  return d;
}

}  // namespace

TEST_CASE("Student's t of pairs") {
  const PairedT result = paired_t(differences());
  CHECK(result.t == doctest::Approx(3.945186266939885));
  CHECK(result.p == doctest::Approx(0.0033792787887604752));
  CHECK(result.degrees_of_freedom == 9);
  CHECK(result.effect == doctest::Approx(3.945186266939885 / std::sqrt(10.0)));
  const std::vector<double> same{1.0, 1.0, 1.0};
  CHECK(std::isnan(paired_t(same).p));
  CHECK(std::isnan(paired_t(std::vector<double>{1.0}).t));
}

TEST_CASE("Wilcoxon's signed ranks, exact") {
  const std::vector<double> ranks{1, 2, 3, 4, 5, -6, 7, 8, -9, 10, 11, 12};
  const SignedRank result = wilcoxon_signed_rank(ranks);
  CHECK(result.w == 15.0);
  CHECK(result.exact);
  CHECK(result.p == doctest::Approx(0.06396484375));
  CHECK(wilcoxon_signed_rank(std::vector<double>{0.0, 0.0}).count == 0);
  // All of one sign: 2 of the 2ⁿ ways.
  CHECK(wilcoxon_signed_rank(std::vector<double>{1, 2, 3, 4, 5}).p == doctest::Approx(2.0 / 32.0));
  const SignedRank tied = wilcoxon_signed_rank(std::vector<double>{1, 1, -1, 2, 3});
  CHECK_FALSE(tied.exact);
  CHECK(tied.p > 0.05);
}

TEST_CASE("Shapiro and Wilk's test, for few values and for more") {
  const Normality ten = shapiro_wilk(kA);
  CHECK(ten.w == doctest::Approx(0.9436739683).epsilon(1e-5));
  CHECK(ten.p == doctest::Approx(0.5945701).epsilon(1e-3));
  const Normality three = shapiro_wilk(std::vector<double>{1.0, 2.0, 4.0});
  CHECK(three.w == doctest::Approx(0.96428573).epsilon(1e-6));
  CHECK(three.p == doctest::Approx(0.6368869).epsilon(1e-4));
  const Normality five = shapiro_wilk(std::vector<double>{3, 1, 4, 1, 5});
  CHECK(five.w == doctest::Approx(0.8939245).epsilon(1e-5));
  CHECK(five.p == doctest::Approx(0.3772225).epsilon(1e-3));
  const std::vector<double> skewed{0.144, 1.88,  1.443, 0.294, 0.684, 0.597, 1.054, 1.555, 0.099, 0.029,
                                   1.806, 0.567, 1.437, 0.002, 0.589, 1.278, 0.26,  2.905, 2.317, 0.031};
  const Normality twenty = shapiro_wilk(skewed);
  CHECK(twenty.w == doctest::Approx(0.9123803).epsilon(1e-5));
  CHECK(twenty.p == doctest::Approx(0.0707626).epsilon(1e-3));
  CHECK(std::isnan(shapiro_wilk(std::vector<double>{1.0, 2.0}).p));
  CHECK(std::isnan(shapiro_wilk(std::vector<double>{2.0, 2.0, 2.0}).p));
}
