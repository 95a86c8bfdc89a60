#include "ui/forms/help_forms.h"

#include <string>

#include "ui/command_table.h"

namespace trocar::ui {
namespace {

void key_row(Ui& ui, std::string_view title, std::string_view keys) {
  const float left = ImGui::GetCursorPosX();
  ImGui::TextUnformatted(title.data(), title.data() + title.size());
  ImGui::SameLine(left + ui.px(190));
  const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
  ImGui::TextUnformatted(keys.data(), keys.data() + keys.size());
  note_item(ui, "text", title, keys, {});
}

void mouse_rows(Ui& ui) {
  ImGui::Dummy({0.0F, ui.px(4)});
  heading(ui, "Mouse");
  key_row(ui, "Turn the view", "Left drag");
  key_row(ui, "Shift the view", "Right or middle drag");
  key_row(ui, "Zoom", "Wheel, at the pointer");
  key_row(ui, "Trim", "Drag a gate; Esc cancels");
  key_row(ui, "Step a slice", "Wheel over it");
}

}  // namespace

Requests ShortcutForm::draw_content(Ui& ui, const WorkbenchState&) {
  ImGui::BeginChild("keys");
  ImGui::Columns(2, nullptr, false);
  std::string_view menu;
  for (const CommandRow& row : command_table()) {
    if (row.keys.empty()) continue;
    if (row.menu != menu) {
      if (row.menu == "View") ImGui::NextColumn();
      if (!menu.empty() && row.menu != "View") ImGui::Dummy({0.0F, ui.px(4)});
      menu = row.menu;
      heading(ui, menu);
    }
    std::string keys;
    for (const std::string_view chord : row.keys) keys += (keys.empty() ? "" : ", ") + std::string(chord);
    key_row(ui, row.title, keys);
  }
  mouse_rows(ui);
  ImGui::Columns(1);
  ImGui::EndChild();
  return {};
}

Requests AboutForm::draw_content(Ui& ui, const WorkbenchState&) {
  wrapped_text(ui, "Trocar 0.1.0, a workbench for people who teach surgical robots by demonstration.", ui.theme().text);
  wrapped_text(
      ui,
      "Free software under the licence in the file LICENSE. It stands on ODE, Mesa, Dear ImGui, GLFW, FreeType, "
      "SQLite, Eigen, OpenCV, Cairo and assimp, as Debian packages them.",
      ui.theme().text_dim);
  return {};
}

}  // namespace trocar::ui
