#include "engine/exchange/map_presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "engine/core/file.h"

namespace trocar::exchange {
namespace {

constexpr std::string_view kEnding = ".json";
constexpr std::size_t kLongestName = 80;
constexpr std::size_t kLargestMap = std::size_t{1} << 20;

std::filesystem::path file_of(const std::filesystem::path& folder, std::string_view name) {
  return folder / (std::string(name) + std::string(kEnding));
}

}  // namespace

std::filesystem::path map_preset_folder() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && *config != '\0') return std::filesystem::path(config) / "trocar/maps";
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home == nullptr ? "." : home) / ".config/trocar/maps";
}

std::vector<std::string> map_presets(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  std::filesystem::directory_iterator file(folder, error);
  for (; !error && file != std::filesystem::directory_iterator(); file.increment(error)) {
    const std::filesystem::path& path = file->path();
    if (path.extension() == kEnding && reason_against_preset(path.stem().string()).empty()) {
      names.push_back(path.stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string reason_against_preset(std::string_view name) {
  if (name.empty()) return "Type a name for the map";
  if (name.size() > kLongestName) return fmt::format("A name has at most {} letters", kLongestName);
  const bool plain = std::none_of(name.begin(), name.end(), [](unsigned char c) {
    return c < 0x20 || std::string_view("/\\:*?\"<>|").find(static_cast<char>(c)) != std::string_view::npos;
  });
  return plain && name.front() != '.' ? "" : "A name has no dot in front and none of / \\ : * ? \" < > |";
}

Status save_map_preset(const std::filesystem::path& folder, std::string_view name, const ColumnMap& map) {
  if (const std::string why = reason_against_preset(name); !why.empty()) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("a map cannot be kept as \"{}\": {}", name, why));
  }
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return tl::unexpected(
        Error(ErrorCode::kIo, "the folder for maps cannot be made: " + error.message()).at(folder.string()));
  }
  return write_file(file_of(folder, name), to_json(map) + "\n");
}

Result<ColumnMap> load_map_preset(const std::filesystem::path& folder, std::string_view name) {
  const std::filesystem::path path = file_of(folder, name);
  std::error_code error;
  if (!reason_against_preset(name).empty() || !std::filesystem::is_regular_file(path, error)) {
    return fail(ErrorCode::kNotFound, fmt::format("no map of columns is kept as \"{}\"", name));
  }
  TROCAR_ASSIGN_OR_RETURN(const std::string json, read_file(path, kLargestMap));
  Result<ColumnMap> map = column_map_from_json(json);
  if (!map) return tl::unexpected(std::move(map).error().at(path.string()));
  return map;
}

}  // namespace trocar::exchange
