#include "ui/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "engine/core/file.h"
#include "ui/panels/timeline_lanes.h"

namespace trocar::ui {
namespace {

using Json = nlohmann::json;

std::optional<Tile> layout_from(const Json& json, const std::string& workspace, Diagnostics& diagnostics) {
  Result<Tile> layout = tile_from_json(json.dump(-1, ' ', false, Json::error_handler_t::replace));
  if (layout) return std::move(*layout);
  diagnostics.warn(
      fmt::format("in the settings, of the workspace {}, {}; it was left out", workspace, layout.error().text()));
  return {};
}

void read_layouts(const Json& json, Settings& settings, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < kWorkspaceCount; ++i) {
    const std::string name(title(static_cast<Workspace>(i)));
    if (!json.contains(name)) continue;
    if (auto layout = layout_from(json[name], name, diagnostics)) settings.layouts[i] = std::move(*layout);
  }
}

void read_named_layouts(const Json& json, Settings& settings, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < kWorkspaceCount; ++i) {
    const std::string name(title(static_cast<Workspace>(i)));
    if (!json.contains(name) || !json[name].is_object()) continue;
    for (const auto& [label, tree] : json[name].items()) {
      if (auto layout = layout_from(tree, name, diagnostics)) settings.named[i].push_back({label, std::move(*layout)});
    }
  }
}

Json json_of_layouts(const Settings& settings) {
  Json layouts = Json::object();
  for (std::size_t i = 0; i < kWorkspaceCount; ++i) {
    layouts[std::string(title(static_cast<Workspace>(i)))] = Json::parse(to_json(settings.layouts[i]));
  }
  return layouts;
}

Json json_of_named_layouts(const Settings& settings) {
  Json named = Json::object();
  for (std::size_t i = 0; i < kWorkspaceCount; ++i) {
    Json own = Json::object();
    for (const NamedLayout& layout : settings.named[i]) own[layout.name] = Json::parse(to_json(layout.tree));
    if (!own.empty()) named[std::string(title(static_cast<Workspace>(i)))] = std::move(own);
  }
  return named;
}

/// The lanes that a list names; none where it is no list.
std::uint32_t lanes_from(const Json& json, const char* key) {
  LaneSet lanes;
  if (!json.contains(key) || !json[key].is_array()) return 0;
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    const std::string name(name_of(static_cast<Lane>(i)));
    lanes[i] = std::any_of(json[key].begin(), json[key].end(), [&](const Json& each) { return each == name; });
  }
  return static_cast<std::uint32_t>(lanes.to_ulong());
}

Json names_of_lanes(std::uint32_t lanes) {
  Json names = Json::array();
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    if (LaneSet(lanes)[i]) names.push_back(std::string(name_of(static_cast<Lane>(i))));
  }
  return names;
}

RulerUnit ruler_from(const Json& json) {
  for (int i = 0; i < kRulerUnitCount; ++i) {
    const auto unit = static_cast<RulerUnit>(i);
    if (json.contains("ruler") && json["ruler"] == std::string(name_of(unit))) return unit;
  }
  return RulerUnit::kTime;
}

}  // namespace

std::filesystem::path settings_path() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && *config != '\0') return std::filesystem::path(config) / "trocar/workbench.json";
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home == nullptr ? "." : home) / ".config/trocar/workbench.json";
}

Result<Settings> settings_from_json(std::string_view text, Diagnostics& diagnostics) {
  // What lies deeper than any layout can be is left out before anything walks down into it.
  constexpr int kDeepest = 64;
  const Json json = Json::parse(
      text, [](int depth, Json::parse_event_t, Json&) { return depth < kDeepest; }, false);
  if (!json.is_object()) return fail(ErrorCode::kCorrupt, "the settings are not a JSON object");
  Settings settings;
  if (json.contains("scale") && json["scale"].is_number()) {
    const float scale = json["scale"].get<float>();
    settings.scale = scale > 0.0F ? std::clamp(scale, 0.75F, 3.0F) : 0.0F;
  }
  if (json.contains("theme") && json["theme"].is_string()) {
    settings.theme = theme_from(json["theme"].get<std::string>()).value_or(settings.theme);
  }
  if (json.contains("workspace") && json["workspace"].is_number_unsigned()) {
    const auto workspace = json["workspace"].get<std::size_t>();
    if (workspace < kWorkspaceCount) settings.workspace = static_cast<Workspace>(workspace);
  }
  if (json.contains("layouts") && json["layouts"].is_object()) read_layouts(json["layouts"], settings, diagnostics);
  if (json.contains("named_layouts") && json["named_layouts"].is_object()) {
    read_named_layouts(json["named_layouts"], settings, diagnostics);
  }
  if (json.contains("keys")) {
    settings.keys =
        key_choices_from_json(json["keys"].dump(-1, ' ', false, Json::error_handler_t::replace), diagnostics);
  }
  if (json.contains("window") && json["window"].is_array() && json["window"].size() == 2 &&
      json["window"][0].is_number_integer() && json["window"][1].is_number_integer()) {
    settings.window = {std::clamp(json["window"][0].get<int>(), 320, 8192),
                       std::clamp(json["window"][1].get<int>(), 240, 8192)};
  }
  // A lane that an older file does not know is shown or hidden as it is at first.
  settings.hidden_lanes = lanes_from(json, "hidden_lanes") | (kLanesHiddenAtFirst & ~lanes_from(json, "shown_lanes"));
  settings.ruler = ruler_from(json);
  if (json.contains("frame_rate") && json["frame_rate"].is_boolean()) {
    settings.frame_rate = json["frame_rate"].get<bool>();
  }
  if (json.contains("recent") && json["recent"].is_array()) {
    for (const Json& path : json["recent"]) {
      if (path.is_string() && settings.recent.size() < 8) settings.recent.push_back(path.get<std::string>());
    }
  }
  return settings;
}

std::string to_json(const Settings& settings) {
  const Json json{{"scale", settings.scale},
                  {"theme", std::string(name_of(settings.theme))},
                  {"workspace", static_cast<unsigned>(settings.workspace)},
                  {"layouts", json_of_layouts(settings)},
                  {"named_layouts", json_of_named_layouts(settings)},
                  {"keys", Json::parse(to_json(settings.keys))},
                  {"window", {settings.window.width, settings.window.height}},
                  {"hidden_lanes", names_of_lanes(settings.hidden_lanes & ~kLanesHiddenAtFirst)},
                  {"shown_lanes", names_of_lanes(~settings.hidden_lanes & kLanesHiddenAtFirst)},
                  {"ruler", std::string(name_of(settings.ruler))},
                  {"frame_rate", settings.frame_rate},
                  {"recent", settings.recent}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

Settings load_settings(const std::filesystem::path& path, Diagnostics& diagnostics) {
  const Result<std::string> text = read_file(path, std::size_t{1} << 20);
  if (!text) return {};
  Result<Settings> settings = settings_from_json(*text, diagnostics);
  if (settings) return std::move(*settings);
  // It will be written anew when the window closes; what a person wrote by hand is not lost for a comma.
  std::filesystem::path kept = path;
  kept += ".broken";
  std::error_code error;
  std::filesystem::copy_file(path, kept, std::filesystem::copy_options::overwrite_existing, error);
  diagnostics.warn(fmt::format("{}; those of the program hold{}", settings.error().text(),
                               error ? "" : fmt::format(", and the old ones were kept in {}", kept.string())));
  return {};
}

Status save_settings(const Settings& settings, const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  return write_file(path, to_json(settings));
}

void add_recent(Settings& settings, const std::filesystem::path& project) {
  std::error_code error;
  const std::string name = std::filesystem::absolute(project, error).string();
  std::erase(settings.recent, name);
  settings.recent.insert(settings.recent.begin(), name);
  if (settings.recent.size() > 8) settings.recent.resize(8);
}

}  // namespace trocar::ui
