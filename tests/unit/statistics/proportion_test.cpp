#include "engine/statistics/proportion.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

using namespace trocar::statistics;

TEST_CASE("McNemar's exact p is the two-sided binomial tail") {
  CHECK(mcnemar_exact_p(0, 0) == 1.0);
  CHECK(mcnemar_exact_p(0, 6) == doctest::Approx(2.0 / 64.0).epsilon(1e-12));
  CHECK(mcnemar_exact_p(1, 9) == doctest::Approx(2.0 * (1.0 + 10.0) / 1024.0).epsilon(1e-12));
  CHECK(mcnemar_exact_p(5, 5) == 1.0);
}

TEST_CASE("McNemar's exact p does not underflow to a wrong answer with thousands of even pairs") {
  CHECK(mcnemar_exact_p(5000, 5000) == 1.0);
  CHECK(mcnemar_exact_p(0, 1000) == doctest::Approx(std::ldexp(1.0, -999)).epsilon(1e-9));
}

TEST_CASE("McNemar's exact p does not care which of the two is called A, and falls as the wins become uneven") {
  CHECK(rc::check([] {
    const int a = *rc::gen::inRange(0, 60);
    const int b = *rc::gen::inRange(0, 60);
    RC_ASSERT(mcnemar_exact_p(a, b) == mcnemar_exact_p(b, a));
    if (a <= b) RC_ASSERT(mcnemar_exact_p(a, b + 1) <= mcnemar_exact_p(a, b));
  }));
}

TEST_CASE("Wilson's interval for 8 of 10 is the textbook's") {
  const Interval interval = wilson_interval(8, 10);
  CHECK(interval.low == doctest::Approx(0.4901625).epsilon(1e-6));
  CHECK(interval.high == doctest::Approx(0.9433178).epsilon(1e-6));
}

TEST_CASE("Wilson's interval stays in 0 … 1 and holds the observed share") {
  CHECK(rc::check([] {
    const int count = *rc::gen::inRange(0, 11000);
    const int successes = *rc::gen::inRange(0, count + 1);
    const Interval interval = wilson_interval(successes, count);
    RC_ASSERT(interval.low >= 0.0);
    RC_ASSERT(interval.high <= 1.0);
    if (count > 0) RC_ASSERT(interval.low <= static_cast<double>(successes) / count);
    if (count > 0) RC_ASSERT(interval.high >= static_cast<double>(successes) / count);
  }));
}

TEST_CASE(
    "the interval of a paired difference is Agresti and Min's, mirrors with the models and narrows with the pairs") {
  // By hand: b = 20.5, c = 10.5, n = 102; (10 ± 1.959964 sqrt(31 − 100 / 102)) / 102.
  const Interval interval = paired_difference_interval(10, 20, 100);
  CHECK(interval.low == doctest::Approx(-0.0072424).epsilon(1e-4));
  CHECK(interval.high == doctest::Approx(0.2033208).epsilon(1e-4));
  const Interval mirrored = paired_difference_interval(20, 10, 100);
  CHECK(mirrored.low == doctest::Approx(-interval.high));
  CHECK(mirrored.high == doctest::Approx(-interval.low));
  const Interval narrow = paired_difference_interval(100, 200, 1000);
  CHECK(narrow.high - narrow.low < interval.high - interval.low);
  CHECK(paired_difference_interval(0, 3, 3).high == 1.0);
  CHECK(paired_difference_interval(0, 0, 0).low == -1.0);
}

TEST_CASE("a share is called 100 % or 0 % only where it is whole") {
  CHECK(percent_text(10646, 10648, 1) == ">99.9 %");
  CHECK(percent_text(10648, 10648, 1) == "100.0 %");
  CHECK(percent_text(2, 10648, 1) == "<0.1 %");
  CHECK(percent_text(0, 10648, 1) == "0.0 %");
  CHECK(percent_text(999, 1000, 1) == "99.9 %");
  CHECK(percent_text(999, 1000, 0) == ">99 %");
  CHECK(percent_text(1, 1000, 0) == "<1 %");
  CHECK(percent_text(1, 1, 0) == "100 %");
  CHECK(percent_text(3, 8, 2) == "37.50 %");
  CHECK(percent_text(0, 0, 1) == "–");
  CHECK(share_text(0.99996, 2) == ">99.99 %");
  CHECK(points_text(10646.0 / 10648.0, 1) == ">+99.9");
  CHECK(points_text(1.0, 1) == "+100.0");
  CHECK(points_text(-0.0002, 1) == ">−0.1");
  CHECK(points_text(-10646.0 / 10648.0, 1) == "<−99.9");
  CHECK(points_text(-0.125, 1) == "−12.5");
  CHECK(points_text(0.0, 1) == "0.0");
}
