#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/widgets/widgets.h"

namespace trocar::ui {
namespace {

struct ButtonColours {
  Rgba ground;
  Rgba hover;
  Rgba pressed;
  Rgba words;
};

ButtonColours colours_of(const Ui& ui, ButtonStyle style, bool enabled) {
  const Theme& theme = ui.theme();
  const Rgba clear{theme.raised.r, theme.raised.g, theme.raised.b, 0};
  ButtonColours colours{theme.raised, theme.hover, theme.pressed, theme.text};
  if (style == ButtonStyle::kQuiet) colours.ground = clear;
  if (style == ButtonStyle::kPrimary) {
    colours = {theme.accent_fill, theme.accent_hover, theme.accent_fill, theme.on_accent};
  }
  if (style == ButtonStyle::kDanger) {
    colours = {theme.danger_fill, mix(theme.danger_fill, theme.on_accent, 0.1F), theme.danger_fill, theme.on_accent};
  }
  if (!enabled) {
    const Rgba ground = style == ButtonStyle::kQuiet ? clear : mix(theme.panel, theme.raised, 0.6F);
    colours = {ground, ground, ground, theme.text_disabled};
  }
  return colours;
}

// `words` is what is drawn; the id comes from the label, so that a changing icon keeps it.
bool draw_button(Ui& ui, std::string_view label, const std::string& words, const WidgetOptions& options) {
  const bool enabled = options.reason.empty();
  const ButtonColours colours = colours_of(ui, options.style, enabled);
  const ColourScope ground(ImGuiCol_Button, colours.ground);
  const ColourScope hover(ImGuiCol_ButtonHovered, colours.hover);
  const ColourScope pressed(ImGuiCol_ButtonActive, colours.pressed);
  const ColourScope text_colour(ImGuiCol_Text, colours.words);
  if (!enabled) ImGui::BeginDisabled();
  const std::string id = words + "###" + std::string(label);
  const bool clicked = ImGui::Button(id.c_str(), {options.width, 0.0F});
  if (!enabled) ImGui::EndDisabled();
  return clicked;
}

std::string words_of(std::string_view label, const WidgetOptions& options) {
  if (options.icon != nullptr && options.icon_only) return options.icon;
  std::string words = options.icon == nullptr ? std::string() : std::string(options.icon) + "  ";
  words += label;
  if (options.says_keys && !options.shortcut.empty()) words += "   " + std::string(options.shortcut);
  return words;
}

void note_fit(Ui& ui, const std::string& words, float padding) {
  ui.items().note_text(ImGui::CalcTextSize(words.c_str()).x, padding);
}

// The square of a check box with its tick.
void draw_box(const Ui& ui, ImVec2 at, float box, bool on, bool enabled) {
  const Theme& theme = ui.theme();
  const bool lit = on && enabled;
  const bool hovered = enabled && ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end{at.x + box, at.y + box};
  list.AddRectFilled(at, end, to_u32(lit ? theme.accent_fill : hovered ? theme.hover : theme.raised), ui.px(3));
  list.AddRect(at, end, to_u32(lit ? theme.accent : theme.text_disabled), ui.px(3));
  if (!on) return;
  const std::array<ImVec2, 3> tick{{{at.x + 0.24F * box, at.y + 0.52F * box},
                                    {at.x + 0.43F * box, at.y + 0.70F * box},
                                    {at.x + 0.77F * box, at.y + 0.32F * box}}};
  list.AddPolyline(tick.data(), 3, to_u32(enabled ? theme.on_accent : theme.text_disabled), 0, ui.px(2));
}

bool segment_button(Ui& ui, const std::string& name, bool on, float width, const WidgetOptions& options) {
  const ColourScope ground(ImGuiCol_Button, on ? ui.theme().accent_fill : ui.theme().raised);
  const ColourScope hover(ImGuiCol_ButtonHovered, on ? ui.theme().accent_hover : ui.theme().hover);
  const ColourScope words(ImGuiCol_Text, on ? ui.theme().on_accent : ui.theme().text);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(2), ImGui::GetStyle().FramePadding.y});
  const bool clicked = ImGui::Button(name.c_str(), {width, 0.0F});
  ImGui::PopStyleVar();
  note_item(ui, "toggle", name, on ? "on" : "off", options);
  note_fit(ui, name, ui.px(2));
  return clicked;
}

}  // namespace

bool button(Ui& ui, std::string_view label, const WidgetOptions& options) {
  const std::string words = words_of(label, options);
  const bool clicked = draw_button(ui, label, words, options);
  note_item(ui, "button", label, "", options);
  note_fit(ui, words, 2.0F * ui.px(4));
  return clicked;
}

bool icon_button(Ui& ui, std::string_view label, const WidgetOptions& options) {
  WidgetOptions square = options;
  if (square.width == 0.0F) square.width = ImGui::GetFrameHeight() + ui.px(4);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0F, ImGui::GetStyle().FramePadding.y});
  const bool clicked = draw_button(ui, label, square.icon, square);
  ImGui::PopStyleVar();
  if (square.help.empty()) square.help = label;
  note_item(ui, "button", label, "", square);
  return clicked;
}

bool toggle(Ui& ui, std::string_view label, bool on, const WidgetOptions& options) {
  return toggle_shown_as(ui, label, words_of(label, options), on, options);
}

bool toggle_shown_as(Ui& ui, std::string_view label, const std::string& words, bool on, const WidgetOptions& options) {
  const Theme& theme = ui.theme();
  const bool enabled = options.reason.empty();
  const Rgba ground = on ? theme.selection : Rgba{theme.raised.r, theme.raised.g, theme.raised.b, 0};
  const ColourScope a(ImGuiCol_Button, ground);
  const ColourScope b(ImGuiCol_ButtonHovered, on ? theme.selection : theme.hover);
  const ColourScope c(ImGuiCol_ButtonActive, theme.selection);
  const ColourScope d(ImGuiCol_Text, !enabled ? theme.text_disabled : on ? theme.text : theme.text_dim);
  if (!enabled) ImGui::BeginDisabled();
  const bool clicked = ImGui::Button((words + "###" + std::string(label)).c_str(), {options.width, 0.0F});
  if (!enabled) ImGui::EndDisabled();
  note_item(ui, "toggle", label, on ? "on" : "off", options);
  note_fit(ui, words, 2.0F * ui.px(4));
  return clicked;
}

bool checkbox(Ui& ui, std::string_view label, bool& on, const WidgetOptions& options) {
  const bool enabled = options.reason.empty();
  const std::string words(label);
  const float box = ui.px(16);
  const float height = ImGui::GetFrameHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = box + ui.px(8) + ImGui::CalcTextSize(words.c_str()).x;
  if (!enabled) ImGui::BeginDisabled();
  const bool clicked = ImGui::InvisibleButton(words.c_str(), {width, height});
  if (!enabled) ImGui::EndDisabled();
  if (clicked) on = !on;
  draw_box(ui, {at.x, std::round(at.y + 0.5F * (height - box))}, box, on, enabled);
  const Rgba colour = enabled ? ui.theme().text : ui.theme().text_disabled;
  ImGui::GetWindowDrawList()->AddText(
      {at.x + box + ui.px(8), std::round(at.y + 0.5F * (height - ImGui::GetFontSize()))}, to_u32(colour),
      words.c_str());
  note_item(ui, "checkbox", label, on ? "on" : "off", options);
  return clicked;
}

namespace {

// As many beside each other as leave room for the longest name; 1 at least.
int columns_for(const Ui& ui, std::span<const std::string> names, float width) {
  float longest = 0.0F;
  for (const std::string& name : names) longest = std::max(longest, ImGui::CalcTextSize(name.c_str()).x);
  const auto room = static_cast<int>((width + ui.px(2)) / (longest + ui.px(6) + ui.px(2)));
  const int count = static_cast<int>(names.size());
  if (room >= count) return count;
  const int columns = std::max(room, 1);
  const int rows = (count + columns - 1) / columns;
  return (count + rows - 1) / rows;
}

}  // namespace

bool segmented(Ui& ui, std::string_view label, int& chosen, std::span<const std::string> names,
               const WidgetOptions& options) {
  const Scope scope(ui, label);
  const float gap = ui.px(2);
  const float width = options.width > 0.0F ? options.width : ImGui::GetContentRegionAvail().x;
  const int columns = columns_for(ui, names, width);
  const float each = (width - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  bool changed = false;
  ImGui::BeginGroup();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  for (int i = 0; i < static_cast<int>(names.size()); ++i) {
    const std::string& name = names[static_cast<std::size_t>(i)];
    if (segment_button(ui, name, i == chosen, each, options) && (options.again || i != chosen)) {
      chosen = i;
      changed = true;
    }
    if ((i + 1) % columns != 0 && i + 1 < static_cast<int>(names.size())) ImGui::SameLine(0.0F, gap);
  }
  ImGui::PopStyleVar();
  ImGui::EndGroup();
  return changed;
}

}  // namespace trocar::ui
