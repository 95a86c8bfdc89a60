/// The columns of the library, as one table: the panel, the command line, queries and sorting are made from it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/workbench/library.h"

namespace trocar::workbench {

/// What a row has in a column, as it is shown: lengths in millimetres, shares in per cent.
struct LibraryCell {
  enum class Kind : std::uint8_t {
    kNone,     ///< There is no such value.
    kPending,  ///< It is being worked out.
    kNumber,
    kText,
  };
  Kind kind = Kind::kNone;
  double number = 0.0;
  std::string text;
};

struct LibraryColumn {
  std::string_view id;     ///< In queries, on the command line and in settings: "jerk".
  std::string_view title;  ///< "Jerk"
  std::string_view unit;   ///< "mm", or "".
  std::string_view help;
  bool number = false;    ///< Else text.
  int decimals = 0;       ///< Of a number, when shown.
  bool measured = false;  ///< It takes time to work out.
  LibraryCell (*cell)(const LibraryRow& row) = nullptr;
};

std::span<const LibraryColumn> library_columns();
/// Null if there is none with that id.
const LibraryColumn* find_library_column(std::string_view id);
/// "12.3", "ABCDE"; "–" for none and "…" for what is being worked out.
std::string shown_cell(const LibraryColumn& column, const LibraryRow& row);

/// Those without a value last, whichever the direction; equals stay in their order.
void sort_library(std::vector<const LibraryRow*>& rows, const LibraryColumn& by, bool descending);

}  // namespace trocar::workbench
