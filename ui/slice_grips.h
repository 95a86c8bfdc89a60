/// The corners by which slices of a field are moved in the 3-D view: where they lie on the picture and how far a drag
/// goes. No drawing, so that it can be tested.
#pragma once

#include <array>
#include <vector>

#include "engine/spatial/grid.h"
#include "ui/gizmo.h"

namespace trocar::ui {

struct SliceGrip {
  int axis = 0;   ///< 0 x, 1 y, 2 z.
  int index = 0;  ///< Of the cells that the slice cuts.
  Eigen::Vector3d p_W;
  Eigen::Vector2f at;                    ///< On the picture, pixels.
  std::vector<Eigen::Vector2f> outline;  ///< Of the slice, likewise, closed.
};

/// Of the slices that are shown (index −1: not), at the corner nearest to the eye, the uppermost of x and y. What lies
/// behind the camera is left out.
std::vector<SliceGrip> slice_grips(const spatial::Grid& grid, const std::array<int, 3>& slices, const ViewPort& view);

/// The index that a drag between two pixels leads to, within the lattice.
int dragged_to(const SliceGrip& grip, const spatial::Grid& grid, const ViewPort& view, const Eigen::Vector2f& from,
               const Eigen::Vector2f& to);

}  // namespace trocar::ui
