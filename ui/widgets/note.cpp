#include <imgui_internal.h>

#include <algorithm>

#include "ui/widgets/widgets.h"

namespace trocar::ui {
namespace {

void show_tooltip(Ui& ui, const WidgetOptions& options) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(9), ui.px(7)});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ui.px(340));
  if (!options.help.empty()) ImGui::TextUnformatted(options.help.data(), options.help.data() + options.help.size());
  if (!options.reason.empty()) {
    const ColourScope colour(ImGuiCol_Text, ui.theme().warning);
    ImGui::TextUnformatted(options.reason.data(), options.reason.data() + options.reason.size());
  }
  ImGui::PopTextWrapPos();
  if (!options.shortcut.empty()) {
    const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
    const FontScope font(ui.fonts().small);
    ImGui::TextUnformatted(options.shortcut.data(), options.shortcut.data() + options.shortcut.size());
  }
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void note_region(Item& item) {
  const ImGuiWindow* window = ImGui::GetCurrentWindowRead();
  item.region = window->ID;
  // A table clips its columns, and to nothing where they are scrolled out of sight; what counts is the region.
  if ((window->Flags & ImGuiWindowFlags_ChildWindow) != 0 || ImGui::GetCurrentTable() != nullptr) {
    item.clip.y0 = window->InnerClipRect.Min.y;
    item.clip.y1 = window->InnerClipRect.Max.y;
  }
  for (; window != nullptr; window = window->ParentWindow) {
    if ((window->Flags & ImGuiWindowFlags_NoScrollbar) != 0) break;
    // What overflows sideways counts as scroll room, too; but without the bar nobody gets there.
    const bool bar = (window->Flags & ImGuiWindowFlags_HorizontalScrollbar) != 0;
    item.scrolls_x = item.scrolls_x || (bar && window->ScrollMax.x > 0.0F);
    item.scrolls_y = item.scrolls_y || window->ScrollMax.y > 0.0F;
    item.room_y = std::max(item.room_y, window->InnerClipRect.GetHeight());
    if ((window->Flags & ImGuiWindowFlags_ChildWindow) == 0) break;
  }
}

Item make_item(std::string_view role, std::string_view label, std::string_view value, const Rect& rect,
               const WidgetOptions& options) {
  Item item;
  item.role = role;
  item.label = label;
  item.value = value;
  item.enabled = options.reason.empty();
  item.reason = options.reason;
  item.rect = rect;
  const ImVec2 low = ImGui::GetWindowDrawList()->GetClipRectMin();
  const ImVec2 high = ImGui::GetWindowDrawList()->GetClipRectMax();
  item.clip = {low.x, low.y, high.x, high.y};
  note_region(item);
  item.help = options.help;
  item.shortcut = options.shortcut;
  return item;
}

}  // namespace

Rect item_rect() {
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  return {low.x, low.y, high.x, high.y};
}

void note_item(Ui& ui, std::string_view role, std::string_view label, std::string_view value,
               const WidgetOptions& options) {
  ui.items().add(make_item(role, label, value, item_rect(), options));
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  if (options.help.empty() && options.reason.empty()) return;
  ui.set_hint(options.reason.empty() ? options.help : options.reason);
  if (!ImGui::IsAnyMouseDown() && ui.rested_on(ui.items().items().back().path)) show_tooltip(ui, options);
}

void note_rect(Ui& ui, std::string_view role, std::string_view label, std::string_view value, const Rect& rect,
               const WidgetOptions& options) {
  ui.items().add(make_item(role, label, value, rect, options));
}

}  // namespace trocar::ui
