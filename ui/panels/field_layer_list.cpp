#include "ui/panels/field_layer_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::FieldSettings;
using Layers = std::vector<FieldSettings>;

bool only_visible(const WorkbenchState& state, std::size_t which) {
  if (state.field.visible || !state.field_layers[which].visible) return false;
  const auto shown =
      std::count_if(state.field_layers.begin(), state.field_layers.end(), [](const auto& one) { return one.visible; });
  return shown == 1;
}

/// What the buttons of one row make of the list; `field` is the one in the panel.
struct Change {
  Layers layers;
  FieldSettings field;
};

void draw_buttons(Ui& ui, const WorkbenchState& state, std::size_t i, Change& change) {
  const bool solo = only_visible(state, i);
  if (toggle_shown_as(ui, "Solo", "S", solo, {.help = "Show this layer alone; once more: all"})) {
    for (FieldSettings& one : change.layers) one.visible = solo;
    change.layers[i].visible = true;
    change.field.visible = solo;
  }
  const auto step = [&](const char* name, const char* icon, std::size_t to, bool possible, std::string_view help) {
    ImGui::SameLine(0.0F, ui.px(2));
    const WidgetOptions options{.icon = icon,
                                .icon_only = true,
                                .help = help,
                                .reason = possible ? "" : "It is there",
                                .style = ButtonStyle::kQuiet};
    if (button(ui, name, options)) std::swap(change.layers[i], change.layers[to]);
  };
  step("Up", icon::kArrowUp, i - 1, i > 0, "Draw it before the one above");
  step("Down", icon::kArrowDown, i + 1, i + 1 < state.field_layers.size(), "Draw it after the one below");
  ImGui::SameLine(0.0F, ui.px(2));
  if (button(ui, "Swap",
             {.icon = icon::kPencil,
              .icon_only = true,
              .help = "Change it in the panel, whose field takes its place here",
              .style = ButtonStyle::kQuiet})) {
    std::swap(change.layers[i], change.field);
  }
  ImGui::SameLine(0.0F, ui.px(2));
  if (button(ui, "Remove",
             {.icon = icon::kTrash, .icon_only = true, .help = "Take it off", .style = ButtonStyle::kQuiet})) {
    change.layers.erase(change.layers.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void draw_row(Ui& ui, const WorkbenchState& state, std::size_t i, Change& change) {
  const Scope scope(ui, std::to_string(i + 1));
  ImGui::PushID(static_cast<int>(i));
  const std::string words = field_words(state.field_layers[i]);
  bool visible = state.field_layers[i].visible;
  if (checkbox(ui, words, visible, {.help = "Draw it in the 3-D view"})) change.layers[i].visible = visible;
  const float buttons = 5.0F * (ImGui::GetFrameHeight() + ui.px(8));
  float opacity = state.field_layers[i].opacity;
  const float room = ImGui::GetContentRegionAvail().x - buttons - ui.px(14);
  if (slider_float(ui, "Opacity", opacity, 0.05F, 1.0F, "%.2f opaque",
                   {.help = "Of this layer", .width = std::max(room, ui.px(90))})) {
    change.layers[i].opacity = opacity;
  }
  flow(buttons, ui.px(8));
  ImGui::BeginGroup();
  draw_buttons(ui, state, i, change);
  ImGui::EndGroup();
  ImGui::PopID();
}

}  // namespace

std::string field_words(const FieldSettings& settings) {
  std::string drawn;
  const auto add = [&drawn](bool on, std::string_view word) {
    if (on) drawn += (drawn.empty() ? "" : ", ") + std::string(word);
  };
  add(std::any_of(settings.slices.begin(), settings.slices.end(), [](int index) { return index >= 0; }), "slices");
  add(settings.voxels, "voxels");
  add(settings.iso_surface, "surface");
  add(settings.volume, "volume");
  add(settings.streamlines, "streamlines");
  std::string words = fmt::format("{} · {}", learning::to_string(settings.layer), drawn);
  if (settings.mask != learning::FieldMask::kNone) words += fmt::format(" · {}", learning::to_string(settings.mask));
  return words;
}

void draw_field_layers(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "Layers");
  Change change{state.field_layers, state.field};
  form_label(ui, "Layers");
  const std::string_view nothing = shows_field(state.field) ? "" : "Nothing of this field is in the 3-D view";
  if (button(ui, "Keep in the view",
             {.icon = icon::kPlus,
              .help = "Leave this field in the 3-D view as a layer, and choose another one besides it",
              .reason = nothing,
              .style = ButtonStyle::kQuiet})) {
    change.layers.push_back(state.field);
    // What was kept is not drawn twice.
    change.field.slices = {-1, -1, -1};
    change.field.voxels = change.field.iso_surface = change.field.volume = change.field.streamlines = false;
  }
  for (std::size_t i = 0; i < state.field_layers.size() && change.layers.size() == state.field_layers.size(); ++i) {
    draw_row(ui, state, i, change);
  }
  if (change.layers != state.field_layers) requests.emplace_back(Command{workbench::SetFieldLayers{change.layers}});
  if (change.field != state.field) requests.emplace_back(Command{workbench::SetField{change.field}});
}

}  // namespace trocar::ui
