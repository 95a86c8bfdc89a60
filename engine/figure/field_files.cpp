#include "engine/figure/field_files.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
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

template <typename Number>
void append_raw(Number value, std::string& bytes) {
  const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  bytes.append(raw.data(), raw.size());
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? std::uint32_t{static_cast<std::uint8_t>(bytes[i + k])} : 0U;
    };
    const std::uint32_t three = byte(0) << 16U | byte(1) << 8U | byte(2);
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[three >> (18U - 6U * k) & 63U];
    }
  }
  return text;
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
    append_raw(field.values[static_cast<std::size_t>(cell.value)], bytes);
  }
  return write_file(path, bytes);
}

Status write_vti(const learning::Field& field, const std::filesystem::path& path) {
  const spatial::Grid& grid = field.grid;
  const int n = grid.n;
  std::string raw;
  const auto bytes = static_cast<std::uint32_t>(static_cast<std::size_t>(grid.cell_count()) * sizeof(double));
  append_raw(bytes, raw);
  for (int z = 0; z < n; ++z) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) append_raw(field.values[static_cast<std::size_t>(grid.index({x, y, z}).value)], raw);
    }
  }
  const std::string_view name = learning::to_string(field.layer);
  const double cell = tidy_mm(grid.cell_m);
  const std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt32\">\n"
      "  <ImageData WholeExtent=\"0 {0} 0 {0} 0 {0}\" Origin=\"{1} {2} {3}\" Spacing=\"{4} {4} {4}\">\n"
      "    <Piece Extent=\"0 {0} 0 {0} 0 {0}\">\n"
      "      <CellData Scalars=\"{5}\">\n"
      "        <DataArray type=\"Float64\" Name=\"{5}\" format=\"binary\">{6}</DataArray>\n"
      "      </CellData>\n"
      "    </Piece>\n"
      "  </ImageData>\n"
      "</VTKFile>\n",
      n, tidy_mm(grid.p_WGo.x()), tidy_mm(grid.p_WGo.y()), tidy_mm(grid.p_WGo.z()), cell, name, base64(raw));
  return write_file(path, text);
}

}  // namespace trocar::figure
