#include "engine/demonstration/discretise.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace trocar::demonstration {

using spatial::CellCoordinates;
using spatial::CellIndex;
using spatial::Grid;

std::vector<CellIndex> steps_between(const Grid& grid, CellIndex from, CellIndex to) {
  std::vector<CellIndex> cells;
  const CellCoordinates a = grid.coordinates(from);
  const CellCoordinates b = grid.coordinates(to);
  const std::array<int, 3> difference{b.x - a.x, b.y - a.y, b.z - a.z};
  std::array<int, 3> at{a.x, a.y, a.z};
  std::array<int, 3> taken{0, 0, 0};
  const int steps = std::abs(difference[0]) + std::abs(difference[1]) + std::abs(difference[2]);
  for (int step = 0; step < steps; ++step) {
    std::size_t next = 3;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int total = std::abs(difference[axis]);
      if (taken[axis] == total) continue;
      // The crossing is at (taken + ½) / total of the line; compared crosswise, in whole numbers, so that ties are
      // ties.
      if (next == 3 || (2 * taken[axis] + 1) * std::abs(difference[next]) < (2 * taken[next] + 1) * total) next = axis;
    }
    at[next] += difference[next] > 0 ? 1 : -1;
    ++taken[next];
    cells.push_back(grid.index({at[0], at[1], at[2]}));
  }
  return cells;
}

namespace {

// Along each axis the coordinate of `kept`, unless the point lies clearly beyond it.
CellIndex with_hysteresis(const Grid& grid, CellIndex kept, CellIndex cell, const Eigen::Vector3d& p_WQ) {
  const CellCoordinates a = grid.coordinates(kept);
  const CellCoordinates b = grid.coordinates(cell);
  const Eigen::Vector3d off = (p_WQ - grid.centre(kept)).cwiseAbs() / grid.cell_m;
  const auto along = [&off](int axis, int from, int to) { return off[axis] < 0.5 + kCellHysteresis ? from : to; };
  return grid.index({along(0, a.x, b.x), along(1, a.y, b.y), along(2, a.z, b.z)});
}

}  // namespace

Result<CellPath> discretise(const Demonstration& demonstration, Segment label, const Grid& grid) {
  const std::optional<SegmentSpan> span = demonstration.segment(label);
  if (!span) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("{} has no segment {}", demonstration.name, letter(label)));
  }
  CellPath path;
  int inside = 0;
  double error_sum_m = 0.0;
  for (const Sample& sample : demonstration.samples_in(*span)) {
    const std::array<float, 3>& p = sample.arms[0].measured.p;
    const Eigen::Vector3d p_WT(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
    const Result<CellIndex> holds = grid.cell_at(p_WT);
    if (!holds) {
      ++path.outside;
      continue;
    }
    const CellIndex cell = path.cells.empty() ? *holds : with_hysteresis(grid, path.cells.back(), *holds, p_WT);
    const double error_m = (p_WT - grid.centre(cell)).norm();
    path.max_error_m = std::max(path.max_error_m, error_m);
    error_sum_m += error_m;
    ++inside;
    if (path.cells.empty()) {
      path.cells.push_back(cell);
    } else {
      for (const CellIndex next : steps_between(grid, path.cells.back(), cell)) path.cells.push_back(next);
    }
  }
  if (path.cells.size() < 2) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("segment {} of {} covers fewer than 2 cells of the lattice ({} samples lie outside of it)",
                            letter(label), demonstration.name, path.outside));
  }
  path.mean_error_m = error_sum_m / inside;
  return path;
}

}  // namespace trocar::demonstration
