#include "engine/exchange/lattice_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "engine/core/ending.h"
#include "engine/core/file.h"
#include "engine/exchange/npy.h"
#include "engine/exchange/number_table.h"
#include "engine/exchange/text_lines.h"

namespace trocar::exchange {
namespace {

using learning::TableKind;

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

std::size_t cells_in(const spatial::Grid& grid) {
  return static_cast<std::size_t>(grid.cell_count());
}

std::vector<std::string> value_names(TableKind kind) {
  if (kind == TableKind::kTheta) return {"theta"};
  std::vector<std::string> names;
  for (int a = 0; a < spatial::kActionCount; ++a) {
    names.emplace_back(spatial::to_string(static_cast<spatial::Action>(a)));
  }
  return names;
}

std::string times(const std::vector<std::size_t>& shape) {
  return shape.empty() ? "a single number" : fmt::format("{}", fmt::join(shape, "x"));
}

tl::unexpected<Error> wrong_shape(const spatial::Grid& grid, TableKind kind, const std::string& found) {
  const int n = grid.n;
  const std::string expected = kind == TableKind::kQ ? fmt::format("{0}x{0}x{0}x6 or {1}x6", n, grid.cell_count())
                                                     : fmt::format("{0}x{0}x{0} or {1}", n, grid.cell_count());
  return fail(ErrorCode::kCorrupt,
              fmt::format("expected {}, found {}; the order is {}", expected, found, table_order(kind)));
}

/// Where the columns of a header are: i, j, k if it has them, and the values.
struct TableHeader {
  std::vector<std::size_t> cell;
  std::vector<std::size_t> values;
};

std::size_t find_name(const std::vector<std::string_view>& names, std::string_view wanted) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), wanted) - names.begin());
}

Result<TableHeader> header_of(const std::vector<std::string_view>& names, TableKind kind) {
  TableHeader header;
  for (const char* name : {"i", "j", "k"}) {
    const std::size_t at = find_name(names, name);
    if (at < names.size()) header.cell.push_back(at);
  }
  if (!header.cell.empty() && header.cell.size() < 3) {
    return wrong_line(1, "the header must have all of the columns i, j and k, or none");
  }
  for (const std::string& name : value_names(kind)) {
    std::size_t at = find_name(names, name);
    if (at == names.size() && kind == TableKind::kTheta) at = find_name(names, "value");
    if (at == names.size()) {
      return wrong_line(
          1, fmt::format("the header has no column {}; it needs {}", name, fmt::join(value_names(kind), ", ")));
    }
    header.values.push_back(at);
  }
  return header;
}

bool is_header(const std::vector<std::string_view>& cells) {
  double ignored = 0.0;
  return std::any_of(cells.begin(), cells.end(),
                     [&ignored](std::string_view cell) { return !parse_cell(cell, false, ignored); });
}

class CsvTable {
 public:
  CsvTable(TableKind kind, const spatial::Grid& grid)
      : kind_(kind),
        grid_(grid),
        width_(static_cast<std::size_t>(learning::table_width(kind))),
        table_(width_ * cells_in(grid), kNotKnown),
        given_(cells_in(grid), false) {
    for (std::size_t i = 0; i < width_; ++i) header_.values.push_back(i);
  }

  Status add(std::string_view line, std::size_t number) {
    const std::vector<std::string_view> cells = cells_of(line, ',');
    if (first_ && is_header(cells)) {
      first_ = false;
      has_header_ = true;
      TROCAR_ASSIGN_OR_RETURN(header_, header_of(cells, kind_));
      return {};
    }
    first_ = false;
    if (!has_header_ && cells.size() != width_) {
      return wrong_line(number, fmt::format("{} numbers without a header, where each cell has {}; the order is {}",
                                            cells.size(), width_, table_order(kind_)));
    }
    TROCAR_ASSIGN_OR_RETURN(const std::size_t cell, cell_of(cells, number));
    if (given_[cell]) return wrong_line(number, "this cell has a line already");
    given_[cell] = true;
    for (std::size_t i = 0; i < width_; ++i) {
      const std::size_t at = header_.values[i];
      if (at >= cells.size() || !parse_cell(cells[at], false, table_[cell * width_ + i])) {
        return wrong_line(number, fmt::format("column {} holds no number", at + 1));
      }
    }
    return {};
  }

  Result<std::vector<double>> finish() {
    if (header_.cell.empty() && rows_ != cells_in(grid_)) {
      return wrong_shape(grid_, kind_, kind_ == TableKind::kQ ? fmt::format("{}x6", rows_) : fmt::format("{}", rows_));
    }
    if (rows_ == 0) return fail(ErrorCode::kCorrupt, "there is no cell in the file");
    return std::move(table_);
  }

 private:
  Result<std::size_t> cell_of(const std::vector<std::string_view>& cells, std::size_t number) {
    const std::size_t row = rows_++;
    if (header_.cell.empty()) {
      if (row >= cells_in(grid_)) return wrong_line(number, fmt::format("more lines than the {} cells", row));
      return row;
    }
    std::array<int, 3> c{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double value = kNotKnown;
      const std::size_t at = header_.cell[axis];
      if (at < cells.size() && !parse_cell(cells[at], false, value)) value = kNotKnown;
      if (!(value >= 0.0 && value < grid_.n) || value != std::floor(value)) {
        return wrong_line(number, fmt::format("{} is no whole number from 0 to {}", "ijk"[axis], grid_.n - 1));
      }
      c[axis] = static_cast<int>(value);
    }
    return static_cast<std::size_t>(grid_.index({c[0], c[1], c[2]}).value);
  }

  TableKind kind_;
  const spatial::Grid& grid_;
  std::size_t width_;
  std::vector<double> table_;
  std::vector<bool> given_;
  TableHeader header_;
  std::size_t rows_ = 0;
  bool first_ = true;
  bool has_header_ = false;
};

std::string table_csv(const std::vector<double>& table, TableKind kind, const spatial::Grid& grid) {
  const auto width = static_cast<std::size_t>(learning::table_width(kind));
  std::string text = fmt::format("i,j,k,{}\n", fmt::join(value_names(kind), ","));
  for (std::size_t s = 0; s < cells_in(grid); ++s) {
    const spatial::CellCoordinates c = grid.coordinates({static_cast<std::int32_t>(s)});
    fmt::format_to(std::back_inserter(text), "{},{},{}", c.x, c.y, c.z);
    for (std::size_t i = 0; i < width; ++i) {
      const double value = table[s * width + i];
      text += ',';
      if (!std::isnan(value)) fmt::format_to(std::back_inserter(text), "{}", value);
    }
    text += '\n';
  }
  return text;
}

tl::unexpected<Error> wrong_ending() {
  return fail(ErrorCode::kInvalidArgument, "a table is a .npy or a .csv");
}

Result<std::vector<double>> read_ending(const std::filesystem::path& path, TableKind kind, const spatial::Grid& grid) {
  const std::string extension = ending_of(path);
  if (extension != ".npy" && extension != ".csv") return wrong_ending();
  TROCAR_ASSIGN_OR_RETURN(const std::string bytes, read_file(path));
  return extension == ".npy" ? parse_table_npy(bytes, kind, grid) : parse_table_csv(bytes, kind, grid);
}

}  // namespace

std::string table_order(TableKind kind) {
  if (kind == TableKind::kTheta) return "x, y, z with z fastest";
  return "x, y, z, action with the action fastest, the actions +x -x +y -y +z -z";
}

Result<std::vector<double>> parse_table_npy(std::string_view bytes, TableKind kind, const spatial::Grid& grid) {
  TROCAR_ASSIGN_OR_RETURN(const std::vector<std::size_t> shape, read_npy_shape(bytes));
  const auto n = static_cast<std::size_t>(grid.n);
  std::vector<std::vector<std::size_t>> good{{n, n, n, 6}, {n * n * n, 6}};
  if (kind == TableKind::kTheta) good = {{n, n, n}, {n * n * n}, {n * n * n, 1}};
  if (std::find(good.begin(), good.end(), shape) == good.end()) return wrong_shape(grid, kind, times(shape));
  TROCAR_ASSIGN_OR_RETURN(NpyNumbers numbers, read_npy_numbers(bytes));
  return std::move(numbers.values);
}

Result<std::vector<double>> parse_table_csv(std::string_view text, TableKind kind, const spatial::Grid& grid) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  CsvTable table(kind, grid);
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = take_line(text);
    if (line.find_first_not_of(" \t") == std::string_view::npos) continue;
    TROCAR_RETURN_IF_ERROR(table.add(line, number));
  }
  return table.finish();
}

Result<std::vector<double>> read_table(const std::filesystem::path& path, TableKind kind, const spatial::Grid& grid) {
  Result<std::vector<double>> table = read_ending(path, kind, grid);
  if (!table) return tl::unexpected(std::move(table).error().at(path.string()));
  return table;
}

Status write_table(const std::vector<double>& table, TableKind kind, const spatial::Grid& grid,
                   const std::filesystem::path& path) {
  const std::string extension = ending_of(path);
  if (extension == ".csv") return write_file(path, table_csv(table, kind, grid));
  if (extension != ".npy") return tl::unexpected(Error(wrong_ending().value()).at(path.string()));
  const auto n = static_cast<std::size_t>(grid.n);
  std::vector<std::size_t> shape{n, n, n};
  if (kind == TableKind::kQ) shape.push_back(6);
  return write_file(path, to_npy(NpyNumbers{std::move(shape), table}));
}

}  // namespace trocar::exchange
