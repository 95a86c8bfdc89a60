#include "ui/theme.h"

#include <algorithm>
#include <cmath>

namespace trocar::ui {
namespace {

constexpr std::array<std::string_view, 3> kThemeNames{"dark", "light", "high-contrast"};

Theme dark_theme() {
  Theme theme;
  theme.dark = true;
  theme.ground = {16, 18, 21, 255};
  theme.panel = {25, 28, 33, 255};
  theme.header = {20, 22, 26, 255};
  theme.raised = {38, 42, 49, 255};
  theme.hover = {49, 54, 63, 255};
  theme.pressed = {32, 36, 42, 255};
  theme.line = {45, 50, 58, 255};
  theme.text = {226, 230, 236, 255};
  theme.text_dim = {152, 161, 174, 255};
  theme.text_disabled = {100, 108, 120, 255};
  theme.accent = {86, 170, 232, 255};
  theme.accent_fill = {32, 104, 163, 255};
  theme.accent_hover = {39, 117, 180, 255};
  theme.on_accent = {255, 255, 255, 255};
  theme.selection = {31, 55, 77, 255};
  theme.good = {92, 190, 135, 255};
  theme.warning = {229, 169, 60, 255};
  theme.danger = {240, 105, 100, 255};
  theme.danger_fill = {193, 48, 52, 255};
  return theme;
}

Theme light_theme() {
  Theme theme;
  theme.dark = false;
  theme.ground = {214, 217, 222, 255};
  theme.panel = {247, 248, 250, 255};
  theme.header = {233, 235, 239, 255};
  theme.raised = {229, 232, 237, 255};
  theme.hover = {217, 221, 228, 255};
  theme.pressed = {205, 210, 218, 255};
  theme.line = {205, 209, 216, 255};
  theme.text = {28, 32, 38, 255};
  theme.text_dim = {84, 92, 104, 255};
  theme.text_disabled = {140, 147, 158, 255};
  theme.accent = {22, 104, 170, 255};
  theme.accent_fill = {24, 104, 168, 255};
  theme.accent_hover = {20, 92, 150, 255};
  theme.on_accent = {255, 255, 255, 255};
  theme.selection = {205, 225, 242, 255};
  theme.good = {20, 112, 62, 255};
  theme.warning = {138, 84, 0, 255};
  theme.danger = {184, 38, 38, 255};
  theme.danger_fill = {193, 48, 52, 255};
  return theme;
}

Theme high_contrast_theme() {
  Theme theme;
  theme.dark = true;
  theme.outlined = true;
  theme.ground = {70, 70, 70, 255};
  theme.panel = {0, 0, 0, 255};
  theme.header = {0, 0, 0, 255};
  theme.raised = {0, 0, 0, 255};
  theme.hover = {0, 60, 110, 255};
  theme.pressed = {0, 40, 80, 255};
  theme.line = {170, 170, 170, 255};
  theme.text = {255, 255, 255, 255};
  theme.text_dim = {225, 225, 225, 255};
  theme.text_disabled = {150, 150, 150, 255};
  theme.accent = {255, 214, 0, 255};
  theme.accent_fill = {255, 214, 0, 255};
  theme.accent_hover = {255, 231, 110, 255};
  theme.on_accent = {0, 0, 0, 255};
  theme.selection = {0, 62, 120, 255};
  theme.good = {105, 240, 130, 255};
  theme.warning = {255, 196, 64, 255};
  theme.danger = {255, 138, 128, 255};
  theme.danger_fill = {255, 138, 128, 255};
  return theme;
}

}  // namespace

std::string_view name_of(ThemeKind kind) {
  return kThemeNames[static_cast<std::size_t>(kind)];
}

std::optional<ThemeKind> theme_from(std::string_view name) {
  const auto* found = std::find(kThemeNames.begin(), kThemeNames.end(), name);
  if (found == kThemeNames.end()) return std::nullopt;
  return static_cast<ThemeKind>(found - kThemeNames.begin());
}

ThemeKind next(ThemeKind kind) {
  return static_cast<ThemeKind>((static_cast<std::size_t>(kind) + 1) % kThemeKinds.size());
}

Theme make_theme(ThemeKind kind) {
  switch (kind) {
    case ThemeKind::kDark:
      return dark_theme();
    case ThemeKind::kLight:
      return light_theme();
    case ThemeKind::kHighContrast:
      return high_contrast_theme();
  }
  return dark_theme();
}

Rgba authority_colour(demonstration::Authority authority) {
  switch (authority) {
    case demonstration::Authority::kOperator:
      return {120, 160, 215, 255};
    case demonstration::Authority::kAgent:
      return {62, 190, 148, 255};
    case demonstration::Authority::kAssistant:
      return {200, 150, 220, 255};
    case demonstration::Authority::kHold:
      return {150, 150, 150, 255};
  }
  return {128, 128, 128, 255};
}

ImU32 to_u32(Rgba colour) {
  return IM_COL32(colour.r, colour.g, colour.b, colour.a);
}

ImU32 to_u32(Rgba colour, float alpha) {
  const float opacity = std::clamp(static_cast<float>(colour.a) * alpha, 0.0F, 255.0F);
  return IM_COL32(colour.r, colour.g, colour.b, static_cast<int>(std::lround(opacity)));
}

ImVec4 to_vec4(Rgba colour) {
  return {static_cast<float>(colour.r) / 255.0F, static_cast<float>(colour.g) / 255.0F,
          static_cast<float>(colour.b) / 255.0F, static_cast<float>(colour.a) / 255.0F};
}

Rgba mix(Rgba a, Rgba b, float t) {
  const auto channel = [t](std::uint8_t from, std::uint8_t to) {
    const float value = static_cast<float>(from) + (static_cast<float>(to) - static_cast<float>(from)) * t;
    return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b), channel(a.a, b.a)};
}

namespace {

double luminance(Rgba colour) {
  const auto linear = [](std::uint8_t value) {
    const double v = value / 255.0;
    return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.r) + 0.7152 * linear(colour.g) + 0.0722 * linear(colour.b);
}

void set_shapes(float scale, ImGuiStyle& style) {
  style.WindowPadding = {10, 10};
  style.FramePadding = {9, 5};
  style.CellPadding = {8, 5};
  style.ItemSpacing = {8, 7};
  style.ItemInnerSpacing = {6, 5};
  style.IndentSpacing = 16;
  style.ScrollbarSize = 11;
  style.GrabMinSize = 12;
  style.WindowRounding = 6;
  style.ChildRounding = 0;
  style.FrameRounding = 4;
  style.PopupRounding = 6;
  style.ScrollbarRounding = 6;
  style.GrabRounding = 4;
  style.TabRounding = 4;
  style.WindowBorderSize = 1;
  style.PopupBorderSize = 1;
  style.ChildBorderSize = 0;
  style.FrameBorderSize = 0;
  style.WindowTitleAlign = {0.0F, 0.5F};
  style.DisabledAlpha = 1.0F;
  style.ScaleAllSizes(scale);
  style.WindowBorderSize = 1;
  style.PopupBorderSize = 1;
  style.AntiAliasedLinesUseTex = false;
}

}  // namespace

double contrast(Rgba a, Rgba b) {
  const double la = luminance(a);
  const double lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

void apply(const Theme& theme, float scale, ImGuiStyle& style) {
  style = ImGuiStyle();
  set_shapes(scale, style);
  if (theme.outlined) style.FrameBorderSize = 1;
  if (theme.dark) {
    ImGui::StyleColorsDark(&style);
  } else {
    ImGui::StyleColorsLight(&style);
  }
  const auto set = [&style](ImGuiCol slot, Rgba colour) { style.Colors[slot] = to_vec4(colour); };
  const Rgba clear{0, 0, 0, 0};
  set(ImGuiCol_Text, theme.text);
  set(ImGuiCol_TextDisabled, theme.text_disabled);
  set(ImGuiCol_WindowBg, theme.panel);
  set(ImGuiCol_ChildBg, clear);
  set(ImGuiCol_PopupBg, theme.dark ? mix(theme.panel, theme.raised, 0.5F) : theme.panel);
  set(ImGuiCol_Border, theme.line);
  set(ImGuiCol_BorderShadow, clear);
  set(ImGuiCol_FrameBg, theme.raised);
  set(ImGuiCol_FrameBgHovered, theme.hover);
  set(ImGuiCol_FrameBgActive, theme.hover);
  set(ImGuiCol_TitleBg, theme.header);
  set(ImGuiCol_TitleBgActive, theme.header);
  set(ImGuiCol_MenuBarBg, theme.header);
  set(ImGuiCol_ScrollbarBg, clear);
  set(ImGuiCol_ScrollbarGrab, theme.hover);
  set(ImGuiCol_ScrollbarGrabHovered, theme.text_disabled);
  set(ImGuiCol_ScrollbarGrabActive, theme.text_dim);
  set(ImGuiCol_CheckMark, theme.accent);
  set(ImGuiCol_SliderGrab, theme.dark ? theme.accent_fill : mix(theme.accent, theme.raised, 0.6F));
  set(ImGuiCol_SliderGrabActive, theme.dark ? theme.accent_hover : mix(theme.accent, theme.raised, 0.5F));
  set(ImGuiCol_Button, theme.raised);
  set(ImGuiCol_ButtonHovered, theme.hover);
  set(ImGuiCol_ButtonActive, theme.pressed);
  set(ImGuiCol_Header, theme.selection);
  set(ImGuiCol_HeaderHovered, theme.hover);
  set(ImGuiCol_HeaderActive, theme.selection);
  set(ImGuiCol_Separator, theme.line);
  set(ImGuiCol_TableHeaderBg, theme.header);
  set(ImGuiCol_TableBorderStrong, theme.line);
  set(ImGuiCol_TableBorderLight, theme.line);
  set(ImGuiCol_TextSelectedBg, theme.selection);
  set(ImGuiCol_NavHighlight, theme.accent);
}

}  // namespace trocar::ui
