#include "engine/figure/field_files.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <iterator>

#include "engine/core/file.h"
#include "engine/spatial/units.h"

namespace trocar::figure {
namespace {

/// The cells to write, in the order of CellIndex.
std::vector<spatial::CellIndex> cells_of(const spatial::Grid& grid, const std::optional<Slice>& slice) {
  std::vector<spatial::CellIndex> cells;
  for (std::int32_t i = 0; i < grid.cell_count(); ++i) {
    const spatial::CellCoordinates c = grid.coordinates({i});
    const int along = !slice ? 0 : slice->axis == 0 ? c.x : slice->axis == 1 ? c.y : c.z;
    if (!slice || along == slice->index) cells.push_back({i});
  }
  return cells;
}

/// Picometres away from a multiple of a nanometre are rounding, not position.
double tidy_mm(double metres) {
  return std::round(spatial::to_mm(metres) * 1e6) / 1e6;
}

}  // namespace

Status write_csv(const learning::Field& field, const std::optional<Slice>& slice, const std::filesystem::path& path) {
  std::string text = "i,j,k,x_mm,y_mm,z_mm,value\n";
  for (const spatial::CellIndex cell : cells_of(field.grid, slice)) {
    const spatial::CellCoordinates c = field.grid.coordinates(cell);
    const Eigen::Vector3d p = field.grid.centre(cell);
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},", c.x, c.y, c.z, tidy_mm(p.x()), tidy_mm(p.y()),
                   tidy_mm(p.z()));
    const double value = field.values[static_cast<std::size_t>(cell.value)];
    if (std::isfinite(value)) fmt::format_to(std::back_inserter(text), "{}", value);
    text += '\n';
  }
  return write_file(path, text);
}

Status write_npy(const learning::Field& field, const std::optional<Slice>& slice, const std::filesystem::path& path) {
  static_assert(std::endian::native == std::endian::little);
  const int n = field.grid.n;
  const std::string shape = slice ? fmt::format("({}, {})", n, n) : fmt::format("({}, {}, {})", n, n, n);
  std::string header = fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': {}, }}", shape);
  // Magic, version and length are 10 bytes; the whole is padded to a multiple of 64 and ends with a newline.
  header.append(63 - (10 + header.size()) % 64, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 0xFFU);
  bytes += static_cast<char>(header.size() >> 8U);
  bytes += header;
  for (const spatial::CellIndex cell : cells_of(field.grid, slice)) {
    const auto raw = std::bit_cast<std::array<char, 8>>(field.values[static_cast<std::size_t>(cell.value)]);
    bytes.append(raw.data(), raw.size());
  }
  return write_file(path, bytes);
}

}  // namespace trocar::figure
