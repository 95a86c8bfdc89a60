/// Which cell of the lattice is where in a flat slice. Private to the module.
#pragma once

#include <array>
#include <optional>

#include "engine/figure/field_figure.h"
#include "engine/spatial/grid.h"

namespace trocar::figure {

inline constexpr std::array kAxisLetters{'x', 'y', 'z'};

/// The axes that lie flat: x-slice y, z; y-slice x, z; z-slice y, x.
struct FlatAxes {
  int horizontal = 0;
  int vertical = 1;
};
FlatAxes flat_axes(const Slice& slice);

/// Column from the left, row from the top (the largest vertical coordinate).
struct FlatCell {
  int column = 0;
  int row = 0;
};
spatial::CellIndex cell_at(const spatial::Grid& grid, const Slice& slice, FlatCell flat);
/// Where the cell is drawn; nothing if it is in another slice.
std::optional<FlatCell> flat_cell(const spatial::Grid& grid, const Slice& slice, spatial::CellIndex cell);

/// Low and high edge of the lattice along an axis, in millimetres of W.
struct ExtentMm {
  double low = 0.0;
  double high = 0.0;
};
ExtentMm extent_mm(const spatial::Grid& grid, int axis);
/// Of the middle of the slice, along its axis.
double position_mm(const spatial::Grid& grid, const Slice& slice);

}  // namespace trocar::figure
