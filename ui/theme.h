/// Colours, spacing and shapes of the window: a dark, a light and a high-contrast theme, one accent each.
#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/core/image.h"
#include "engine/demonstration/recording.h"
#include "engine/demonstration/segment_colour.h"

namespace trocar::ui {

/// Every colour that a panel may use. Text on its ground has a contrast of at least 4.5:1 (a unit test measures it).
struct Theme {
  bool dark = true;
  bool outlined = false;  ///< Every control has a border that can be seen.
  Rgba ground;            ///< Between the tiles.
  Rgba panel;             ///< Of a tile.
  Rgba header;            ///< Strip of tabs, table heads, menu bar.
  Rgba raised;            ///< Fields and quiet buttons.
  Rgba hover;             ///< Raised under the pointer.
  Rgba pressed;           ///< Raised while pressed.
  Rgba line;              ///< Thin borders and dividers.
  Rgba text;              ///< What is read.
  Rgba text_dim;          ///< What explains.
  Rgba text_disabled;     ///< What cannot be used now.
  Rgba accent;            ///< Selection, playhead, focus.
  Rgba accent_fill;       ///< Ground of the one main button; carries `on_accent`.
  Rgba accent_hover;
  Rgba on_accent;
  Rgba selection;  ///< Ground of the selected row.
  Rgba good;
  Rgba warning;
  Rgba danger;
  Rgba danger_fill;  ///< Ground of the recording banner; carries `on_accent`.
};

enum class ThemeKind : std::uint8_t { kDark, kLight, kHighContrast };
constexpr std::array<ThemeKind, 3> kThemeKinds{ThemeKind::kDark, ThemeKind::kLight, ThemeKind::kHighContrast};
/// "dark", "light", "high-contrast".
std::string_view name_of(ThemeKind kind);
std::optional<ThemeKind> theme_from(std::string_view name);
/// The one after it, round and round.
ThemeKind next(ThemeKind kind);
Theme make_theme(ThemeKind kind);
/// How much of its colour the ground of a badge has.
constexpr float kBadgeTint = 0.1F;

using demonstration::segment_colour;
Rgba authority_colour(demonstration::Authority authority);

ImU32 to_u32(Rgba colour);
/// With its opacity multiplied by `alpha` (0 … 1).
ImU32 to_u32(Rgba colour, float alpha);
ImVec4 to_vec4(Rgba colour);
/// From `a` (0) to `b` (1), opacity included.
Rgba mix(Rgba a, Rgba b, float t);
/// Of WCAG 2.1: 1 … 21.
double contrast(Rgba a, Rgba b);

/// Fills ImGui's style for a theme at `scale` (1 is 100 %).
void apply(const Theme& theme, float scale, ImGuiStyle& style);

}  // namespace trocar::ui
