#include "engine/spatial/grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace trocar::spatial {

std::string_view to_string(Action action) {
  constexpr std::array<std::string_view, kActionCount> kNames{"+x", "-x", "+y", "-y", "+z", "-z"};
  return kNames[static_cast<std::size_t>(action)];
}

Grid Grid::with_cells(int cells) {
  Grid grid;
  const double side_m = grid.cell_m * grid.n;
  grid.n = cells;
  grid.cell_m = side_m / cells;
  return grid;
}

Result<CellIndex> Grid::cell_at(const Eigen::Vector3d& p_WQ) const {
  if (!p_WQ.allFinite()) return fail(ErrorCode::kInvalidArgument, "the point is not finite");
  const Eigen::Vector3d p_GQ = (p_WQ - p_WGo) / cell_m;
  const Eigen::Vector3d floored = p_GQ.array().floor();
  if ((floored.array() < 0.0).any() || (floored.array() >= n).any()) {
    return fail(ErrorCode::kOutOfReach, fmt::format("the point ({:.1f}, {:.1f}, {:.1f}) mm is outside of the lattice",
                                                    1e3 * p_WQ.x(), 1e3 * p_WQ.y(), 1e3 * p_WQ.z()));
  }
  return index({static_cast<int>(floored.x()), static_cast<int>(floored.y()), static_cast<int>(floored.z())});
}

Eigen::Vector3d Grid::centre(CellIndex cell) const {
  const CellCoordinates c = coordinates(cell);
  return p_WGo + cell_m * Eigen::Vector3d(c.x + 0.5, c.y + 0.5, c.z + 0.5);
}

std::optional<CellIndex> Grid::neighbour(CellIndex cell, Action action) const {
  CellCoordinates c = coordinates(cell);
  switch (action) {
    case Action::kPlusX:
      ++c.x;
      break;
    case Action::kMinusX:
      --c.x;
      break;
    case Action::kPlusY:
      ++c.y;
      break;
    case Action::kMinusY:
      --c.y;
      break;
    case Action::kPlusZ:
      ++c.z;
      break;
    case Action::kMinusZ:
      --c.z;
      break;
  }
  if (!contains(c)) return std::nullopt;
  return index(c);
}

int CellSet::count() const {
  return std::accumulate(flags_.begin(), flags_.end(), 0);
}

CellSet cells_within(const Grid& grid, const std::vector<CellIndex>& cells, int radius) {
  CellSet set(grid);
  for (const CellIndex cell : cells) {
    const CellCoordinates c = grid.coordinates(cell);
    for (int x = std::max(0, c.x - radius); x <= std::min(grid.n - 1, c.x + radius); ++x) {
      for (int y = std::max(0, c.y - radius); y <= std::min(grid.n - 1, c.y + radius); ++y) {
        for (int z = std::max(0, c.z - radius); z <= std::min(grid.n - 1, c.z + radius); ++z) {
          set.insert(grid.index({x, y, z}));
        }
      }
    }
  }
  return set;
}

}  // namespace trocar::spatial
