/// A table of a foreign file as far as an import needs it: names of columns, and the numbers of some of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/exchange/column_map.h"

namespace trocar::exchange {

/// How a text is cut into lines and cells; part of `ColumnMap`.
struct TextLayout {
  char delimiter = ',';  ///< A blank: any number of blanks and tabs is one.
  bool decimal_comma = false;
  std::string comment = "#";
  int header_lines = 1;

  static TextLayout of(const ColumnMap& map);
};

/// The cells of a line, without quotes and the blanks around them; views of `line`.
std::vector<std::string_view> cells_of(std::string_view line, char delimiter);

/// The number in a cell; NaN for an empty one, "nan" and "null". False for anything else.
bool parse_cell(std::string_view cell, bool decimal_comma, double& value);

/// A file of text or of NumPy's; views of bytes that outlive it.
class NumberTable {
 public:
  /// Errors: kCorrupt if there are no lines after the header.
  static Result<NumberTable> of_text(std::string_view text, const TextLayout& layout);
  /// An array of two dimensions, of real or whole numbers of 4 or 8 bytes. Errors: kCorrupt, kUnsupported.
  static Result<NumberTable> of_npy(std::string_view bytes);

  std::size_t width() const { return width_; }
  std::size_t rows() const { return is_text_ ? lines_.size() : array_.size() / width_; }
  /// As in the header; empty without one.
  const std::vector<std::string>& names() const { return names_; }
  /// The name of column `i`, or its number.
  std::string shown(std::size_t i) const;
  /// "line 7" or "row 7".
  std::string place(std::size_t row) const;

  /// "3 rows have more cells than there are columns, the first is line 7; those are not read"; empty if none has.
  std::string too_wide() const;

  /// Errors: kInvalidArgument for a column that is not there, or a name that several have.
  Result<std::size_t> find(const ColumnName& name) const;
  /// Of `columns`, in that order; NaN where there is none. Errors: kCorrupt for a cell that is no number.
  Status read(std::size_t row, const std::vector<std::size_t>& columns, std::vector<double>& into) const;
  /// Of all columns; NaN for what is no number.
  std::vector<double> read_all(std::size_t row) const;

 private:
  bool is_text_ = true;
  std::size_t width_ = 1;
  std::vector<std::string> names_;
  TextLayout layout_;
  std::vector<std::string_view> lines_;
  std::vector<std::size_t> numbers_;  ///< Of the lines in the file.
  std::vector<double> array_;
  std::size_t too_wide_ = 0;
  std::size_t first_too_wide_ = 0;
};

}  // namespace trocar::exchange
