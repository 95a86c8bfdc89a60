#include <algorithm>
#include <array>
#include <cmath>

#include "engine/plot/colour_map.h"

namespace trocar::plot {
namespace {

constexpr std::array<std::string_view, 5> kScaleNames{"linear", "log", "symlog", "percentile", "rank"};

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

/// Where `value` stands among the sorted values: equal ones share the middle of their places.
double rank_of(const std::vector<double>& sorted, double value) {
  if (sorted.size() < 2) return 0.0;
  const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), value);
  const double places = static_cast<double>(sorted.size() - 1);
  if (first == last) {
    if (first == sorted.begin() || first == sorted.end()) return first == sorted.begin() ? 0.0 : 1.0;
    const double below = *(first - 1);
    return (static_cast<double>(first - sorted.begin()) - 1.0 + (value - below) / (*first - below)) / places;
  }
  return 0.5 * static_cast<double>((first - sorted.begin()) + (last - sorted.begin()) - 1) / places;
}

/// 0 at `low`, 1 at `high`; zero lies at the end nearest to it.
double log_position(const Scale& scale, double value) {
  const double held = std::clamp(value, scale.low, scale.high);
  return std::log(held / scale.low) / std::log(scale.high / scale.low);
}

/// What remains of a wish that the values do not allow.
ScaleKind possible_kind(ScaleKind kind, const std::vector<double>& sorted, bool centred_at_zero) {
  if (kind == ScaleKind::kRank && (centred_at_zero || sorted.empty())) return ScaleKind::kPercentile;
  if (kind != ScaleKind::kLog) return kind;
  const bool both = !sorted.empty() && sorted.front() < 0.0 && sorted.back() > 0.0;
  const bool nothing = sorted.empty() || (sorted.front() == 0.0 && sorted.back() == 0.0);
  return both || nothing || centred_at_zero ? ScaleKind::kSymlog : ScaleKind::kLog;
}

}  // namespace

const std::vector<ScaleKind>& all_scale_kinds() {
  static const std::vector<ScaleKind> kinds{ScaleKind::kLinear, ScaleKind::kLog, ScaleKind::kSymlog,
                                            ScaleKind::kPercentile, ScaleKind::kRank};
  return kinds;
}

std::string_view to_string(ScaleKind kind) {
  return kScaleNames[static_cast<std::size_t>(kind)];
}

Result<ScaleKind> scale_kind_from(std::string_view text) {
  for (std::size_t i = 0; i < kScaleNames.size(); ++i) {
    if (kScaleNames[i] == text) return static_cast<ScaleKind>(i);
  }
  return fail(ErrorCode::kInvalidArgument,
              "no scale is named \"" + std::string(text) + "\"; there are linear, log, symlog, percentile, rank");
}

double Scale::position(double value) const {
  if (std::isnan(value)) return 0.0;
  double t = 0.0;
  switch (kind) {
    case ScaleKind::kLog:
      t = log_position(*this, value);
      break;
    case ScaleKind::kSymlog: {
      const double first = symlog(low, linear);
      t = (symlog(std::clamp(value, low, high), linear) - first) / (symlog(high, linear) - first);
      break;
    }
    case ScaleKind::kRank:
      t = rank_of(*sorted, value);
      break;
    default:
      t = (value - low) / (high - low);
  }
  return std::clamp(t, 0.0, 1.0);
}

double Scale::value(double position) const {
  const double t = std::clamp(position, 0.0, 1.0);
  switch (kind) {
    case ScaleKind::kLog:
      return std::clamp(low * std::pow(high / low, t), low, high);
    case ScaleKind::kSymlog: {
      const double first = symlog(low, linear);
      return std::clamp(symlog_inverse(first + t * (symlog(high, linear) - first), linear), low, high);
    }
    case ScaleKind::kRank:
      return quantile(*sorted, t);
    default:
      return low + t * (high - low);
  }
}

Scale fit_scale(ScaleKind kind, const std::vector<double>& values, bool centred_at_zero) {
  std::vector<double> finite;
  finite.reserve(values.size());
  for (const double v : values) {
    if (std::isfinite(v)) finite.push_back(v);
  }
  std::sort(finite.begin(), finite.end());
  Scale scale;
  scale.kind = kind = possible_kind(kind, finite, centred_at_zero);
  if (kind == ScaleKind::kLog) std::erase(finite, 0.0);
  if (!finite.empty()) {
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
    if (kind == ScaleKind::kLog && scale.low < 0.0) {
      scale.low *= 10.0;  // one decade, on the same side of zero
    } else {
      scale.high = scale.low + std::max(1.0, std::abs(scale.low) * 1e-9);
    }
  }
  if (kind == ScaleKind::kRank) scale.sorted = std::make_shared<const std::vector<double>>(std::move(finite));
  return scale;
}

}  // namespace trocar::plot
