#include "engine/learning/slab.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/core/check.h"

namespace trocar::learning {

std::string_view to_string(Through through) {
  return through == Through::kMean ? "mean" : "largest";
}

Result<Through> through_from(std::string_view text) {
  for (const Through through : all_through()) {
    if (text == to_string(through)) return through;
  }
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("\"{}\" is nothing that a slab shows: use largest or mean", text));
}

const std::vector<Through>& all_through() {
  static const std::vector<Through> kAll{Through::kLargest, Through::kMean};
  return kAll;
}

Field with_slab(const Field& field, int axis, int index, int thickness, Through through) {
  const spatial::Grid& grid = field.grid;
  TROCAR_CHECK(axis >= 0 && axis < 3 && index >= 0 && index < grid.n && thickness >= 1);
  Field changed = field;
  if (thickness == 1 || field.categorical) return changed;
  const int first = std::max(index - (thickness - 1) / 2, 0);
  const int last = std::min(index + thickness / 2, grid.n - 1);
  for (int u = 0; u < grid.n; ++u) {
    for (int v = 0; v < grid.n; ++v) {
      const auto at = [&](int across) {
        std::array<int, 3> c{across, u, v};
        std::rotate(c.begin(), c.begin() + (3 - axis) % 3, c.end());
        return static_cast<std::size_t>(grid.index({c[0], c[1], c[2]}).value);
      };
      double largest = std::numeric_limits<double>::quiet_NaN();
      double sum = 0.0;
      int known = 0;
      for (int across = first; across <= last; ++across) {
        const double value = field.values[at(across)];
        if (!std::isfinite(value)) continue;
        if (!(largest >= value)) largest = value;
        sum += value;
        ++known;
      }
      changed.values[at(index)] = through == Through::kMean && known > 0 ? sum / known : largest;
    }
  }
  return changed;
}

}  // namespace trocar::learning
