#include "ui/forms/help_forms.h"

#include <string>

#include "ui/command_table.h"

namespace trocar::ui {
namespace {

void key_row(Ui& ui, std::string_view title, std::string_view keys) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(title.data(), title.data() + title.size());
  ImGui::TableNextColumn();
  const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
  ImGui::TextUnformatted(keys.data(), keys.data() + keys.size());
  ImGui::PopTextWrapPos();
  note_item(ui, "text", title, keys, {});
}

bool begin_keys(const char* id) {
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoPadOuterX;
  if (!ImGui::BeginTable(id, 2, kFlags)) return false;
  ImGui::TableSetupColumn("Command", ImGuiTableColumnFlags_WidthStretch, 1.1F);
  ImGui::TableSetupColumn("Keys", ImGuiTableColumnFlags_WidthStretch, 1.0F);
  return true;
}

void menu_keys(Ui& ui, std::string_view menu) {
  const Scope scope(ui, menu);
  heading(ui, menu);
  if (!begin_keys("keys")) return;
  for (const CommandRow& row : command_table()) {
    if (row.menu != menu || row.keys.empty()) continue;
    std::string keys;
    for (const std::string_view chord : row.keys) keys += (keys.empty() ? "" : ", ") + std::string(chord);
    key_row(ui, row.title, keys);
  }
  ImGui::EndTable();
  ImGui::Dummy({0.0F, ui.px(4)});
}

void mouse_keys(Ui& ui) {
  const Scope scope(ui, "Mouse");
  heading(ui, "Mouse");
  if (!begin_keys("keys")) return;
  key_row(ui, "Turn the view", "Left drag");
  key_row(ui, "Shift the view", "Right or middle drag");
  key_row(ui, "Zoom", "Wheel, at the pointer");
  key_row(ui, "Trim", "Drag a gate; Esc cancels");
  key_row(ui, "Move or turn a tool", "Drag a handle in the view; Ctrl: whole steps, wheel: reach, Esc cancels");
  key_row(ui, "Select time", "Drag over the lanes");
  key_row(ui, "Zoom to a span", "Middle drag");
  key_row(ui, "Step a slice", "Wheel over it");
  ImGui::EndTable();
}

}  // namespace

Requests ShortcutForm::draw_content(Ui& ui, const WorkbenchState&) {
  ImGui::BeginChild("keys");
  // Two columns where there is room for both.
  const float room = ImGui::GetContentRegionAvail().x;
  const bool two = room >= ui.px(560);
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_NoPadOuterX;
  if (ImGui::BeginTable("columns", two ? 2 : 1, kFlags, {0.0F, 0.0F})) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    for (const std::string_view menu : {"File", "Edit", "Help"}) menu_keys(ui, menu);
    mouse_keys(ui);
    if (two) ImGui::TableNextColumn();
    for (const std::string_view menu : {"View", "Transport", "Select", "Tool"}) menu_keys(ui, menu);
    ImGui::EndTable();
  }
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
