#include "engine/figure/fitted_text.h"

#include <algorithm>

namespace trocar::figure {

std::string fitted(const canvas::Canvas& canvas, std::string text, const canvas::TextStyle& letters, double width) {
  if (canvas.text_width(text, letters) <= width) return text;
  const auto is_inside_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  while (!text.empty() && canvas.text_width(text + "…", letters) > width) {
    while (text.size() > 1 && is_inside_letter(text.back())) text.pop_back();
    text.pop_back();
  }
  return text + "…";
}

std::vector<std::string> wrapped(const canvas::Canvas& canvas, std::string_view text, const canvas::TextStyle& letters,
                                 double width) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' ', 1), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end);
    if (!line.empty() && canvas.text_width(line + std::string(word), letters) > width) {
      lines.push_back(line);
      line = word.substr(std::min(word.find_first_not_of(' '), word.size()));
    } else {
      line += word;
    }
  }
  if (!line.empty()) lines.push_back(line);
  for (std::string& each : lines) each = fitted(canvas, each, letters, width);
  return lines;
}

}  // namespace trocar::figure
