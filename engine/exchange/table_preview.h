/// The columns of a foreign table with their first cells: what a person looks at to say which is what.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/exchange/column_map.h"
#include "engine/exchange/exchange.h"

namespace trocar::exchange {

struct TableColumn {
  ColumnName name;                 ///< As a map names it.
  std::vector<std::string> cells;  ///< Of the first rows, at most 3; numbers as they are read, "–" for what is none.
};

/// Cut as the map says, which need not name columns that are there. Errors: kIo; kCorrupt for what is no table.
Result<std::vector<TableColumn>> table_columns(const std::filesystem::path& path, Format format, const ColumnMap& map);

}  // namespace trocar::exchange
