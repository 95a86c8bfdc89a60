/// Maps of columns that were kept under a name, each a JSON file of one folder: for the next table of that kind.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/exchange/column_map.h"

namespace trocar::exchange {

/// $XDG_CONFIG_HOME/trocar/maps, else ~/.config/trocar/maps.
std::filesystem::path map_preset_folder();

/// In alphabetical order; none where there is no such folder.
std::vector<std::string> map_presets(const std::filesystem::path& folder);

/// "" if `name` can be one; else why not.
std::string reason_against_preset(std::string_view name);

/// Replaces a preset of that name. Errors: kInvalidArgument for what can be no name; kIo.
Status save_map_preset(const std::filesystem::path& folder, std::string_view name, const ColumnMap& map);

/// Errors: kNotFound if there is none of that name; those of `column_map_from_json`.
Result<ColumnMap> load_map_preset(const std::filesystem::path& folder, std::string_view name);

}  // namespace trocar::exchange
