#include "ui/driver/script.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace trocar::ui {
namespace {

struct Verb {
  std::string_view name;
  std::size_t least;  ///< Words, the verb included.
  std::size_t most;
  std::size_t first_number;  ///< Words from here on must be numbers; 0: none.
};
constexpr std::array<Verb, 13> kVerbs{{{"click", 2, 2, 0},
                                       {"right_click", 2, 2, 0},
                                       {"double_click", 2, 2, 0},
                                       {"hover", 2, 2, 0},
                                       {"drag", 4, 5, 2},
                                       {"wheel", 3, 3, 2},
                                       {"type", 3, 3, 0},
                                       {"key", 2, 2, 0},
                                       {"expect", 3, 4, 0},
                                       {"wait", 2, 4, 0},
                                       {"screenshot", 2, 2, 0},
                                       {"frames", 2, 2, 1},
                                       {"dump", 2, 2, 0}}};

tl::unexpected<Error> at_line(int number, const std::string& why) {
  return fail(ErrorCode::kInvalidArgument, "line " + std::to_string(number) + ": " + why);
}

bool is_number(std::string_view word) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && end == word.data() + word.size();
}

// Nothing if a quotation is not closed.
std::optional<std::vector<std::string>> split(std::string_view line) {
  std::vector<std::string> words;
  std::size_t i = 0;
  while (i < line.size()) {
    if (line[i] == ' ' || line[i] == '\t' || line[i] == '\r') {
      ++i;
      continue;
    }
    if (line[i] == '#') break;
    std::string word;
    if (line[i] == '"') {
      for (++i; i < line.size() && line[i] != '"'; ++i) {
        if (line[i] == '\\' && i + 1 < line.size()) ++i;
        word += line[i];
      }
      if (i >= line.size()) return std::nullopt;
      ++i;
    } else {
      while (i < line.size() && line[i] != ' ' && line[i] != '\t' && line[i] != '\r') word += line[i++];
    }
    words.push_back(std::move(word));
  }
  return words;
}

bool known_expectation(const std::vector<std::string>& words) {
  const std::string& what = words[2];
  if (what == "value" || what == "contains") return words.size() == 4;
  return words.size() == 3 && (what == "enabled" || what == "disabled" || what == "present" || what == "absent");
}

bool known_wait(const std::vector<std::string>& words) {
  if (words[1] == "idle") return words.size() == 2 || (words.size() == 3 && is_number(words[2]));
  if (words[1] == "for") return words.size() == 3 || (words.size() == 4 && is_number(words[3]));
  return false;
}

Status check(const ScriptLine& line) {
  const auto* verb = std::find_if(kVerbs.begin(), kVerbs.end(), [&](const Verb& v) { return v.name == line.words[0]; });
  if (verb == kVerbs.end()) return at_line(line.number, "\"" + line.words[0] + "\" is no verb");
  if (line.words.size() < verb->least || line.words.size() > verb->most) {
    return at_line(line.number, "\"" + line.words[0] + "\" has too few or too many words");
  }
  for (std::size_t i = verb->first_number; i > 0 && i < line.words.size(); ++i) {
    if (!is_number(line.words[i])) return at_line(line.number, "\"" + line.words[i] + "\" is no number");
  }
  if (verb->name == "expect" && !known_expectation(line.words)) {
    return at_line(line.number, "expect value W, contains W, enabled, disabled, present or absent");
  }
  if (verb->name == "wait" && !known_wait(line.words)) {
    return at_line(line.number, "wait idle [SECONDS] or wait for \"LABEL\" [SECONDS]");
  }
  return {};
}

}  // namespace

Result<std::vector<ScriptLine>> parse_script(std::string_view text) {
  std::vector<ScriptLine> lines;
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    ++number;
    auto words = split(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!words) return at_line(number, "a quotation is not closed");
    if (words->empty()) continue;
    ScriptLine line{number, std::move(*words)};
    TROCAR_RETURN_IF_ERROR(check(line));
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace trocar::ui
