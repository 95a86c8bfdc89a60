#include <imgui_internal.h>

#include <algorithm>

#include "ui/widgets/widgets.h"

namespace trocar::ui {
namespace {

void show_tooltip(Ui& ui, const WidgetOptions& options) {
  ui.set_tooltip(ui.items().items().back().path);
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

std::uint32_t layer_of(const ImGuiWindow& window) {
  const ImGuiWindow* root = &window;
  // A child of a pop-up belongs to the pop-up; a pop-up itself is no child of what it lies on.
  while ((root->Flags & ImGuiWindowFlags_ChildWindow) != 0 && (root->Flags & ImGuiWindowFlags_Popup) == 0 &&
         root->ParentWindow != nullptr) {
    root = root->ParentWindow;
  }
  return root->ID;
}

void note_region(Item& item) {
  const ImGuiWindow* window = ImGui::GetCurrentWindowRead();
  item.region = window->ID;
  // A table clips its columns, and to nothing where they are scrolled out of sight; what counts is the region.
  if ((window->Flags & ImGuiWindowFlags_ChildWindow) != 0 || ImGui::GetCurrentTable() != nullptr) {
    item.clip.y0 = window->InnerClipRect.Min.y;
    item.clip.y1 = window->InnerClipRect.Max.y;
  }
  // A row goes across all columns, whichever it is drawn in.
  if (item.role == "row" && ImGui::GetCurrentTable() != nullptr) {
    item.clip.x0 = window->InnerClipRect.Min.x;
    item.clip.x1 = window->InnerClipRect.Max.x;
  }
  item.layer = layer_of(*window);
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

// The last item noted gets a ring, and is brought into sight, if the keyboard is on it.
void show_focus(Ui& ui) {
  const Item& item = ui.items().items().back();
  if (!ui.focus().is_on(item)) return;
  if (ui.focus().take_scroll()) {
    ImGui::ScrollToBringRectIntoView(ImGui::GetCurrentWindow(),
                                     {item.rect.x0, item.rect.y0, item.rect.x1, item.rect.y1});
  }
  if (!item.help.empty()) ui.set_hint(item.help);
  const float gap = ui.px(1);
  const float rim = ui.px(2);
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.PushClipRect({item.clip.x0 - rim, item.clip.y0 - rim}, {item.clip.x1 + rim, item.clip.y1 + rim});
  list.AddRect({item.rect.x0 - gap, item.rect.y0 - gap}, {item.rect.x1 + gap, item.rect.y1 + gap},
               to_u32(ui.theme().accent), ui.px(4), ImDrawFlags_None, rim);
  list.PopClipRect();
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
  show_focus(ui);
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  if (options.help.empty() && options.reason.empty()) return;
  ui.set_hint(options.reason.empty() ? options.help : options.reason);
  if (ui.rested_on(ui.items().items().back().path)) show_tooltip(ui, options);
}

void note_rect(Ui& ui, std::string_view role, std::string_view label, std::string_view value, const Rect& rect,
               const WidgetOptions& options) {
  ui.items().add(make_item(role, label, value, rect, options));
  show_focus(ui);
}

}  // namespace trocar::ui
