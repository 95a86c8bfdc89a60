#include "engine/statistics/paired_tests.h"

#include <algorithm>
#include <array>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "engine/statistics/summary.h"

namespace trocar::statistics {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kMostExact = 50;

double quantile(double p) {
  return boost::math::quantile(boost::math::normal(), p);
}
double upper_tail(double z) {
  return boost::math::cdf(boost::math::complement(boost::math::normal(), z));
}

double polynomial(std::span<const double> coefficients, double x) {
  double value = 0.0;
  for (auto each = coefficients.rbegin(); each != coefficients.rend(); ++each) value = value * x + *each;
  return value;
}

/// How many of the 2ⁿ ways to sign the ranks 1 … n have a sum of at most `w`, as a share.
double share_at_most(int n, int w) {
  std::vector<double> ways(static_cast<std::size_t>(n * (n + 1) / 2) + 1, 0.0);
  ways[0] = 1.0;
  for (int rank = 1; rank <= n; ++rank) {
    for (std::size_t sum = ways.size() - 1; sum >= static_cast<std::size_t>(rank); --sum) {
      ways[sum] = 0.5 * (ways[sum] + ways[sum - static_cast<std::size_t>(rank)]);
    }
    for (std::size_t sum = 0; sum < static_cast<std::size_t>(rank); ++sum) ways[sum] *= 0.5;
  }
  return std::accumulate(ways.begin(), ways.begin() + w + 1, 0.0);
}

/// The weights of the ordered values, for the upper half; the lower has them with the other sign.
std::vector<double> shapiro_weights(std::size_t n) {
  const std::size_t half = n / 2;
  std::vector<double> a(half);
  if (n == 3) {
    a[0] = std::sqrt(0.5);
    return a;
  }
  std::vector<double> m(half);
  double sum = 0.0;
  for (std::size_t i = 0; i < half; ++i) {
    m[i] = quantile((static_cast<double>(i) + 1.0 - 0.375) / (static_cast<double>(n) + 0.25));
    sum += m[i] * m[i];
  }
  sum *= 2.0;
  const double root = std::sqrt(sum);
  const double u = 1.0 / std::sqrt(static_cast<double>(n));
  constexpr std::array<double, 6> kFirst{0.0, 0.221157, -0.147981, -2.071190, 4.434685, -2.706056};
  constexpr std::array<double, 6> kSecond{0.0, 0.042981, -0.293762, -1.752461, 5.682633, -3.582633};
  const double first = polynomial(kFirst, u) - m[0] / root;
  a[0] = first;
  std::size_t next = 1;
  double scale = 0.0;
  if (n > 5) {
    a[1] = polynomial(kSecond, u) - m[1] / root;
    next = 2;
    scale = std::sqrt((sum - 2.0 * m[0] * m[0] - 2.0 * m[1] * m[1]) / (1.0 - 2.0 * first * first - 2.0 * a[1] * a[1]));
  } else {
    scale = std::sqrt((sum - 2.0 * m[0] * m[0]) / (1.0 - 2.0 * first * first));
  }
  for (std::size_t i = next; i < half; ++i) a[i] = -m[i] / scale;
  return a;
}

double shapiro_p(double w, std::size_t n) {
  constexpr double kPi = 3.14159265358979323846;
  if (n == 3) return std::max(0.0, 6.0 / kPi * (std::asin(std::sqrt(w)) - std::asin(std::sqrt(0.75))));
  const auto count = static_cast<double>(n);
  double y = std::log(1.0 - w);
  double mean = 0.0;
  double deviation = 0.0;
  if (n <= 11) {
    const double gamma = 0.459 * count - 2.273;
    if (y >= gamma) return 0.0;
    y = -std::log(gamma - y);
    constexpr std::array<double, 4> kMean{0.5440, -0.39978, 0.025054, -0.0006714};
    constexpr std::array<double, 4> kDeviation{1.3822, -0.77857, 0.062767, -0.0020322};
    mean = polynomial(kMean, count);
    deviation = std::exp(polynomial(kDeviation, count));
  } else {
    const double x = std::log(count);
    constexpr std::array<double, 4> kMean{-1.5861, -0.31082, -0.083751, 0.0038915};
    constexpr std::array<double, 3> kDeviation{-0.4803, -0.082676, 0.0030302};
    mean = polynomial(kMean, x);
    deviation = std::exp(polynomial(kDeviation, x));
  }
  return upper_tail((y - mean) / deviation);
}

}  // namespace

PairedT paired_t(std::span<const double> differences) {
  const double deviation = differences.size() < 2 ? 0.0 : standard_deviation(differences);
  if (!(deviation > 0.0)) return {kNone, 0, kNone, kNone};
  const auto count = static_cast<double>(differences.size());
  PairedT result;
  result.effect = mean(differences) / deviation;
  result.t = result.effect * std::sqrt(count);
  result.degrees_of_freedom = static_cast<int>(differences.size()) - 1;
  const boost::math::students_t distribution(result.degrees_of_freedom);
  result.p = 2.0 * boost::math::cdf(boost::math::complement(distribution, std::abs(result.t)));
  return result;
}

SignedRank wilcoxon_signed_rank(std::span<const double> differences) {
  std::vector<double> kept;
  for (const double difference : differences) {
    if (difference != 0.0) kept.push_back(difference);
  }
  std::sort(kept.begin(), kept.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  SignedRank result;
  result.count = static_cast<int>(kept.size());
  if (kept.empty()) return result;
  double plus = 0.0;
  double minus = 0.0;
  double ties = 0.0;
  for (std::size_t begin = 0; begin < kept.size();) {
    std::size_t end = begin;
    while (end < kept.size() && std::abs(kept[end]) == std::abs(kept[begin])) ++end;
    const double rank = 0.5 * static_cast<double>(begin + 1 + end);
    const auto size = static_cast<double>(end - begin);
    ties += size * size * size - size;
    for (std::size_t i = begin; i < end; ++i) (kept[i] > 0.0 ? plus : minus) += rank;
    begin = end;
  }
  result.w = std::min(plus, minus);
  result.exact = ties == 0.0 && result.count <= kMostExact;
  if (result.exact) {
    result.p = std::min(1.0, 2.0 * share_at_most(result.count, static_cast<int>(std::lround(result.w))));
    return result;
  }
  const auto n = static_cast<double>(result.count);
  const double variance = n * (n + 1.0) * (2.0 * n + 1.0) / 24.0 - ties / 48.0;
  if (!(variance > 0.0)) return result;
  const double z = (result.w - 0.25 * n * (n + 1.0)) / std::sqrt(variance);
  result.p = std::min(1.0, 2.0 * upper_tail(std::abs(z)));
  return result;
}

Normality shapiro_wilk(std::span<const double> values) {
  std::vector<double> ordered(values.begin(), values.end());
  std::sort(ordered.begin(), ordered.end());
  const std::size_t n = ordered.size();
  if (n < 3 || n > 5000 || ordered.front() == ordered.back()) return {kNone, kNone};
  const std::vector<double> a = shapiro_weights(n);
  double weighted = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) weighted += a[i] * (ordered[n - 1 - i] - ordered[i]);
  const double middle = mean(ordered);
  double squares = 0.0;
  for (const double value : ordered) squares += (value - middle) * (value - middle);
  const double w = std::min(1.0, weighted * weighted / squares);
  return {w, shapiro_p(w, n)};
}

}  // namespace trocar::statistics
