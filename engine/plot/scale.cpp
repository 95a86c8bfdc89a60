#include <algorithm>
#include <array>
#include <cmath>

#include "engine/plot/colour_map.h"

namespace trocar::plot {
namespace {

constexpr std::array<std::string_view, 3> kScaleNames{"linear", "symlog", "percentile"};

double symlog(double value, double linear) {
  const double size = std::abs(value) / linear;
  return std::copysign(size <= 1.0 ? size : 1.0 + std::log10(size), value);
}

double symlog_inverse(double mapped, double linear) {
  const double size = std::abs(mapped);
  return std::copysign(linear * (size <= 1.0 ? size : std::pow(10.0, size - 1.0)), mapped);
}

/// Of sorted values, by linear interpolation; precondition: not empty.
double quantile(const std::vector<double>& sorted, double q) {
  const double at = q * static_cast<double>(sorted.size() - 1);
  const auto i = static_cast<std::size_t>(at);
  if (i + 1 >= sorted.size()) return sorted.back();
  return sorted[i] + (at - static_cast<double>(i)) * (sorted[i + 1] - sorted[i]);
}

double symlog_linear_part(const std::vector<double>& finite) {
  std::vector<double> sizes;
  for (const double v : finite) {
    if (v != 0.0) sizes.push_back(std::abs(v));
  }
  if (sizes.empty()) return 1.0;
  std::sort(sizes.begin(), sizes.end());
  return std::max(quantile(sizes, 0.05), 1e-4 * sizes.back());
}

}  // namespace

std::string_view to_string(ScaleKind kind) {
  return kScaleNames[static_cast<std::size_t>(kind)];
}

Result<ScaleKind> scale_kind_from(std::string_view text) {
  for (std::size_t i = 0; i < kScaleNames.size(); ++i) {
    if (kScaleNames[i] == text) return static_cast<ScaleKind>(i);
  }
  return fail(ErrorCode::kInvalidArgument,
              "no scale is named \"" + std::string(text) + "\"; there are linear, symlog, percentile");
}

double Scale::position(double value) const {
  if (std::isnan(value)) return 0.0;
  double t = 0.0;
  if (kind == ScaleKind::kSymlog) {
    const double first = symlog(low, linear);
    t = (symlog(std::clamp(value, low, high), linear) - first) / (symlog(high, linear) - first);
  } else {
    t = (value - low) / (high - low);
  }
  return std::clamp(t, 0.0, 1.0);
}

double Scale::value(double position) const {
  const double t = std::clamp(position, 0.0, 1.0);
  if (kind != ScaleKind::kSymlog) return low + t * (high - low);
  const double first = symlog(low, linear);
  return std::clamp(symlog_inverse(first + t * (symlog(high, linear) - first), linear), low, high);
}

Scale fit_scale(ScaleKind kind, const std::vector<double>& values, bool centred_at_zero) {
  std::vector<double> finite;
  finite.reserve(values.size());
  for (const double v : values) {
    if (std::isfinite(v)) finite.push_back(v);
  }
  Scale scale;
  scale.kind = kind;
  if (!finite.empty()) {
    std::sort(finite.begin(), finite.end());
    const bool clip = kind == ScaleKind::kPercentile;
    scale.low = quantile(finite, clip ? 0.02 : 0.0);
    scale.high = quantile(finite, clip ? 0.98 : 1.0);
    if (!(scale.low < scale.high)) {
      scale.low = finite.front();
      scale.high = finite.back();
    }
    scale.linear = symlog_linear_part(finite);
  }
  if (centred_at_zero) {
    const double reach = finite.empty() ? 0.0 : std::max(std::abs(scale.low), std::abs(scale.high));
    scale.high = reach > 0.0 ? reach : 1.0;
    scale.low = -scale.high;
  } else if (!(scale.low < scale.high)) {
    scale.high = scale.low + std::max(1.0, std::abs(scale.low) * 1e-9);
  }
  return scale;
}

}  // namespace trocar::plot
