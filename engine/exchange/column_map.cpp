#include "engine/exchange/column_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/spatial/units.h"

namespace trocar::exchange {
namespace {

using Json = nlohmann::ordered_json;
using Choices = std::vector<std::string_view>;

constexpr double kFarthest = 1e6;
constexpr int kMostColumns = 100'000;
const Choices kLengths{"m", "cm", "mm"};
const Choices kAngles{"rad", "deg"};

/// Takes the values of one object; the first thing that is wrong is kept in `fault`.
class MapFields {
 public:
  MapFields(const Json& object, std::string path, std::string& fault)
      : object_(object), path_(std::move(path)), fault_(fault) {
    if (!object.is_object()) complain("", "must be an object");
  }

  void text(const char* key, std::string& into, const Choices& allowed) {
    const Json* value = find(key);
    if (value == nullptr) return;
    const bool good = value->is_string() &&
                      std::find(allowed.begin(), allowed.end(), value->get_ref<const std::string&>()) != allowed.end();
    if (!good) return complain(key, fmt::format("must be one of {}", fmt::join(allowed, " ")));
    into = value->get<std::string>();
  }
  void short_text(const char* key, std::string& into) {
    const Json* value = find(key);
    if (value == nullptr) return;
    if (!value->is_string() || value->get_ref<const std::string&>().size() > 8)
      return complain(key, "must be a short text");
    into = value->get<std::string>();
  }
  void number(const char* key, double& into, double low, double high) {
    const Json* value = find(key);
    if (value == nullptr) return;
    const double given = value->is_number() ? value->get<double>() : std::nan("");
    if (!(given >= low && given <= high))
      return complain(key, fmt::format("must be a number from {:g} to {:g}", low, high));
    into = given;
  }
  template <std::size_t size>
  void numbers(const char* key, std::array<double, size>& into) {
    const Json* value = find(key);
    if (value == nullptr) return;
    const bool good =
        value->is_array() && value->size() == size && std::all_of(value->begin(), value->end(), [](const Json& one) {
          return one.is_number() && std::abs(one.get<double>()) <= kFarthest;
        });
    if (!good) return complain(key, fmt::format("must be {} numbers", size));
    for (std::size_t i = 0; i < size; ++i) into[i] = (*value)[i].template get<double>();
  }
  void column(const char* key, ColumnName& into) {
    if (const Json* value = find(key); value != nullptr && !take_column(*value, into)) complain(key, kColumn);
  }
  void columns(const char* key, std::vector<ColumnName>& into) {
    const Json* value = find(key);
    if (value == nullptr) return;
    if (!value->is_array() || value->size() > 16) return complain(key, "must be a list of columns");
    for (const Json& one : *value) {
      if (!take_column(one, into.emplace_back())) return complain(key, kColumn);
    }
  }
  const Json* object(const char* key) { return find(key); }

  /// After all keys were asked for.
  void refuse_others() {
    if (!object_.is_object()) return;
    for (const auto& [key, value] : object_.items()) {
      if (std::find(asked_.begin(), asked_.end(), key) == asked_.end())
        complain(key.substr(0, 40), "is not known here");
    }
  }
  void complain(std::string_view key, std::string_view what) {
    if (!fault_.empty()) return;
    const std::string_view dot = path_.empty() || key.empty() ? "" : ".";
    const std::string name = fmt::format("{}{}{}", path_, dot, key);
    fault_ = name.empty() ? fmt::format("the map {}", what) : fmt::format("the map's \"{}\" {}", name, what);
  }
  const std::string& path() const { return path_; }
  std::string& fault() { return fault_; }

 private:
  static constexpr std::string_view kColumn = "must name columns, or give their numbers from 1";

  const Json* find(const char* key) {
    asked_.emplace_back(key);
    if (!object_.is_object()) return nullptr;
    const auto found = object_.find(key);
    return found == object_.end() ? nullptr : &*found;
  }
  static bool take_column(const Json& value, ColumnName& into) {
    if (value.is_number_integer()) {
      const auto place = value.get<std::int64_t>();
      if (place < 1 || place > kMostColumns) return false;
      into = fmt::format("#{}", place);
      return true;
    }
    if (!value.is_string() || value.get_ref<const std::string&>().empty()) return false;
    into = value.get<std::string>();
    return into.size() <= 200;
  }

  const Json& object_;
  std::string path_;
  std::string& fault_;
  std::vector<std::string> asked_;
};

void expect(MapFields& fields, std::size_t given, std::size_t wanted) {
  if (given != wanted) fields.complain("columns", fmt::format("must be {} columns, not {}", wanted, given));
}

bool is_order(std::string_view order) {
  if (order.size() != 3 || order[0] == order[1] || order[1] == order[2]) return false;
  return order.find_first_not_of("xyz") == std::string_view::npos ||
         order.find_first_not_of("XYZ") == std::string_view::npos;
}

void take_position(MapFields fields, PositionColumns& into) {
  fields.columns("columns", into.columns);
  fields.text("unit", into.unit, kLengths);
  fields.refuse_others();
  expect(fields, into.columns.size(), 3);
}

void take_rotation(MapFields fields, RotationColumns& into) {
  fields.columns("columns", into.columns);
  fields.text("kind", into.kind, {"quaternion_xyzw", "quaternion_wxyz", "matrix_rows", "matrix_columns", "euler"});
  fields.short_text("order", into.order);
  fields.text("unit", into.unit, kAngles);
  fields.refuse_others();
  if (!is_order(into.order)) fields.complain("order", "must be three axes such as xyz or ZYX");
  expect(fields, into.columns.size(), into.kind == "euler" ? 3 : into.kind.starts_with("quaternion") ? 4 : 9);
}

void take_jaw(MapFields fields, JawColumn& into) {
  fields.column("column", into.column);
  fields.text("unit", into.unit, {"rad", "deg", "ratio"});
  fields.number("closed", into.closed, -kFarthest, kFarthest);
  fields.number("open", into.open, -kFarthest, kFarthest);
  fields.number("open_deg", into.open_deg, 0.0, 180.0);
  fields.refuse_others();
  if (into.column.empty()) fields.complain("column", "is missing");
  if (std::abs(into.open - into.closed) < 1e-9) fields.complain("open", "must differ from closed");
}

void take_joints(MapFields fields, JointColumns& into) {
  fields.columns("columns", into.columns);
  fields.text("unit", into.unit, kAngles);
  fields.text("insertion_unit", into.insertion_unit, kLengths);
  fields.refuse_others();
  expect(fields, into.columns.size(), 6);
}

void take_arm(MapFields fields, ArmColumns& into) {
  const auto inside = [&fields](const char* key, const Json& value) {
    return MapFields(value, fmt::format("{}.{}", fields.path(), key), fields.fault());
  };
  if (const Json* value = fields.object("position")) take_position(inside("position", *value), into.position.emplace());
  if (const Json* value = fields.object("rotation")) take_rotation(inside("rotation", *value), into.rotation.emplace());
  if (const Json* value = fields.object("jaw")) take_jaw(inside("jaw", *value), into.jaw.emplace());
  if (const Json* value = fields.object("joints")) take_joints(inside("joints", *value), into.joints.emplace());
  fields.refuse_others();
  if (into.joints && (into.position || into.rotation))
    fields.complain("joints", "stand in place of position and rotation");
  if (into.empty()) fields.complain("position", "is missing, and joints are too");
}

void take_time(MapFields fields, TimeColumn& into) {
  fields.column("column", into.column);
  fields.text("unit", into.unit, {"s", "ms", "us", "ns"});
  fields.number("rate_hz", into.rate_hz, 0.1, 1000.0);
  fields.refuse_others();
  if (into.column.empty() == (into.rate_hz == 0.0)) fields.complain("", "must have either a column or a rate_hz");
}

void take_frame(MapFields fields, FrameMap& into) {
  fields.text("mirror", into.mirror, {"none", "x", "y", "z"});
  fields.number("scale", into.scale, 1e-6, 1e6);
  fields.numbers("rotation_wxyz", into.rotation_wxyz);
  fields.numbers("translation_m", into.translation_m);
  fields.refuse_others();
  double squares = 0.0;
  for (const double part : into.rotation_wxyz) squares += part * part;
  if (std::abs(squares - 1.0) > 0.1) fields.complain("rotation_wxyz", "must be a unit quaternion");
}

Json column_json(const ColumnName& name) {
  int place = 0;
  const auto parsed =
      std::from_chars(name.data() + std::min<std::size_t>(1, name.size()), name.data() + name.size(), place);
  const bool whole = parsed.ec == std::errc() && parsed.ptr == name.data() + name.size();
  return name.starts_with('#') && whole && place >= 1 && place <= kMostColumns ? Json(place) : Json(name);
}

Json columns_json(const std::vector<ColumnName>& names) {
  Json list = Json::array();
  for (const ColumnName& name : names) list.push_back(column_json(name));
  return list;
}

Json arm_json(const ArmColumns& arm) {
  Json json = Json::object();
  if (arm.position) json["position"] = {{"columns", columns_json(arm.position->columns)}, {"unit", arm.position->unit}};
  if (arm.rotation) {
    json["rotation"] = {{"columns", columns_json(arm.rotation->columns)}, {"kind", arm.rotation->kind}};
    if (arm.rotation->kind == "euler") {
      json["rotation"]["order"] = arm.rotation->order;
      json["rotation"]["unit"] = arm.rotation->unit;
    }
  }
  if (arm.joints) {
    json["joints"] = {{"columns", columns_json(arm.joints->columns)},
                      {"unit", arm.joints->unit},
                      {"insertion_unit", arm.joints->insertion_unit}};
  }
  if (arm.jaw) {
    json["jaw"] = {{"column", column_json(arm.jaw->column)}, {"unit", arm.jaw->unit}};
    if (arm.jaw->unit == "ratio") {
      json["jaw"].update({{"closed", arm.jaw->closed}, {"open", arm.jaw->open}, {"open_deg", arm.jaw->open_deg}});
    }
  }
  return json;
}

}  // namespace

double unit_factor(std::string_view unit) {
  if (unit == "cm") return 1e-2;
  if (unit == "mm" || unit == "ms") return 1e-3;
  if (unit == "us") return 1e-6;
  if (unit == "ns") return 1e-9;
  return unit == "deg" ? spatial::kRadiansPerDegree : 1.0;
}

std::string to_json(const ColumnMap& map) {
  Json json{{"delimiter", map.delimiter},
            {"decimal", map.decimal},
            {"comment", map.comment},
            {"header_lines", map.header_lines}};
  if (map.time.column.empty()) {
    json["time"] = {{"rate_hz", map.time.rate_hz}};
  } else {
    json["time"] = {{"column", column_json(map.time.column)}, {"unit", map.time.unit}};
  }
  if (!map.arms[0].empty()) json["left"] = arm_json(map.arms[0]);
  if (!map.arms[1].empty()) json["right"] = arm_json(map.arms[1]);
  json["frame"] = {{"mirror", map.frame.mirror},
                   {"scale", map.frame.scale},
                   {"rotation_wxyz", map.frame.rotation_wxyz},
                   {"translation_m", map.frame.translation_m}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

Result<ColumnMap> column_map_from_json(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return fail(ErrorCode::kInvalidArgument, "the map is not JSON");
  ColumnMap map;
  std::string fault;
  MapFields fields(json, "", fault);
  fields.text("delimiter", map.delimiter, {",", ";", "|", "tab", "space"});
  fields.text("decimal", map.decimal, {".", ","});
  fields.short_text("comment", map.comment);
  double lines = map.header_lines;
  fields.number("header_lines", lines, 0, 100);
  map.header_lines = static_cast<int>(lines);
  const auto inside = [&](const char* key, const Json& value) { return MapFields(value, key, fault); };
  const Json* time = fields.object("time");
  if (time != nullptr) take_time(inside("time", *time), map.time);
  if (const Json* left = fields.object("left")) take_arm(inside("left", *left), map.arms[0]);
  if (const Json* right = fields.object("right")) take_arm(inside("right", *right), map.arms[1]);
  if (const Json* frame = fields.object("frame")) take_frame(inside("frame", *frame), map.frame);
  fields.refuse_others();
  if (time == nullptr) fields.complain("time", "is missing");
  if (map.arms[0].empty() && map.arms[1].empty()) fields.complain("left", "and \"right\" are both missing");
  if (map.decimal == map.delimiter) fields.complain("decimal", "cannot be the delimiter too");
  if (fault.empty()) return map;
  return fail(ErrorCode::kInvalidArgument, fault);
}

}  // namespace trocar::exchange
