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
  std::string_view usage;
};
constexpr std::array<Verb, 17> kVerbs{
    {{"click", 2, 2, 0, "click LABEL"},
     {"right_click", 2, 2, 0, "right_click LABEL"},
     {"double_click", 2, 2, 0, "double_click LABEL"},
     {"hover", 2, 2, 0, "hover LABEL"},
     {"drag", 4, 5, 2, "drag LABEL DX DY [BUTTON]"},
     {"hold", 4, 4, 2, "hold LABEL DX DY"},
     {"wheel", 3, 3, 2, "wheel LABEL STEPS"},
     {"type", 3, 3, 0, "type LABEL TEXT"},
     {"key", 2, 2, 0, "key CHORD"},
     {"key_down", 2, 2, 0, "key_down Ctrl | Shift | Alt | KEY"},
     {"key_up", 2, 2, 0, "key_up Ctrl | Shift | Alt | KEY"},
     {"drop", 2, 2, 0, "drop FILE"},
     {"expect", 3, 4, 0, "expect LABEL value TEXT | contains TEXT | enabled | disabled | present | absent"},
     {"wait", 2, 5, 0, "wait idle [SECONDS] | for LABEL [SECONDS] | until LABEL TEXT [SECONDS]"},
     {"screenshot", 2, 2, 0, "screenshot F.png"},
     {"frames", 2, 2, 1, "frames COUNT"},
     {"dump", 2, 2, 0, "dump F.json"}}};

tl::unexpected<Error> at_line(int number, const std::string& why) {
  return fail(ErrorCode::kInvalidArgument, "line " + std::to_string(number) + ": " + why);
}

std::string verb_names() {
  std::string names;
  for (const Verb& verb : kVerbs) names += (names.empty() ? "" : ", ") + std::string(verb.name);
  return names;
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
  if (words[1] == "until") return words.size() == 4 || (words.size() == 5 && is_number(words[4]));
  if (words[1] == "for") return words.size() == 3 || (words.size() == 4 && is_number(words[3]));
  return false;
}

Status check(const ScriptLine& line) {
  const auto* verb = std::find_if(kVerbs.begin(), kVerbs.end(), [&](const Verb& v) { return v.name == line.words[0]; });
  if (verb == kVerbs.end()) {
    return at_line(line.number, "\"" + line.words[0] + "\" is no verb; there are " + verb_names());
  }
  if (line.words.size() < verb->least || line.words.size() > verb->most) {
    return at_line(line.number,
                   "\"" + line.words[0] + "\" has too few or too many words; write " + std::string(verb->usage));
  }
  for (std::size_t i = verb->first_number; i > 0 && i < line.words.size(); ++i) {
    if (!is_number(line.words[i]))
      return at_line(line.number, "\"" + line.words[i] + "\" is no number; write " + std::string(verb->usage));
  }
  if (verb->name == "expect" && !known_expectation(line.words)) {
    return at_line(line.number, "expect value W, contains W, enabled, disabled, present or absent");
  }
  if (verb->name == "wait" && !known_wait(line.words)) {
    return at_line(line.number,
                   "wait idle [SECONDS], wait for \"LABEL\" [SECONDS] or wait until \"LABEL\" \"TEXT\" [SECONDS]");
  }
  return {};
}

}  // namespace

std::string script_verbs() {
  std::string text;
  for (const Verb& verb : kVerbs) text += "  " + std::string(verb.usage) + "\n";
  return text;
}

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
