#include "engine/exchange/table_preview.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/file.h"
#include "engine/exchange/number_table.h"

namespace trocar::exchange {
namespace {

constexpr std::size_t kRows = 3;

Result<NumberTable> table_of(std::string_view bytes, Format format, const ColumnMap& map) {
  return format == Format::kNpy ? NumberTable::of_npy(bytes) : NumberTable::of_text(bytes, TextLayout::of(map));
}

/// By its place where the header has no name for it, or several columns have that name.
ColumnName name_of(const NumberTable& table, std::size_t i) {
  const bool named = i < table.names().size() && !table.names()[i].empty() && table.find(table.names()[i]);
  return named ? table.names()[i] : fmt::format("#{}", i + 1);
}

}  // namespace

Result<std::vector<TableColumn>> table_columns(const std::filesystem::path& path, Format format, const ColumnMap& map) {
  TROCAR_ASSIGN_OR_RETURN(const std::string bytes, read_file(path));
  const Result<NumberTable> table = table_of(bytes, format, map);
  if (!table) return tl::unexpected(Error(table.error()).at(path.string()));
  std::vector<TableColumn> columns(table->width());
  for (std::size_t i = 0; i < columns.size(); ++i) columns[i].name = name_of(*table, i);
  for (std::size_t row = 0; row < std::min(kRows, table->rows()); ++row) {
    const std::vector<double> numbers = table->read_all(row);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const bool known = i < numbers.size() && std::isfinite(numbers[i]);
      columns[i].cells.push_back(known ? fmt::format("{:.6g}", numbers[i]) : "–");
    }
  }
  return columns;
}

}  // namespace trocar::exchange
