#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/plot/colour_map.h"

namespace trocar::plot {
namespace {

/// 1, 2 or 5 times a power of ten, nearest above `raw` by ratio.
double round_step(double raw) {
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double lead = raw / power;
  const double round = lead <= 1.0 + 1e-9 ? 1.0 : lead <= 2.0 + 1e-9 ? 2.0 : lead <= 5.0 + 1e-9 ? 5.0 : 10.0;
  return round * power;
}

/// Powers of ten from `linear` to `end`, thinned to at most `count`, largest first.
std::vector<double> decades(double linear, double end, int count) {
  std::vector<double> powers;
  if (!(end > linear)) return powers;
  const int first = static_cast<int>(std::ceil(std::log10(linear) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(end) + 1e-9));
  const int stride = std::max(1, (last - first + count) / std::max(1, count));
  for (int e = last; e >= first; e -= stride) powers.push_back(std::pow(10.0, e));
  return powers;
}

bool is_zero_or_power(double value) {
  if (value == 0.0) return true;
  const double exponent = std::log10(std::abs(value));
  return std::abs(exponent - std::round(exponent)) < 1e-9;
}

std::string with_true_minus(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '-') {
      out += unicode_minus();
    } else {
      out += c;
    }
  }
  return out;
}

std::vector<double> quantile_ticks(const Scale& scale, int count) {
  std::vector<double> out;
  const int steps = std::max(1, count - 1);
  for (int i = 0; i <= steps; ++i) {
    const double value = scale.value(static_cast<double>(i) / steps);
    if (out.empty() || value > out.back()) out.push_back(value);
  }
  return out;
}

std::vector<double> log_ticks(const Scale& scale, int count) {
  const bool negative = scale.high < 0.0;
  std::vector<double> out = negative ? decades(-scale.high, -scale.low, count) : decades(scale.low, scale.high, count);
  for (double& power : out) power = negative ? -power : power;
  if (!negative) std::reverse(out.begin(), out.end());
  return out.size() >= 2 ? out : ticks(scale.low, scale.high, count);
}

}  // namespace

std::string_view unicode_minus() {
  return "\u2212";
}

std::vector<double> ticks(double low, double high, int count) {
  if (!(low < high) || !std::isfinite(high - low) || count < 1) return {};
  double step = round_step((high - low) / count);
  const double slack = 1e-9 * (high - low);
  std::vector<double> out;
  const double first = std::ceil((low - slack) / step);
  for (double k = first; k * step <= high + slack && out.size() < 1000; k += 1.0) {
    // A whole number of steps, so that zero is zero; divided, where the step is below one, so that 0.3 is 0.3.
    const double value = step < 1.0 ? k / std::round(1.0 / step) : k * step;
    out.push_back(step < 1e-9 || value == 0.0 ? (k == 0.0 ? 0.0 : k * step) : value);
  }
  return out;
}

std::vector<double> ticks(const Scale& scale, int count) {
  if (scale.kind == ScaleKind::kRank) return quantile_ticks(scale, count);
  if (scale.kind == ScaleKind::kLog) return log_ticks(scale, count);
  if (scale.kind != ScaleKind::kSymlog) return ticks(scale.low, scale.high, count);
  const bool both = scale.low < 0.0 && scale.high > 0.0;
  const int each = std::max(1, both ? (count - 1) / 2 : count - 1);
  std::vector<double> out;
  for (const double p : decades(std::max(scale.linear, -scale.high), -scale.low, each)) out.push_back(-p);
  if (scale.low <= 0.0 && scale.high >= 0.0) out.push_back(0.0);
  std::vector<double> above = decades(std::max(scale.linear, scale.low), scale.high, each);
  out.insert(out.end(), above.rbegin(), above.rend());
  // Where the whole range is within a decade, round numbers say more than powers.
  return out.size() >= 3 ? out : ticks(scale.low, scale.high, count);
}

std::string format_tick(double value, double step) {
  if (value == 0.0 || !std::isfinite(value)) return value == 0.0 ? "0" : fmt::format("{}", value);
  const double size = std::abs(value);
  const double gap = std::isfinite(step) && step > 0.0 ? step : size;
  if (size < 1e-9 * gap) return std::string(1, '0');
  if (size >= 1e6 || size < 1e-4) {
    const int digits =
        std::clamp(static_cast<int>(std::floor(std::log10(size)) - std::floor(std::log10(gap) + 1e-9)), 0, 15);
    std::string text = fmt::format("{:.{}e}", value, digits);
    const std::size_t e = text.find('e');
    std::string mantissa = text.substr(0, e);
    if (mantissa.find('.') != std::string::npos) {
      mantissa.erase(mantissa.find_last_not_of('0') + 1);
      if (mantissa.back() == '.') mantissa.pop_back();
    }
    return with_true_minus(fmt::format("{}e{}", mantissa, std::stoi(text.substr(e + 1))));
  }
  const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(gap) + 1e-9)), 0, 12);
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find_first_of("123456789") == std::string::npos) return std::string(1, '0');
  return with_true_minus(text);
}

std::vector<std::string> format_ticks(const Scale& scale, const std::vector<double>& values) {
  double gap = scale.high - scale.low;
  for (std::size_t i = 1; i < values.size(); ++i) gap = std::min(gap, std::abs(values[i] - values[i - 1]));
  std::vector<std::string> out;
  if (scale.kind == ScaleKind::kRank) {
    // Quantiles are no round numbers, and lie far apart here and close there.
    for (const double v : values) out.push_back(format_tick(v, 0.01 * std::abs(v)));
    return out;
  }
  const bool powers = (scale.kind == ScaleKind::kSymlog || scale.kind == ScaleKind::kLog) &&
                      std::all_of(values.begin(), values.end(), is_zero_or_power);
  out.reserve(values.size());
  for (const double v : values) out.push_back(format_tick(v, powers && v != 0.0 ? std::abs(v) : gap));
  return out;
}

}  // namespace trocar::plot
