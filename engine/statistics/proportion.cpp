#include "engine/statistics/proportion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"

namespace trocar::statistics {

Interval wilson_interval(std::int64_t successes, std::int64_t count, double z) {
  TROCAR_CHECK(successes >= 0 && successes <= count);
  if (count == 0) return {};
  const auto n = static_cast<double>(count);
  const double share = static_cast<double>(successes) / n;
  const double middle = (share + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half = z / (1.0 + z * z / n) * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
  // At the ends the formula is exact but its rounding is not.
  return {successes == 0 ? 0.0 : std::max(0.0, middle - half), successes == count ? 1.0 : std::min(1.0, middle + half)};
}

double mcnemar_exact_p(int only_a, int only_b) {
  TROCAR_CHECK(only_a >= 0 && only_b >= 0);
  const int n = only_a + only_b;
  const int fewer = std::min(only_a, only_b);
  // Logarithms, since 2^−n leaves the range of a double at n = 1075.
  double log_term = -n * std::log(2.0);
  double tail = std::exp(log_term);
  for (int k = 1; k <= fewer; ++k) {
    log_term += std::log(static_cast<double>(n - k + 1) / k);
    tail += std::exp(log_term);
  }
  return std::min(1.0, 2.0 * tail);
}

Interval paired_difference_interval(int only_a, int only_b, int pairs, double z) {
  if (pairs <= 0) return {-1.0, 1.0};
  const double a = only_a + 0.5;
  const double b = only_b + 0.5;
  const double n = pairs + 2.0;
  const double difference = (b - a) / n;
  const double error = std::sqrt((a + b) - (b - a) * (b - a) / n) / n;
  return {std::max(difference - z * error, -1.0), std::min(difference + z * error, 1.0)};
}

std::string share_text(double share, int digits) {
  const double least = std::pow(10.0, -digits);
  const auto words = [digits](double percent) { return fmt::format("{:.{}f} %", percent, digits); };
  const std::string text = words(100.0 * share);
  if (share < 1.0 && text == words(100.0)) return ">" + words(100.0 - least);
  if (share > 0.0 && text == words(0.0)) return "<" + words(least);
  return text;
}

std::string points_text(double difference, int digits) {
  const double size = std::abs(difference);
  const double least = std::pow(10.0, -digits);
  const std::string_view sign = difference < 0.0 ? "−" : "+";
  const auto words = [digits](double points) { return fmt::format("{:.{}f}", points, digits); };
  const std::string text = words(100.0 * size);
  if (size == 0.0) return text;
  if (size < 1.0 && text == words(100.0))
    return fmt::format("{}{}{}", difference < 0.0 ? "<" : ">", sign, words(100.0 - least));
  if (text == words(0.0)) return fmt::format("{}{}{}", difference < 0.0 ? ">" : "<", sign, words(least));
  return fmt::format("{}{}", sign, text);
}

std::string percent_text(std::int64_t part, std::int64_t whole, int digits) {
  if (whole <= 0) return "–";
  return share_text(static_cast<double>(part) / static_cast<double>(whole), digits);
}

}  // namespace trocar::statistics
