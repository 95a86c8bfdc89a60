#include "engine/exchange/number_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "engine/exchange/npy.h"
#include "engine/exchange/text_lines.h"

namespace trocar::exchange {
namespace {

/// Where the cell at the front of `line` ends; a quoted one may hold delimiters.
std::size_t end_of_cell(std::string_view line, char delimiter) {
  std::size_t at = 0;
  while (at < line.size() && is_blank(line[at]) && line[at] != delimiter) ++at;
  if (at < line.size() && line[at] == '"') {
    const std::size_t closing = line.find('"', at + 1);
    if (closing != std::string_view::npos) at = closing;
  }
  return line.find(delimiter, at);
}

}  // namespace

TextLayout TextLayout::of(const ColumnMap& map) {
  const char delimiter = map.delimiter == "tab" ? '\t' : map.delimiter == "space" ? ' ' : map.delimiter[0];
  return {delimiter, map.decimal == ",", map.comment, map.header_lines};
}

std::vector<std::string_view> cells_of(std::string_view line, char delimiter) {
  std::vector<std::string_view> cells;
  if (delimiter == ' ') {
    for (;;) {
      while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
      if (line.empty()) return cells;
      const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
      cells.push_back(bare_cell(line.substr(0, end)));
      line.remove_prefix(end);
    }
  }
  for (;;) {
    const std::size_t end = end_of_cell(line, delimiter);
    cells.push_back(bare_cell(line.substr(0, end)));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

bool parse_cell(std::string_view cell, bool decimal_comma, double& value) {
  value = std::numeric_limits<double>::quiet_NaN();
  if (cell.empty() || cell == "null") return true;
  if (cell.front() == '+') cell.remove_prefix(1);
  constexpr std::size_t kLongest = 64;
  if (cell.empty() || cell.size() > kLongest) return false;
  std::string text(cell);
  if (decimal_comma) {
    if (text.find('.') != std::string::npos) return false;
    std::replace(text.begin(), text.end(), ',', '.');
  }
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  return parsed.ec == std::errc() && parsed.ptr == text.data() + text.size();
}

Result<NumberTable> NumberTable::of_text(std::string_view text, const TextLayout& layout) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  NumberTable table;
  table.layout_ = layout;
  int header = layout.header_lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = take_line(text);
    const bool comment = !layout.comment.empty() && line.starts_with(layout.comment);
    if (comment || line.find_first_not_of(" \t") == std::string_view::npos) continue;
    if (header > 0) {
      table.names_.clear();
      for (const std::string_view name : cells_of(line, layout.delimiter)) table.names_.emplace_back(name);
      --header;
      continue;
    }
    table.lines_.push_back(line);
    table.numbers_.push_back(number);
  }
  if (table.lines_.empty()) return fail(ErrorCode::kCorrupt, "the table has no rows");
  table.width_ = std::max(table.names_.size(), cells_of(table.lines_.front(), layout.delimiter).size());
  for (std::size_t row = 0; row < table.lines_.size(); ++row) {
    const std::string_view line = table.lines_[row];
    const auto cuts = static_cast<std::size_t>(std::count(line.begin(), line.end(), layout.delimiter));
    if (cuts < table.width_ || cells_of(line, layout.delimiter).size() <= table.width_) continue;
    if (table.too_wide_++ == 0) table.first_too_wide_ = row;
  }
  return table;
}

Result<NumberTable> NumberTable::of_npy(std::string_view bytes) {
  NumberTable table;
  table.is_text_ = false;
  TROCAR_ASSIGN_OR_RETURN(NpyArray array, read_npy_array(bytes));
  table.width_ = array.width;
  table.array_ = std::move(array.values);
  return table;
}

std::string NumberTable::shown(std::size_t i) const {
  return i < names_.size() && !names_[i].empty() ? names_[i].substr(0, 60) : fmt::format("#{}", i + 1);
}

std::string NumberTable::place(std::size_t row) const {
  return is_text_ ? fmt::format("line {}", numbers_[row]) : fmt::format("row {}", row + 1);
}

std::string NumberTable::too_wide() const {
  if (too_wide_ == 0) return "";
  return fmt::format("{} more cells than there are columns, the first is {}; those are not read",
                     too_wide_ == 1 ? std::string("1 row has") : fmt::format("{} rows have", too_wide_),
                     place(first_too_wide_));
}

Result<std::size_t> NumberTable::find(const ColumnName& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found != names_.end()) {
    if (std::find(found + 1, names_.end(), name) == names_.end())
      return static_cast<std::size_t>(found - names_.begin());
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("several columns are named \"{}\"; give the number of the one that is meant", name));
  }
  std::size_t place = 0;
  const auto parsed =
      std::from_chars(name.data() + std::min<std::size_t>(1, name.size()), name.data() + name.size(), place);
  const bool number = name.starts_with('#') && parsed.ec == std::errc() && parsed.ptr == name.data() + name.size();
  if (number && place >= 1 && place <= width_) return place - 1;
  return fail(ErrorCode::kInvalidArgument, number
                                               ? fmt::format("there is no column {}, the table has {}", place, width_)
                                               : fmt::format("no column is named \"{}\"", name.substr(0, 60)));
}

Status NumberTable::read(std::size_t row, const std::vector<std::size_t>& columns, std::vector<double>& into) const {
  into.resize(columns.size());
  if (!is_text_) {
    for (std::size_t i = 0; i < columns.size(); ++i) into[i] = array_[row * width_ + columns[i]];
    return {};
  }
  const std::vector<std::string_view> cells = cells_of(lines_[row], layout_.delimiter);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string_view cell = columns[i] < cells.size() ? cells[columns[i]] : std::string_view();
    if (parse_cell(cell, layout_.decimal_comma, into[i])) continue;
    return fail(ErrorCode::kCorrupt,
                fmt::format("{}: {} must be a number, not \"{}\"", place(row), shown(columns[i]), cell.substr(0, 40)));
  }
  return {};
}

std::vector<double> NumberTable::read_all(std::size_t row) const {
  std::vector<double> values(width_, std::numeric_limits<double>::quiet_NaN());
  const std::vector<std::string_view> cells =
      is_text_ ? cells_of(lines_[row], layout_.delimiter) : std::vector<std::string_view>();
  for (std::size_t i = 0; i < width_; ++i) {
    if (!is_text_) {
      values[i] = array_[row * width_ + i];
    } else if (i < cells.size() && !parse_cell(cells[i], layout_.decimal_comma, values[i])) {
      values[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  return values;
}

}  // namespace trocar::exchange
