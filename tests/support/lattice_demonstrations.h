/// Demonstrations as cells for tests: what segment A looks like on the paper's lattice.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <vector>

#include "engine/core/random.h"
#include "engine/learning/model.h"

namespace trocar::testing {

/// From `start` to `column` moves above `goal` in single steps along x, y and z in an order drawn from `seed`, then
/// straight down onto the goal. Precondition: the cell above lies on the lattice.
inline learning::CellSequence approach_from_above(const spatial::Grid& grid, const spatial::CellCoordinates& start,
                                                  const spatial::CellCoordinates& goal, int column,
                                                  std::uint64_t seed) {
  Random random(seed);
  const spatial::CellCoordinates above{goal.x, goal.y, goal.z + column};
  spatial::CellCoordinates at = start;
  learning::CellSequence cells{grid.index(at)};
  while (!(at == above)) {
    const int left[3] = {above.x - at.x, above.y - at.y, above.z - at.z};
    const int total = std::abs(left[0]) + std::abs(left[1]) + std::abs(left[2]);
    auto draw = static_cast<int>(random.below(static_cast<std::uint32_t>(total)));
    int* const coordinate[3] = {&at.x, &at.y, &at.z};
    for (int axis = 0; axis < 3; ++axis) {
      draw -= std::abs(left[axis]);
      if (draw >= 0) continue;
      *coordinate[axis] += left[axis] > 0 ? 1 : -1;
      break;
    }
    cells.push_back(grid.index(at));
  }
  for (; at.z > goal.z; cells.push_back(grid.index(at))) --at.z;
  return cells;
}

/// One demonstration for each of the six start pegs: from the ready pose to 18 mm above the grasp, on a lattice of
/// 22 · `scale` cells a side.
inline std::vector<learning::CellSequence> sample_demonstrations(int scale = 1) {
  const spatial::Grid grid = spatial::Grid::with_cells(22 * scale);
  constexpr spatial::CellCoordinates kGoals[] = {{1, 10, 10},  {20, 10, 10}, {6, 18, 10},
                                                 {15, 18, 10}, {6, 2, 10},   {15, 2, 10}};
  std::vector<learning::CellSequence> demonstrations;
  for (const spatial::CellCoordinates& goal : kGoals) {
    const std::uint64_t number = demonstrations.size();
    const int column = (4 + static_cast<int>(number % 3)) * scale;
    demonstrations.push_back(approach_from_above(grid, {11 * scale, 12 * scale, 19 * scale},
                                                 {goal.x * scale, goal.y * scale, goal.z * scale}, column, number));
  }
  return demonstrations;
}

/// `cells` with the waypoint at `index` moved one cell along +x (+y where the path runs along x), joined to the rest by
/// single steps: what remains when somebody drags a point of the path. Precondition: 0 < index < cells.size() − 1.
inline learning::CellSequence with_moved_waypoint(const spatial::Grid& grid, const learning::CellSequence& cells,
                                                  std::size_t index) {
  const spatial::CellCoordinates before = grid.coordinates(cells[index - 1]);
  const spatial::CellCoordinates after = grid.coordinates(cells[index + 1]);
  const auto aside = before.x != after.x ? spatial::Action::kPlusY : spatial::Action::kPlusX;
  learning::CellSequence moved(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(index));
  for (std::size_t i = index - 1; i <= index + 1; ++i) moved.push_back(grid.neighbour(cells[i], aside).value());
  moved.insert(moved.end(), cells.begin() + static_cast<std::ptrdiff_t>(index) + 1, cells.end());
  return moved;
}

}  // namespace trocar::testing
