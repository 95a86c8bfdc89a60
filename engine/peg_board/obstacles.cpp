#include "engine/peg_board/obstacles.h"

#include <algorithm>
#include <cmath>

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

namespace {

/// Of a point from an upright cylinder that stands on the board.
double from_peg_m(const Eigen::Vector3d& p_WQ, const Eigen::Vector3d& foot) {
  const double aside = std::hypot(p_WQ.x() - foot.x(), p_WQ.y() - foot.y()) - kPegRadius_m;
  const double above = p_WQ.z() - kPegHeight_m;
  if (aside <= 0.0 && above <= 0.0) return std::max(aside, above);
  return std::hypot(std::max(aside, 0.0), std::max(above, 0.0));
}

}  // namespace

double clearance_m(const Eigen::Vector3d& p_WQ) {
  double least_m = p_WQ.z();
  for (int i = 0; i < kPegCount / 2; ++i) {
    least_m = std::min({least_m, from_peg_m(p_WQ, start_peg(i)), from_peg_m(p_WQ, goal_peg(i))});
  }
  return least_m;
}

std::vector<double> clearances_m(const spatial::Grid& grid) {
  std::vector<double> clearances(static_cast<std::size_t>(grid.cell_count()));
  for (std::int32_t cell = 0; cell < grid.cell_count(); ++cell) {
    clearances[static_cast<std::size_t>(cell)] = clearance_m(grid.centre({cell}));
  }
  return clearances;
}

}  // namespace trocar::peg_board
