#include "engine/peg_board/obstacles.h"

#include <algorithm>

#include "engine/peg_board/peg_board.h"

namespace trocar::peg_board {
namespace {

/// Of the peg's axis from the rectangle of a cell, seen from above.
bool touches(const Eigen::Vector3d& foot, const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  const double x = std::clamp(foot.x(), low.x(), high.x()) - foot.x();
  const double y = std::clamp(foot.y(), low.y(), high.y()) - foot.y();
  return x * x + y * y < kPegRadius_m * kPegRadius_m && low.z() < kPegHeight_m;
}

}  // namespace

spatial::CellSet obstacle_cells(const spatial::Grid& grid) {
  spatial::CellSet obstacles(grid);
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5 * grid.cell_m);
  for (std::int32_t cell = 0; cell < grid.cell_count(); ++cell) {
    const Eigen::Vector3d low = grid.centre({cell}) - half;
    const Eigen::Vector3d high = grid.centre({cell}) + half;
    bool hit = low.z() < 0.0;
    for (int i = 0; i < kPegCount / 2; ++i)
      hit = hit || touches(start_peg(i), low, high) || touches(goal_peg(i), low, high);
    if (hit) obstacles.insert({cell});
  }
  return obstacles;
}

}  // namespace trocar::peg_board
