#include "engine/statistics/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace trocar::statistics {
namespace {
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
}  // namespace

double mean(std::span<const double> values) {
  if (values.empty()) return kNaN;
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double standard_deviation(std::span<const double> values) {
  if (values.size() < 2) return kNaN;
  const double middle = mean(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - middle) * (value - middle);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

double median(std::span<const double> values) {
  if (values.empty()) return kNaN;
  std::vector<double> sorted(values.begin(), values.end());
  const std::size_t half = sorted.size() / 2;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(half), sorted.end());
  if (sorted.size() % 2 == 1) return sorted[half];
  const double below = *std::max_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(half));
  return 0.5 * (below + sorted[half]);
}

}  // namespace trocar::statistics
