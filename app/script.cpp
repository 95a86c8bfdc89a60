#include "app/script.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace trocar::app {
namespace {

/// The words of one line, quotes removed; nothing after a # that begins a word. No value for an open quote.
std::optional<std::vector<std::string>> words_of(std::string_view line) {
  std::vector<std::string> words;
  bool quoted = false;
  bool in_word = false;
  for (const char c : line) {
    const bool space = c == ' ' || c == '\t' || c == '\r';
    if (!quoted && !in_word && c == '#') break;
    if (!quoted && space) {
      in_word = false;
      continue;
    }
    if (!in_word) words.emplace_back();
    in_word = true;
    if (c == '"') {
      quoted = !quoted;
    } else {
      words.back() += c;
    }
  }
  if (quoted) return std::nullopt;
  return words;
}

Result<std::string> replaced(std::string_view word, const Variables& variables, std::set<std::string>& unused) {
  std::string result;
  for (std::size_t at = 0; at < word.size();) {
    const std::size_t begin = word.find("${", at);
    result += word.substr(at, begin - at);
    if (begin == std::string_view::npos) break;
    const std::size_t end = word.find('}', begin);
    if (end == std::string_view::npos) return fail(ErrorCode::kCorrupt, fmt::format("{} lacks its }}", word));
    const std::string name(word.substr(begin + 2, end - begin - 2));
    const auto found = variables.find(name);
    if (found == variables.end()) return fail(ErrorCode::kCorrupt, fmt::format("no variable is named {}", name));
    result += found->second;
    unused.erase(name);
    at = end + 1;
  }
  return result;
}

std::string title_of(const std::vector<std::string>& words) {
  std::string title;
  for (const std::string& word : words) {
    std::string_view shown = word;
    if (shown.starts_with("${out}/")) shown.remove_prefix(7);
    const bool spaced = shown.find(' ') != std::string_view::npos;
    title += fmt::format("{}{}{}{}", title.empty() ? "" : " ", spaced ? "\"" : "", shown, spaced ? "\"" : "");
  }
  return title;
}

}  // namespace

Result<std::vector<ScriptStep>> parse_script(std::string_view text, Variables variables,
                                             const std::set<std::string>& given) {
  std::set<std::string> unused = given;
  std::vector<ScriptStep> steps;
  int number = 0;
  std::string title;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    const auto words = words_of(line);
    begin = end + 1;
    ++number;
    if (line.starts_with("## ")) title = line.substr(3);
    const std::string where = fmt::format("read line {}", number);
    if (!words) return tl::unexpected(Error(ErrorCode::kCorrupt, "a quote is not closed").in(where));
    if (words->empty()) continue;
    ScriptStep step{number, title.empty() ? title_of(*words) : std::exchange(title, {}), {}};
    for (const std::string& word : *words) {
      Result<std::string> value = replaced(word, variables, unused);
      if (!value) return tl::unexpected(std::move(value).error().in(where));
      step.arguments.push_back(std::move(*value));
    }
    if (step.arguments.front() == "default" && step.arguments.size() == 3) {
      variables.emplace(step.arguments[1], step.arguments[2]);
      unused.erase(step.arguments[1]);
      continue;
    }
    if (step.arguments.front() == "trocar") step.arguments.erase(step.arguments.begin());
    if (!step.arguments.empty()) steps.push_back(std::move(step));
  }
  if (unused.empty()) return steps;
  return fail(ErrorCode::kInvalidArgument, fmt::format("the script has no variable named {}", *unused.begin()));
}

}  // namespace trocar::app
