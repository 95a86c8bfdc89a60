/// What the window remembers between runs; nothing of it belongs to a project.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "ui/keymap.h"
#include "ui/layouts.h"
#include "ui/panels/time_range.h"
#include "ui/theme.h"
#include "ui/tile_tree.h"
#include "ui/window/window.h"

namespace trocar::ui {

struct Settings {
  float scale = 0.0F;  ///< 0.75 … 3; 0: as the screen asks.
  ThemeKind theme = ThemeKind::kDark;
  Workspace workspace = Workspace::kAuthor;
  std::array<Tile, kWorkspaceCount> layouts{default_layout(Workspace::kLibrary), default_layout(Workspace::kAuthor),
                                            default_layout(Workspace::kFields),  default_layout(Workspace::kRollouts),
                                            default_layout(Workspace::kTrials),  default_layout(Workspace::kExport)};
  std::array<std::vector<NamedLayout>, kWorkspaceCount> named;
  KeyChoices keys;
  WindowSize window;
  /// Of the timeline, a bit for each `Lane`; by name in the file.
  std::uint32_t hidden_lanes = kLanesHiddenAtFirst;
  RulerUnit ruler = RulerUnit::kTime;
  bool frame_rate = false;          ///< Said in the menu bar.
  std::vector<std::string> recent;  ///< Projects, newest first, at most 8.

  Tile& layout() { return layouts[static_cast<std::size_t>(workspace)]; }
  const std::vector<NamedLayout>& named_layouts() const { return named[static_cast<std::size_t>(workspace)]; }
};

/// $XDG_CONFIG_HOME/trocar/workbench.json, else ~/.config/…
std::filesystem::path settings_path();
/// Anything missing or odd keeps its default; odd keys and layouts are named in a warning each.
/// Errors: kCorrupt if the text is not a JSON object.
Result<Settings> settings_from_json(std::string_view text, Diagnostics& diagnostics);
std::string to_json(const Settings& settings);
/// The defaults where there is no file or it is broken; a broken one is kept beside as "….broken", with a warning.
Settings load_settings(const std::filesystem::path& path, Diagnostics& diagnostics);
Status save_settings(const Settings& settings, const std::filesystem::path& path);
void add_recent(Settings& settings, const std::filesystem::path& project);

}  // namespace trocar::ui
