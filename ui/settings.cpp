#include "ui/settings.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <system_error>

#include "engine/core/file.h"
#include "ui/panels/timeline_lanes.h"

namespace trocar::ui {
namespace {

using Json = nlohmann::json;

void read_layouts(const Json& json, Settings& settings) {
  for (std::size_t i = 0; i < kWorkspaceCount; ++i) {
    const std::string name(title(static_cast<Workspace>(i)));
    if (!json.contains(name)) continue;
    if (Result<Tile> layout = tile_from_json(json[name].dump())) settings.layouts[i] = std::move(*layout);
  }
}

std::uint32_t lanes_from(const Json& names) {
  LaneSet hidden;
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    const std::string_view name = name_of(static_cast<Lane>(i));
    hidden[i] = std::any_of(names.begin(), names.end(), [&](const Json& each) { return each == std::string(name); });
  }
  return static_cast<std::uint32_t>(hidden.to_ulong());
}

Json names_of_lanes(std::uint32_t hidden) {
  Json names = Json::array();
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    if (LaneSet(hidden)[i]) names.push_back(std::string(name_of(static_cast<Lane>(i))));
  }
  return names;
}

}  // namespace

std::filesystem::path settings_path() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && *config != '\0') return std::filesystem::path(config) / "trocar/workbench.json";
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home == nullptr ? "." : home) / ".config/trocar/workbench.json";
}

Result<Settings> settings_from_json(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
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
  if (json.contains("layouts") && json["layouts"].is_object()) read_layouts(json["layouts"], settings);
  if (json.contains("window") && json["window"].is_array() && json["window"].size() == 2 &&
      json["window"][0].is_number_integer() && json["window"][1].is_number_integer()) {
    settings.window = {std::clamp(json["window"][0].get<int>(), 320, 8192),
                       std::clamp(json["window"][1].get<int>(), 240, 8192)};
  }
  if (json.contains("hidden_lanes") && json["hidden_lanes"].is_array()) {
    settings.hidden_lanes = lanes_from(json["hidden_lanes"]);
  }
  if (json.contains("recent") && json["recent"].is_array()) {
    for (const Json& path : json["recent"]) {
      if (path.is_string() && settings.recent.size() < 8) settings.recent.push_back(path.get<std::string>());
    }
  }
  return settings;
}

std::string to_json(const Settings& settings) {
  Json layouts = Json::object();
  for (std::size_t i = 0; i < kWorkspaceCount; ++i) {
    layouts[std::string(title(static_cast<Workspace>(i)))] = Json::parse(to_json(settings.layouts[i]));
  }
  const Json json{{"scale", settings.scale},
                  {"theme", std::string(name_of(settings.theme))},
                  {"workspace", static_cast<unsigned>(settings.workspace)},
                  {"layouts", layouts},
                  {"window", {settings.window.width, settings.window.height}},
                  {"hidden_lanes", names_of_lanes(settings.hidden_lanes)},
                  {"recent", settings.recent}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

Settings load_settings(const std::filesystem::path& path) {
  const Result<std::string> text = read_file(path, std::size_t{1} << 20);
  if (!text) return {};
  Result<Settings> settings = settings_from_json(*text);
  return settings ? std::move(*settings) : Settings{};
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
