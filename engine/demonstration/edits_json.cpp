#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/demonstration/edits.h"

namespace trocar::demonstration {
namespace {

using nlohmann::json;

tl::unexpected<Error> corrupt(std::string message) {
  return fail(ErrorCode::kCorrupt, std::move(message));
}

/// One list of each edit's fields gives both the reader and the writer.
template <typename Visitor, typename Edited>
void visit_fields(Visitor& visitor, Edited& edit) {
  using Type = std::remove_const_t<Edited>;
  if constexpr (std::is_same_v<Type, Trim>) {
    visitor.field("from_s", edit.from_s);
    visitor.field("to_s", edit.to_s);
  } else if constexpr (std::is_same_v<Type, Rename>) {
    visitor.field("name", edit.name);
  } else {
    static_assert(std::is_same_v<Type, LabelSegment>);
    visitor.field("label", edit.label);
    visitor.field("from_s", edit.from_s);
    visitor.field("to_s", edit.to_s);
  }
}

class Writer {
 public:
  void field(const char* key, const double& value) { object_[key] = value; }
  void field(const char* key, const std::string& value) { object_[key] = value; }
  void field(const char* key, const Segment& value) { object_[key] = std::string(1, letter(value)); }
  std::string text() const { return object_.dump(-1, ' ', false, json::error_handler_t::replace); }

 private:
  json object_ = json::object();
};

class Reader {
 public:
  explicit Reader(const json& object) : object_(object) {}

  void field(const char* key, double& value) {
    if (const json* found = find(key, "a number", &json::is_number)) value = found->get<double>();
  }
  void field(const char* key, std::string& value) {
    if (const json* found = find(key, "text", &json::is_string)) value = found->get<std::string>();
  }
  void field(const char* key, Segment& value) {
    const json* found = find(key, "a letter A to E", &json::is_string);
    if (found == nullptr) return;
    const auto text = found->get<std::string>();
    if (text.size() != 1 || text[0] < 'A' || text[0] > 'E') {
      problem_ = fmt::format("the parameter {} must be a letter A to E", key);
    } else {
      value = static_cast<Segment>(text[0] - 'A');
    }
  }
  Status done() const {
    if (!problem_.empty()) return corrupt(problem_);
    if (object_.size() != count_) return corrupt("the edit has a parameter that is not known");
    return {};
  }

 private:
  const json* find(const char* key, const char* type, bool (json::*is_type)() const noexcept) {
    ++count_;
    const auto found = object_.find(key);
    if (found != object_.end() && ((*found).*is_type)()) return &*found;
    if (problem_.empty()) problem_ = fmt::format("the parameter {} must be there and be {}", key, type);
    return nullptr;
  }

  const json& object_;
  std::size_t count_ = 0;
  std::string problem_;
};

template <typename Edited>
Result<Edit> read(const json& object) {
  Edited edit;
  Reader reader(object);
  visit_fields(reader, edit);
  TROCAR_RETURN_IF_ERROR(reader.done());
  return edit;
}

}  // namespace

std::string to_json(const Edit& edit) {
  Writer writer;
  std::visit([&](const auto& one) { visit_fields(writer, one); }, edit);
  return writer.text();
}

Result<Edit> edit_from_json(std::string_view name, std::string_view text) {
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) return corrupt("the parameters of an edit must be a JSON object");
  if (name == Trim::kName) return read<Trim>(object);
  if (name == Rename::kName) return read<Rename>(object);
  if (name == LabelSegment::kName) return read<LabelSegment>(object);
  return corrupt(fmt::format("no edit is named {}", name));
}

}  // namespace trocar::demonstration
