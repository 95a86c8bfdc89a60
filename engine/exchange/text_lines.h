/// Lines of a text file, whichever system wrote it. Private to the module.
#pragma once

#include <string_view>

namespace trocar::exchange {

/// Takes the next line off `text` and returns it without its end, LF or CRLF.
inline std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace trocar::exchange
