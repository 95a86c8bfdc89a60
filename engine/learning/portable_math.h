/// exp and log from IEEE operations only, so that the same seed gives the same bytes on every machine.
///
/// The C library picks another code path where the processor has fused multiply-add, and its last bit differs there.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace trocar::learning {

constexpr double kLn2 = 0.69314718055994530942;

/// e^x within 2 units in the last place; 0 below −708, infinity above 709.
inline double portable_exp(double x) {
  if (!(x > -708.0)) return std::isnan(x) ? x : 0.0;
  if (x > 709.0) return std::numeric_limits<double>::infinity();
  constexpr double kLn2High = 0x1.62e42fee00000p-1;
  constexpr double kLn2Low = 0x1.a39ef35793c76p-33;
  const double scaled = x * 1.4426950408889634074;
  const auto k = static_cast<std::int64_t>(scaled + (scaled < 0.0 ? -0.5 : 0.5));
  const auto whole = static_cast<double>(k);
  const double r = (x - whole * kLn2High) - whole * kLn2Low;
  // Taylor to degree 13: the rest is under 5e-18 for |r| ≤ 0.347.
  double sum = 1.0 / 6227020800.0;
  constexpr double kInverseFactorial[] = {
      1.0 / 479001600.0, 1.0 / 39916800.0, 1.0 / 3628800.0, 1.0 / 362880.0, 1.0 / 40320.0, 1.0 / 5040.0,
      1.0 / 720.0,       1.0 / 120.0,      1.0 / 24.0,      1.0 / 6.0,      0.5,           1.0};
  for (const double coefficient : kInverseFactorial) sum = sum * r + coefficient;
  sum = sum * r + 1.0;
  // In two steps, because 2^1024 alone is not a number.
  const auto half = k / 2;
  const double first = std::bit_cast<double>(static_cast<std::uint64_t>(half + 1023) << 52);
  const double second = std::bit_cast<double>(static_cast<std::uint64_t>(k - half + 1023) << 52);
  return sum * first * second;
}

/// Natural logarithm within 2 units in the last place; precondition: x is normal and positive.
inline double portable_log(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  auto exponent = static_cast<std::int64_t>(bits >> 52) - 1023;
  double m = std::bit_cast<double>((bits & 0x000FFFFFFFFFFFFFULL) | 0x3FF0000000000000ULL);
  if (m > 1.4142135623730951) {
    m *= 0.5;
    ++exponent;
  }
  const double s = (m - 1.0) / (m + 1.0);
  const double s2 = s * s;
  double sum = 1.0 / 23.0;
  for (int k = 21; k >= 3; k -= 2) sum = sum * s2 + 1.0 / k;
  const double tail = 2.0 * s * s2 * sum;
  return static_cast<double>(exponent) * kLn2 + (2.0 * s + tail);
}

}  // namespace trocar::learning
