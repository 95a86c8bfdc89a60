#include <algorithm>
#include <string>

#include "ui/widgets/widgets.h"

namespace trocar::ui {

bool selectable_row(Ui& ui, std::string_view label, bool selected, std::string_view value,
                    const WidgetOptions& options) {
  // In a table the whole row is lit, with the margins of its cells.
  const bool in_table = ImGui::TableGetColumnCount() > 0;
  const Rgba clear{0, 0, 0, 0};
  const Rgba lit = selected ? ui.theme().selection : ui.theme().raised;
  const ColourScope header(ImGuiCol_Header, in_table ? clear : ui.theme().selection);
  const ColourScope hovered(ImGuiCol_HeaderHovered, in_table ? clear : lit);
  const ColourScope held(ImGuiCol_HeaderActive, in_table ? clear : ui.theme().selection);
  const bool clicked = ImGui::Selectable(("##" + std::string(label)).c_str(), selected,
                                         ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap,
                                         {0.0F, options.height});
  if (in_table && (selected || ImGui::IsItemHovered())) {
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg1, to_u32(lit));
  }
  note_item(ui, "row", label, value.empty() ? (selected ? "selected" : "") : value, options);
  return clicked;
}

bool canvas(Ui& ui, std::string_view label, ImVec2 size, std::string_view value, const WidgetOptions& options) {
  const ImVec2 real{std::max(size.x, 1.0F), std::max(size.y, 1.0F)};
  ImGui::InvisibleButton(
      std::string(label).c_str(), real,
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) ui.take_wheel();
  if (hovered && !options.help.empty()) ui.set_hint(options.help);
  note_rect(ui, "canvas", label, value, item_rect(), options);
  return hovered;
}

bool splitter(Ui& ui, std::string_view label, bool vertical, const Rect& rect, float& position, bool& equalise) {
  ImGui::SetCursorScreenPos({rect.x0, rect.y0});
  ImGui::InvisibleButton(std::string(label).c_str(), {rect.width(), rect.height()});
  const bool hovered = ImGui::IsItemHovered();
  const bool active = ImGui::IsItemActive();
  equalise = hovered && ImGui::IsMouseDoubleClicked(0);
  if (hovered || active) {
    ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    const float middle = vertical ? rect.centre_x() : rect.centre_y();
    const float half = std::max(1.0F, ui.px(1));
    const ImVec2 low = vertical ? ImVec2{middle - half, rect.y0} : ImVec2{rect.x0, middle - half};
    const ImVec2 high = vertical ? ImVec2{middle + half, rect.y1} : ImVec2{rect.x1, middle + half};
    ImGui::GetWindowDrawList()->AddRectFilled(low, high, to_u32(ui.theme().accent, active ? 1.0F : 0.6F));
    ui.set_hint("Drag to resize, double-click to share the room equally");
  }
  note_rect(ui, "splitter", label, std::to_string(static_cast<int>(position)), rect);
  const bool moved = active && ImGui::IsMouseDragging(0, 0.0F);
  if (moved) position = vertical ? ImGui::GetIO().MousePos.x : ImGui::GetIO().MousePos.y;
  return moved;
}

}  // namespace trocar::ui
