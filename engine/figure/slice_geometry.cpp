#include "engine/figure/slice_geometry.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "engine/spatial/units.h"

namespace trocar::figure {

Result<Slice> slice_from(std::string_view text, const spatial::Grid& grid) {
  const auto refuse = [&] {
    return fail(
        ErrorCode::kInvalidArgument,
        fmt::format("\"{}\" is no slice of this lattice; write x=N, y=N or z=N with N from 0 to {}", text, grid.n - 1));
  };
  if (text.size() < 3 || text[0] < 'x' || text[0] > 'z' || text[1] != '=') return refuse();
  Slice slice{text[0] - 'x', 0};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + 2, end, slice.index);
  if (error != std::errc() || stop != end || slice.index < 0 || slice.index >= grid.n) return refuse();
  return slice;
}

FlatAxes flat_axes(const Slice& slice) {
  constexpr std::array<FlatAxes, 3> kAxes{{{1, 2}, {0, 2}, {1, 0}}};
  return kAxes[static_cast<std::size_t>(slice.axis)];
}

spatial::CellIndex cell_at(const spatial::Grid& grid, const Slice& slice, FlatCell flat) {
  const FlatAxes axes = flat_axes(slice);
  std::array<int, 3> c{};
  c[static_cast<std::size_t>(slice.axis)] = slice.index;
  c[static_cast<std::size_t>(axes.horizontal)] = flat.column;
  c[static_cast<std::size_t>(axes.vertical)] = grid.n - 1 - flat.row;
  return grid.index({c[0], c[1], c[2]});
}

std::optional<FlatCell> flat_cell(const spatial::Grid& grid, const Slice& slice, spatial::CellIndex cell) {
  const FlatAxes axes = flat_axes(slice);
  const spatial::CellCoordinates at = grid.coordinates(cell);
  const std::array<int, 3> c{at.x, at.y, at.z};
  if (c[static_cast<std::size_t>(slice.axis)] != slice.index) return std::nullopt;
  return FlatCell{c[static_cast<std::size_t>(axes.horizontal)],
                  grid.n - 1 - c[static_cast<std::size_t>(axes.vertical)]};
}

ExtentMm extent_mm(const spatial::Grid& grid, int axis) {
  const double low = grid.p_WGo[axis];
  return {spatial::to_mm(low), spatial::to_mm(low + grid.n * grid.cell_m)};
}

double position_mm(const spatial::Grid& grid, const Slice& slice) {
  return spatial::to_mm(grid.p_WGo[slice.axis] + (slice.index + 0.5) * grid.cell_m);
}

}  // namespace trocar::figure
