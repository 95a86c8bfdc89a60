#include "engine/learning/slab.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/check.h"

namespace trocar::learning {

Field with_slab(const Field& field, int axis, int index, int thickness) {
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
      double& value = changed.values[at(index)];
      for (int across = first; across <= last; ++across) {
        const double other = field.values[at(across)];
        if (std::isfinite(other) && !(value >= other)) value = other;
      }
    }
  }
  return changed;
}

}  // namespace trocar::learning
