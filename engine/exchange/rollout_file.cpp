#include "engine/exchange/rollout_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "engine/core/ending.h"
#include "engine/core/file.h"
#include "engine/exchange/hdf5_process.h"
#include "engine/exchange/new_file.h"

namespace trocar::exchange {
namespace {

using Kind = TreeNode::Kind;
using Json = nlohmann::ordered_json;

/// Hashes and seeds may have more digits than a float64 holds.
constexpr std::array<std::string_view, 5> kTextColumns{"end", "last_moves", "state_hash", "model_hash", "seed"};
/// Known in every row.
constexpr std::array<std::string_view, 7> kWholeColumns{"i",          "j",         "k", "steps", "divergence_step",
                                                        "from_above", "continuous"};

template <std::size_t N>
bool is_among(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

struct RowTable {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> columns;  ///< As they are written; "" where nothing is known.
};

std::vector<std::string> cells_of_line(std::string_view line) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.emplace_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return cells;
}

/// Our own tables have no quotes, and as many cells in each row as names.
RowTable table_of(std::string_view csv) {
  RowTable table;
  for (std::size_t begin = 0; begin < csv.size();) {
    const std::size_t end = std::min(csv.find('\n', begin), csv.size());
    std::vector<std::string> cells = cells_of_line(csv.substr(begin, end - begin));
    begin = end + 1;
    if (table.names.empty()) {
      table.names = std::move(cells);
      table.columns.resize(table.names.size());
      continue;
    }
    for (std::size_t i = 0; i < std::min(cells.size(), table.columns.size()); ++i) {
      table.columns[i].push_back(std::move(cells[i]));
    }
  }
  return table;
}

double number_of_cell(const std::string& cell) {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return value;
}

Json value_of_cell(const std::string& name, const std::string& cell) {
  if (is_among(kTextColumns, name)) return cell;
  std::int64_t whole = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), whole);
  if (error == std::errc{} && end == cell.data() + cell.size()) return whole;
  const double value = number_of_cell(cell);
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

std::string json_of(const RowTable& table, const std::map<std::string, std::string>& about) {
  Json json = Json::object();
  for (const auto& [name, text] : about) json[name] = text;
  json["columns"] = table.names;
  Json rows = Json::array();
  for (std::size_t row = 0; !table.columns.empty() && row < table.columns.front().size(); ++row) {
    Json one = Json::object();
    for (std::size_t i = 0; i < table.names.size(); ++i) {
      one[table.names[i]] = value_of_cell(table.names[i], table.columns[i][row]);
    }
    rows.push_back(std::move(one));
  }
  json["rollouts"] = std::move(rows);
  return json.dump(1) + "\n";
}

TreeNode column_node(const std::string& name, const std::vector<std::string>& cells) {
  if (is_among(kTextColumns, name)) return texts_node(name, cells);
  std::vector<double> numbers;
  numbers.reserve(cells.size());
  for (const std::string& cell : cells) numbers.push_back(number_of_cell(cell));
  return array_node(name, is_among(kWholeColumns, name) ? Kind::kInt64 : Kind::kFloat64, {numbers.size()}, numbers);
}

Status write_columns(const RowTable& table, const std::map<std::string, std::string>& about,
                     const std::filesystem::path& path) {
  TROCAR_ASSIGN_OR_RETURN(const std::filesystem::path target, replaceable_file(path));
  NewFile file(target);
  TROCAR_ASSIGN_OR_RETURN(Hdf5Writer writer, Hdf5Writer::create(file.path()));
  TreeNode root;
  for (const auto& [name, text] : about) root.attributes[name] = text;
  root.attributes["columns"] = table.names;
  TROCAR_RETURN_IF_ERROR(writer.add(root));
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    TROCAR_RETURN_IF_ERROR(writer.add(column_node(table.names[i], table.columns[i])));
  }
  TROCAR_RETURN_IF_ERROR(writer.finish());
  return file.put_in_place();
}

}  // namespace

Status write_rollout_rows(const std::string& csv, const std::map<std::string, std::string>& about,
                          const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  if (ending == ".csv") return write_file(path, csv);
  if (ending == ".json") return write_file(path, json_of(table_of(csv), about));
  if (ending != ".h5" && ending != ".hdf5") {
    return tl::unexpected(
        Error(ErrorCode::kInvalidArgument, "rollouts are written as .csv, .json or .h5").at(path.string()));
  }
  Status written = write_columns(table_of(csv), about, path);
  if (!written) return tl::unexpected(std::move(written).error().at(path.string()));
  return {};
}

}  // namespace trocar::exchange
