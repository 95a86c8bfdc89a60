#include "engine/core/random.h"

#include <doctest/doctest.h>

#include <array>

using trocar::Random;

TEST_CASE("the same seed gives the same numbers, another seed others") {
  Random a(7);
  Random b(7);
  Random c(8);
  for (int i = 0; i < 100; ++i) CHECK(a.next() == b.next());
  CHECK(a.next() != c.next());
}

TEST_CASE("the first numbers of seed 1 stay what they were, on every machine") {
  Random random(1);
  CHECK(random.next() == 0xB3F2AF6D0FC710C5ULL);
  CHECK(random.next() == 0x853B559647364CEAULL);
}

TEST_CASE("below() is even: a chi-square over 6 values stays under the 99.9 % point") {
  Random random(42);
  std::array<int, 6> counts{};
  constexpr int kDraws = 60000;
  for (int i = 0; i < kDraws; ++i) ++counts[random.below(6)];
  double chi_square = 0.0;
  for (const int n : counts) chi_square += (n - kDraws / 6.0) * (n - kDraws / 6.0) / (kDraws / 6.0);
  CHECK(chi_square < 20.5);  // 5 degrees of freedom
}

TEST_CASE("normal() has mean 0 and variance 1") {
  Random random(3);
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kDraws = 100000;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
  }
  CHECK(sum / kDraws == doctest::Approx(0.0).epsilon(0.02).scale(1.0));
  CHECK(squares / kDraws == doctest::Approx(1.0).epsilon(0.02));
}

TEST_CASE("a child's stream differs from its parent's and from its siblings'") {
  const Random parent(5);
  Random first = parent.child(0);
  Random second = parent.child(1);
  Random same = parent.child(0);
  const auto x = first.next();
  CHECK(x != second.next());
  CHECK(x == same.next());
}
