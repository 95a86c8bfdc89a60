/// Finds and rasterises the window's fonts: Inter, DejaVu where it is missing, icons merged into each.
#pragma once

#include <imgui.h>

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/result.h"

namespace trocar::ui {

/// Sizes are at 100 %; all hold Latin, Greek, arrows, mathematical signs and the icons.
struct Fonts {
  ImFont* body = nullptr;    ///< 15 px, what is read.
  ImFont* small = nullptr;   ///< 13 px, badges and hints.
  ImFont* strong = nullptr;  ///< 15 px semi-bold, headings and numbers that matter.
  ImFont* large = nullptr;   ///< 22 px semi-bold, empty states.
  ImFont* mono = nullptr;    ///< 13 px fixed width, time codes, commands, the log.
  float scale = 1.0F;
};

/// A face in a file, and whether it is the one asked for or the stand-in.
struct FontFile {
  std::filesystem::path path;
  bool stand_in = false;
};

/// The first of `candidates` that exists below one of `folders`.
/// Errors: kNotFound naming the package to install.
Result<FontFile> find_font(const std::vector<std::string>& candidates,
                           const std::vector<std::filesystem::path>& folders);

/// Where Debian puts fonts, and ~/.local/share/fonts.
std::vector<std::filesystem::path> font_folders();

/// Empties the atlas and fills it for `scale` (0.75 … 3). Errors: kNotFound when not even DejaVu is installed.
Result<Fonts> build_fonts(ImFontAtlas& atlas, float scale);

}  // namespace trocar::ui
