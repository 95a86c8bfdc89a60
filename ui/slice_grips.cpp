#include "ui/slice_grips.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace trocar::ui {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3d;

/// The corners of a slice in order round it.
std::array<Vector3d, 4> corners_of(const spatial::Grid& grid, int axis, int index) {
  const double side_m = grid.n * grid.cell_m;
  const int right = (axis + 1) % 3;
  const int up = (axis + 2) % 3;
  std::array<Vector3d, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    Vector3d p = Vector3d::Zero();
    p[axis] = (index + 0.5) * grid.cell_m;
    p[right] = i == 1 || i == 2 ? side_m : 0.0;
    p[up] = i >= 2 ? side_m : 0.0;
    corners[i] = grid.p_WGo + p;
  }
  return corners;
}

double depth_m(const ViewPort& view, const Vector3d& p_W) {
  return view.camera.X_WC.rotation().col(2).dot(p_W - view.camera.X_WC.p);
}

}  // namespace

std::vector<SliceGrip> slice_grips(const spatial::Grid& grid, const std::array<int, 3>& slices, const ViewPort& view) {
  constexpr double kSame_m = 1e-9;
  std::vector<SliceGrip> grips;
  for (int axis = 0; axis < 3; ++axis) {
    const int index = slices[static_cast<std::size_t>(axis)];
    if (index < 0 || index >= grid.n) continue;
    SliceGrip grip;
    grip.axis = axis;
    grip.index = index;
    std::optional<Vector3d> best;
    for (const Vector3d& corner : corners_of(grid, axis, index)) {
      const std::optional<Vector2f> pixel = view.pixel(corner);
      if (!pixel) continue;
      grip.outline.push_back(*pixel);
      const bool higher = best && corner.z() > best->z() + kSame_m;
      const bool lower = best && corner.z() < best->z() - kSame_m;
      if (best && (lower || (!higher && depth_m(view, corner) >= depth_m(view, *best)))) continue;
      best = corner;
      grip.at = *pixel;
    }
    if (grip.outline.size() < 4) continue;
    grip.p_W = *best;
    grips.push_back(std::move(grip));
  }
  return grips;
}

int dragged_to(const SliceGrip& grip, const spatial::Grid& grid, const ViewPort& view, const Vector2f& from,
               const Vector2f& to) {
  const spatial::Pose X_WG = spatial::Pose::translation(grip.p_W);
  const Vector3d by_m = dragged_by({HandleKind::kAxis, grip.axis}, X_WG, view, from, to);
  const int cells = static_cast<int>(std::lround(by_m[grip.axis] / grid.cell_m));
  return std::clamp(grip.index + cells, 0, grid.n - 1);
}

}  // namespace trocar::ui
