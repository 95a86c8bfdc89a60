#include "engine/demonstration/edit_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "engine/demonstration/edit_fields.h"
#include "engine/spatial/units.h"

namespace trocar::demonstration {
namespace {

tl::unexpected<Error> wrong(std::string message) {
  return fail(ErrorCode::kInvalidArgument, std::move(message));
}

struct Unit {
  std::string_view ending;  ///< Of the key.
  std::string_view typed;   ///< Ending of the option.
  double factor;
  std::string_view shown;
};
// Longer endings first.
constexpr std::array<Unit, 8> kUnits{{{"_m_s3", "-mm-s3", 1e3, "mm/s³"},
                                      {"_m_s2", "-mm-s2", 1e3, "mm/s²"},
                                      {"_m_s", "-mm-s", 1e3, "mm/s"},
                                      {"_rad_s", "-deg-s", spatial::to_degrees(1.0), "°/s"},
                                      {"_rad", "-deg", spatial::to_degrees(1.0), "°"},
                                      {"_hz", "-hz", 1.0, "Hz"},
                                      {"_m", "-mm", 1e3, "mm"},
                                      {"_s", "", 1.0, "s"}}};

class WordWriter {
 public:
  template <typename Value>
  void field(const Field& field, const Value& value) {
    const TypedField how = typed(field.key);
    const std::string text = written(value, how.factor);
    if (field.positional) {
      words.push_back(text);
    } else if constexpr (std::is_same_v<Value, bool>) {
      words.push_back(fmt::format("--{}={}", how.option, value ? "yes" : "no"));
    } else {
      words.insert(words.end(), {"--" + how.option, text});
    }
  }
  std::vector<std::string> words;

 private:
  static std::string written(double value, double factor) { return typed_number(value * factor); }
  static std::string written(const std::string& value, double) { return value; }
  static std::string written(const Eigen::Vector2d& value, double factor) {
    return fmt::format("{}:{}", typed_number(value.x() * factor), typed_number(value.y() * factor));
  }
  static std::string written(const Eigen::Vector3d& value, double factor) {
    return fmt::format("{},{},{}", typed_number(value.x() * factor), typed_number(value.y() * factor),
                       typed_number(value.z() * factor));
  }
  template <typename Value>
  static std::string written(const Value& value, double factor) {
    if constexpr (std::is_enum_v<Value>) {
      return std::string(words_of<Value>()[static_cast<std::size_t>(value)]);
    } else if constexpr (std::is_same_v<Value, bool>) {
      return value ? "yes" : "no";
    } else if constexpr (std::is_integral_v<Value>) {
      return std::to_string(value);
    } else {
      std::vector<std::string> parts;
      parts.reserve(value.size());
      for (const auto& element : value) parts.push_back(written(element, factor));
      return fmt::format("{}", fmt::join(parts, ","));
    }
  }
};

/// Makes a form's row of each parameter.
struct OptionLister {
  std::vector<EditOption> options;

  template <typename Value>
  void field(const Field& field, const Value& value) {
    const TypedField how = typed(field.key);
    EditOption row{how.option, {}, how.unit, field.help, field.positional, std::is_same_v<Value, bool>, {}, {}, false};
    std::string word(field.key);
    for (const Unit& unit : kUnits) {
      if (!word.ends_with(unit.ending)) continue;
      word.resize(word.size() - unit.ending.size());
      break;
    }
    std::replace(word.begin(), word.end(), '_', '-');
    row.label = title_of(word);
    if constexpr (std::is_enum_v<Value>) {
      for (const std::string_view choice : words_of<Value>()) row.choices.emplace_back(choice);
    }
    WordWriter writer;
    writer.field(Field{field.key, field.help, true}, value);
    row.text = writer.words.front();
    row.number = std::is_arithmetic_v<Value> && !row.flag;
    options.push_back(std::move(row));
  }
};

template <typename Number>
bool read_number(std::string_view text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    parts.push_back(text.substr(0, comma));
    text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
  }
  return parts;
}

/// Reads one typed value; each returns what it should have been, or "" if it is fine.
struct WordReader {
  static std::string read(std::string_view text, double factor, double& value) {
    if (!read_number(text, value) || !std::isfinite(value)) return "a number";
    value /= factor;
    return "";
  }
  static std::string read(std::string_view text, double, std::string& value) {
    value = std::string(text);
    return "";
  }
  static std::string read(std::string_view text, double, bool& value) {
    value = text == "yes";
    return value || text == "no" ? "" : "yes or no";
  }
  static std::string read(std::string_view text, double factor, Eigen::Vector2d& value) {
    const std::size_t colon = text.find(':');
    if (colon != std::string_view::npos && read(text.substr(0, colon), factor, value.x()).empty() &&
        read(text.substr(colon + 1), factor, value.y()).empty()) {
      return "";
    }
    return "two numbers with a colon between";
  }
  static std::string read(std::string_view text, double factor, Eigen::Vector3d& value) {
    const std::vector<std::string_view> parts = parts_of(text);
    if (parts.size() != 3) return "three numbers separated by commas";
    for (std::size_t i = 0; i < 3; ++i) {
      if (!read(parts[i], factor, value[static_cast<Eigen::Index>(i)]).empty()) {
        return "three numbers separated by commas";
      }
    }
    return "";
  }
  template <typename Value>
  static std::string read(std::string_view text, double factor, Value& value) {
    if constexpr (std::is_enum_v<Value>) {
      const auto words = words_of<Value>();
      const auto found = std::find(words.begin(), words.end(), text);
      if (found == words.end()) return fmt::format("one of {}", fmt::join(words, ", "));
      value = static_cast<Value>(found - words.begin());
      return "";
    } else if constexpr (std::is_integral_v<Value>) {
      return read_number(text, value) ? "" : "a whole number";
    } else {
      return read_list(parts_of(text), factor, value);
    }
  }

 private:
  /// Points take three parts each.
  template <typename Element>
  static std::string read_list(const std::vector<std::string_view>& parts, double factor, std::vector<Element>& list) {
    constexpr std::size_t kParts = std::is_same_v<Element, Eigen::Vector3d> ? 3 : 1;
    if (parts.size() % kParts != 0) return "a list of points, three numbers each";
    list.assign(parts.size() / kParts, Element{});
    for (std::size_t i = 0; i < list.size(); ++i) {
      const char* begin = parts[i * kParts].data();
      const char* end = parts[i * kParts + kParts - 1].data() + parts[i * kParts + kParts - 1].size();
      const std::string problem = read({begin, static_cast<std::size_t>(end - begin)}, factor, list[i]);
      if (!problem.empty()) return "a list, each " + problem;
    }
    return "";
  }
};

/// What was typed, sorted out: bare words, and options with their values.
struct Typed {
  std::vector<std::string> bare;
  std::map<std::string, std::string, std::less<>> options;
};

Result<Typed> sorted_out(const std::vector<std::string>& words) {
  Typed result;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (!word.starts_with("--")) {
      result.bare.push_back(word);
      continue;
    }
    const std::size_t equals = word.find('=');
    std::string key = word.substr(2, equals == std::string::npos ? equals : equals - 2);
    std::string value;
    if (equals != std::string::npos) {
      value = word.substr(equals + 1);
    } else if (i + 1 < words.size() && !words[i + 1].starts_with("--")) {
      value = words[++i];
    } else {
      value = "yes";
    }
    if (!result.options.emplace(key, value).second) return wrong(fmt::format("--{} is given twice", key));
  }
  return result;
}

class FieldFiller {
 public:
  /// `present`: what is not typed, positional words too, is there already.
  explicit FieldFiller(Typed typed_in, bool present = false) : typed_(std::move(typed_in)), present_(present) {}

  template <typename Value>
  void field(const Field& field, Value& value) {
    const TypedField how = typed(field.key);
    std::optional<std::string> text;
    if (const auto found = typed_.options.find(how.option); found != typed_.options.end()) {
      text = found->second;
      typed_.options.erase(found);
    } else if (field.positional && next_bare_ < typed_.bare.size()) {
      text = typed_.bare[next_bare_++];
    }
    if (!text) {
      if (field.positional && !present_ && problem_.empty()) problem_ = fmt::format("it needs a word: {}", field.help);
      return;
    }
    const std::string wanted = WordReader::read(*text, how.factor, value);
    if (!wanted.empty() && problem_.empty()) {
      problem_ = fmt::format("{} must be {}, not {}", field.positional ? how.option : "--" + how.option, wanted, *text);
    }
  }
  Status done(std::string_view edit) const {
    if (!problem_.empty()) return wrong(fmt::format("{}: {}", edit, problem_));
    if (!typed_.options.empty()) {
      return wrong(fmt::format("{} has no option --{}", edit, typed_.options.begin()->first));
    }
    if (next_bare_ < typed_.bare.size()) {
      return wrong(fmt::format("{} does not know what to do with {}", edit, typed_.bare[next_bare_]));
    }
    return {};
  }

 private:
  Typed typed_;
  bool present_ = false;
  std::size_t next_bare_ = 0;
  std::string problem_;
};

}  // namespace

TypedField typed(std::string_view key) {
  for (const Unit& unit : kUnits) {
    if (!key.ends_with(unit.ending)) continue;
    TypedField field{std::string(key.substr(0, key.size() - unit.ending.size())), unit.factor, std::string(unit.shown)};
    field.option += unit.typed;
    std::replace(field.option.begin(), field.option.end(), '_', '-');
    return field;
  }
  TypedField field{std::string(key), 1.0, ""};
  std::replace(field.option.begin(), field.option.end(), '_', '-');
  return field;
}

std::string typed_number(double value) {
  if (!(std::abs(value) < 1e6)) return fmt::format("{:.15g}", value);
  return fmt::format("{}", std::round(value * 1e9) / 1e9);
}

std::vector<std::string> to_words(const Edit& edit) {
  WordWriter writer;
  writer.words.emplace_back(name_of(edit));
  std::visit([&](const auto& one) { visit_fields(writer, one); }, edit);
  return std::move(writer.words);
}

Result<Edit> edit_from_words(const std::vector<std::string>& words) {
  if (words.empty()) return wrong("there is no edit");
  TROCAR_ASSIGN_OR_RETURN(const Typed typed_words, sorted_out(words));
  Result<Edit> edit = wrong(fmt::format("no edit is named {}", words.front()));
  for_each_edit([&]<typename Edited>(const Edited*) {
    if (words.front() != Edited::kName) return;
    Edited made;
    FieldFiller filler(typed_words);
    visit_fields(filler, made);
    const Status filled = filler.done(Edited::kName);
    edit = filled ? Result<Edit>(std::move(made)) : tl::unexpected(filled.error());
  });
  return edit;
}

Result<Edit> edit_from_words(const std::vector<std::string>& words, const Edit& present) {
  if (words.empty()) return wrong("there is no edit");
  if (words.front() != name_of(present)) return wrong(fmt::format("{} is no {}", words.front(), name_of(present)));
  TROCAR_ASSIGN_OR_RETURN(Typed typed_words, sorted_out(words));
  Edit edit = present;
  FieldFiller filler(std::move(typed_words), true);
  std::visit([&](auto& one) { visit_fields(filler, one); }, edit);
  TROCAR_RETURN_IF_ERROR(filler.done(name_of(present)));
  return edit;
}

Edit as_typed(const Edit& edit) {
  return edit_from_words(to_words(edit), edit).value_or(edit);
}

std::vector<EditOption> options_of(const Edit& edit) {
  OptionLister lister;
  std::visit([&](const auto& one) { visit_fields(lister, one); }, edit);
  return std::move(lister.options);
}

Result<Edit> edit_from_options(std::string_view name, const std::vector<EditOption>& options) {
  std::vector<std::string> words{std::string(name)};
  for (const EditOption& option : options) {
    if (option.positional) words.push_back(option.text);
  }
  for (const EditOption& option : options) {
    const bool empty_list = option.text.empty() && option.choices.empty() && !option.positional;
    if (!option.positional && !empty_list) words.push_back(fmt::format("--{}={}", option.option, option.text));
  }
  return edit_from_words(words);
}

std::vector<Edit> default_edits() {
  std::vector<Edit> edits;
  for_each_edit([&]<typename Edited>(const Edited*) { edits.emplace_back(Edited{}); });
  return edits;
}

std::string title_of(std::string_view word) {
  std::string title(word);
  std::replace(title.begin(), title.end(), '-', ' ');
  if (!title.empty()) title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

Result<std::vector<std::string>> split_words(std::string_view line) {
  std::vector<std::string> words;
  bool quoted = false;
  bool open = false;
  for (const char c : line) {
    if (c == '\'') {
      quoted = !quoted;
      if (!open) words.emplace_back();
      open = true;
    } else if (c == ' ' && !quoted) {
      open = false;
    } else {
      if (!open) words.emplace_back();
      open = true;
      words.back() += c;
    }
  }
  if (quoted) return wrong("a quote is not closed");
  return words;
}

}  // namespace trocar::demonstration
