#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Core>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "engine/demonstration/edit_fields.h"

namespace trocar::demonstration {
namespace {

using nlohmann::json;

tl::unexpected<Error> corrupt(std::string message) {
  return fail(ErrorCode::kCorrupt, std::move(message));
}

class Writer {
 public:
  template <typename Value>
  void field(const Field& field, const Value& value) {
    object_[field.key] = written(value);
  }
  std::string text() const { return object_.dump(-1, ' ', false, json::error_handler_t::replace); }

 private:
  template <typename Value>
  static json written(const Value& value) {
    if constexpr (std::is_enum_v<Value>) {
      return std::string(words_of<Value>()[static_cast<std::size_t>(value)]);
    } else if constexpr (std::is_same_v<Value, Eigen::Vector3d>) {
      return {value.x(), value.y(), value.z()};
    } else if constexpr (std::is_same_v<Value, Eigen::Vector2d>) {
      return {value.x(), value.y()};
    } else {
      return value;
    }
  }
  template <typename Element>
  static json written(const std::vector<Element>& list) {
    json array = json::array();
    for (const Element& element : list) array.push_back(written(element));
    return array;
  }

  json object_ = json::object();
};

/// Reads one value; each returns false if the JSON is of another type.
struct ValueReader {
  static bool read(const json& from, double& value) { return from.is_number() && (value = from.get<double>(), true); }
  static bool read(const json& from, int& value) {
    if (!from.is_number_integer() || std::abs(from.get<double>()) > 2e9) return false;
    value = from.get<int>();
    return true;
  }
  static bool read(const json& from, std::int64_t& value) {
    return from.is_number_integer() && (value = from.get<std::int64_t>(), true);
  }
  static bool read(const json& from, std::uint64_t& value) {
    return from.is_number_unsigned() && (value = from.get<std::uint64_t>(), true);
  }
  static bool read(const json& from, bool& value) { return from.is_boolean() && (value = from.get<bool>(), true); }
  static bool read(const json& from, std::string& value) {
    return from.is_string() && (value = from.get<std::string>(), true);
  }
  static bool read(const json& from, Eigen::Vector3d& value) {
    return from.is_array() && from.size() == 3 && read(from[0], value.x()) && read(from[1], value.y()) &&
           read(from[2], value.z());
  }
  static bool read(const json& from, Eigen::Vector2d& value) {
    return from.is_array() && from.size() == 2 && read(from[0], value.x()) && read(from[1], value.y());
  }
  template <typename Enum>
  requires std::is_enum_v<Enum>
  static bool read(const json& from, Enum& value) {
    if (!from.is_string()) return false;
    const auto words = words_of<Enum>();
    const auto found = std::find(words.begin(), words.end(), from.get<std::string>());
    if (found == words.end()) return false;
    value = static_cast<Enum>(found - words.begin());
    return true;
  }
  template <typename Element>
  static bool read(const json& from, std::vector<Element>& list) {
    if (!from.is_array()) return false;
    list.assign(from.size(), Element());
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (!read(from[i], list[i])) return false;
    }
    return true;
  }
};

/// What a value of a type has to be, for a message.
struct KindName {
  static std::string of(double) { return "a number"; }
  static std::string of(int) { return "a whole number"; }
  static std::string of(std::int64_t) { return "a whole number"; }
  static std::string of(std::uint64_t) { return "a whole number from 0"; }
  static std::string of(bool) { return "true or false"; }
  static std::string of(const std::string&) { return "text"; }
  static std::string of(const Eigen::Vector3d&) { return "three numbers"; }
  static std::string of(const Eigen::Vector2d&) { return "two numbers"; }
  template <typename Enum>
  requires std::is_enum_v<Enum>
  static std::string of(Enum) { return fmt::format("one of {}", fmt::join(words_of<Enum>(), ", ")); }
  template <typename Element>
  static std::string of(const std::vector<Element>&) {
    return "a list, each " + of(Element{});
  }
};

class Reader {
 public:
  explicit Reader(const json& object) : object_(object) {}

  template <typename Value>
  void field(const Field& field, Value& value) {
    const auto found = object_.find(field.key);
    if (found == object_.end() && field.younger) return;
    ++count_;
    if (found != object_.end() && ValueReader::read(*found, value)) return;
    if (problem_.empty())
      problem_ = fmt::format("the parameter {} must be there and be {}", field.key, KindName::of(value));
  }
  Status done() const {
    if (!problem_.empty()) return corrupt(problem_);
    if (object_.size() != count_) return corrupt("the edit has a parameter that is not known");
    return {};
  }

 private:
  const json& object_;
  std::size_t count_ = 0;
  std::string problem_;
};

template <typename Edited>
Result<Edit> read(const json& object) {
  auto edit = without_younger<Edited>();
  Reader reader(object);
  visit_fields(reader, edit);
  TROCAR_RETURN_IF_ERROR(reader.done());
  return edit;
}

}  // namespace

std::string_view name_of(const Edit& edit) {
  return std::visit([](const auto& one) { return one.kName; }, edit);
}

bool stacks(const Edit& edit) {
  return !std::holds_alternative<Rename>(edit);
}

std::string to_json(const Edit& edit) {
  Writer writer;
  std::visit([&](const auto& one) { visit_fields(writer, one); }, edit);
  return writer.text();
}

Result<Edit> edit_from_json(std::string_view name, std::string_view text) {
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) return corrupt("the parameters of an edit must be a JSON object");
  Result<Edit> edit = corrupt(fmt::format("no edit is named {}", name));
  for_each_edit([&]<typename Edited>(const Edited*) {
    if (name == Edited::kName) edit = read<Edited>(object);
  });
  return edit;
}

}  // namespace trocar::demonstration
