/// Lines and cells of a text file, whichever system wrote it. Private to the module.
#pragma once

#include <fmt/format.h>

#include <string_view>

#include "engine/core/result.h"

namespace trocar::exchange {

/// Takes the next line off `text` and returns it without its end, LF or CRLF.
inline std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

inline bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

/// A cell without the blanks around it and the quotation marks around what is left.
inline std::string_view bare_cell(std::string_view cell) {
  while (!cell.empty() && is_blank(cell.front())) cell.remove_prefix(1);
  while (!cell.empty() && is_blank(cell.back())) cell.remove_suffix(1);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
  return cell;
}

/// The error that names a line, counted from 1.
inline tl::unexpected<Error> wrong_line(std::size_t line, std::string_view what) {
  return fail(ErrorCode::kCorrupt, fmt::format("line {}: {}", line, what));
}

}  // namespace trocar::exchange
