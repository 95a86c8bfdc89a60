#include "engine/learning/start_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "engine/core/file.h"
#include "engine/learning/start_set.h"

namespace trocar::learning {
namespace {

std::vector<std::string_view> fields_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    std::string_view part = text.substr(begin, end - begin);
    while (!part.empty() && (part.back() == '\r' || part.back() == ' ')) part.remove_suffix(1);
    while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
    parts.push_back(part);
    begin = end + 1;
  }
  return parts;
}

bool parse_whole(std::string_view text, int& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

/// Column of each of i, j, k in the header line.
Result<std::array<std::size_t, 3>> columns_of(std::string_view header) {
  const std::vector<std::string_view> names = fields_of(header, ',');
  std::array<std::size_t, 3> columns{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view wanted = std::string_view("ijk").substr(axis, 1);
    const auto found = std::find(names.begin(), names.end(), wanted);
    if (found == names.end()) return fail(ErrorCode::kCorrupt, fmt::format("the header has no column {}", wanted));
    columns[axis] = static_cast<std::size_t>(found - names.begin());
  }
  return columns;
}

}  // namespace

Result<std::vector<spatial::CellIndex>> parse_starts(std::string_view text, const spatial::Grid& grid) {
  const std::vector<std::string_view> lines = fields_of(text, '\n');
  TROCAR_ASSIGN_OR_RETURN(const auto columns, columns_of(lines.front()));
  std::vector<spatial::CellIndex> starts;
  for (std::size_t row = 1; row < lines.size(); ++row) {
    if (lines[row].empty()) continue;
    const std::vector<std::string_view> values = fields_of(lines[row], ',');
    std::array<int, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (columns[axis] >= values.size() || !parse_whole(values[columns[axis]], cell[axis])) {
        return fail(ErrorCode::kCorrupt, fmt::format("line {} holds no whole numbers i, j, k", row + 1));
      }
    }
    const spatial::CellCoordinates coordinates{cell[0], cell[1], cell[2]};
    if (!grid.contains(coordinates)) {
      return fail(ErrorCode::kCorrupt, fmt::format("line {} is a cell outside of the lattice", row + 1));
    }
    starts.push_back(grid.index(coordinates));
  }
  if (starts.empty()) return fail(ErrorCode::kCorrupt, "there is no start in the file");
  return starts;
}

Result<std::vector<spatial::CellIndex>> read_starts(std::string_view text, const Model& model) {
  if (!text.starts_with(kStartFile)) return starts_from(text, model);
  const std::string path(text.substr(kStartFile.size()));
  TROCAR_ASSIGN_OR_RETURN(const std::string content, read_file(path));
  Result<std::vector<spatial::CellIndex>> starts = parse_starts(content, model.grid);
  if (!starts) return tl::unexpected<Error>(std::move(starts).error().in("read the starts").at(path));
  return starts;
}

}  // namespace trocar::learning
