#include "engine/plot/axis.h"

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/plot/colour_map.h"

namespace trocar::plot {
namespace {

constexpr double kMargin = 0.06;
constexpr double kNear = 0.6;

}  // namespace

Axis axis_over(double low, double high, double length_px, double tick_px) {
  TROCAR_CHECK(low < high && std::isfinite(high - low));
  Axis axis;
  axis.low = low;
  axis.high = high;
  const int wanted = std::max(1, static_cast<int>(length_px / std::max(tick_px, 1.0)));
  axis.ticks = ticks(low, high, wanted);
  // One mark alone tells no scale; two may stand closer than wished.
  for (int more = 1; axis.ticks.size() < 2 && length_px >= tick_px && more <= 4; ++more) {
    axis.ticks = ticks(low, high, wanted + more);
  }
  axis.labels = format_ticks(Scale{ScaleKind::kLinear, low, high, 1.0}, axis.ticks);
  return axis;
}

Extent value_range(const Extent& data, bool from_zero, const std::vector<Band>& bands) {
  Extent range = data;
  const double size = std::max(std::abs(data.low), std::abs(data.high));
  for (const Band& band : bands) {
    const double middle = std::isfinite(band.low + band.high) ? 0.5 * (band.low + band.high) : 0.0;
    const auto near = [middle](double value, double limit) {
      return std::isfinite(limit) && (value - middle) / (limit - middle) > kNear;
    };
    if (near(data.high, band.high)) range.high = std::max(range.high, band.high);
    if (near(data.low, band.low)) range.low = std::min(range.low, band.low);
  }
  if (from_zero && range.low >= 0.0) range.low = 0.0;
  // A flat line stands in the middle of something that can be read.
  const double least = size > 0.0 ? 1e-3 * size : 1.0;
  if (range.high - range.low < least) {
    if (range.low != 0.0 || !from_zero) range.low -= 0.5 * least;
    range.high = range.low + least;
  }
  const double margin = kMargin * (range.high - range.low);
  if (!from_zero || range.low < 0.0) range.low -= margin;
  range.high += margin;
  return range;
}

}  // namespace trocar::plot
