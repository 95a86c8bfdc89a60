#include "engine/plot/decimate.h"

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"

namespace trocar::plot {

std::vector<CurveColumn> decimate(std::span<const double> x, std::span<const double> y, double begin, double end,
                                  int columns) {
  TROCAR_CHECK(x.size() == y.size() && begin < end && columns > 0);
  std::vector<CurveColumn> out(static_cast<std::size_t>(columns));
  const double columns_per_unit = columns / (end - begin);
  const auto from = static_cast<std::size_t>(std::lower_bound(x.begin(), x.end(), begin) - x.begin());
  for (std::size_t i = from; i < x.size() && x[i] <= end; ++i) {
    if (!std::isfinite(y[i])) continue;
    const auto c = std::min(static_cast<std::size_t>((x[i] - begin) * columns_per_unit), out.size() - 1);
    CurveColumn& column = out[c];
    if (!column.filled) {
      column = {true, y[i], y[i], y[i], y[i]};
      continue;
    }
    column.low = std::min(column.low, y[i]);
    column.high = std::max(column.high, y[i]);
    column.last = y[i];
  }
  return out;
}

}  // namespace trocar::plot
