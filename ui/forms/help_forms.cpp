#include "ui/forms/help_forms.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>

#include "ui/command_table.h"
#include "ui/icons.h"
#include "ui/panel_pages.h"

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
  const auto& table = command_table();
  const auto has_keys = [&](const CommandRow& row) { return row.menu == menu && !ui.keymap().chords(row.id).empty(); };
  if (std::none_of(table.begin(), table.end(), has_keys)) return;
  const Scope scope(ui, menu);
  heading(ui, menu);
  if (!begin_keys("keys")) return;
  for (const CommandRow& row : table) {
    if (has_keys(row)) key_row(ui, row.title, ui.keymap().all(row.id));
  }
  ImGui::EndTable();
  ImGui::Dummy({0.0F, ui.px(4)});
}

void mouse_keys(Ui& ui, std::span<const MouseHelp> rows) {
  const Scope scope(ui, "Mouse");
  heading(ui, "Mouse");
  if (!begin_keys("keys")) return;
  for (const MouseHelp& row : rows) {
    if (!row.act.empty()) key_row(ui, row.act, row.how);
  }
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
    for (const std::string_view menu : {"File", "Edit", "Modify", "Label", "Help"}) menu_keys(ui, menu);
    mouse_keys(ui, all_mouse_help());
    if (two) ImGui::TableNextColumn();
    for (const std::string_view menu : {"View", "Panels", "Layout", "Transport", "Select", "Tool"}) menu_keys(ui, menu);
    ImGui::EndTable();
  }
  ImGui::EndChild();
  return {};
}

void PageForm::open_on(PanelId panel) {
  panel_ = panel;
  open();
}

void PageForm::draw_commands(Ui& ui) const {
  const auto commands = commands_of(page_of(panel_));
  if (commands.empty()) return;
  const Scope scope(ui, "Commands");
  heading(ui, "Commands");
  if (!begin_keys("commands")) return;
  for (const CommandRow* row : commands) {
    const std::string keys = ui.keymap().all(row->id);
    const std::string words = keys.empty() ? std::string(row->help) : fmt::format("{} – {}", keys, row->help);
    key_row(ui, row->title, words);
  }
  ImGui::EndTable();
}

Requests PageForm::draw_content(Ui& ui, const WorkbenchState&) {
  Requests requests;
  const PanelPage& page = page_of(panel_);
  {
    const FontScope font(ui.fonts().strong);
    wrapped_text(ui, std::string(ui::title(panel_)) + ": " + std::string(page.summary), ui.theme().text);
  }
  wrapped_text(ui, page.more, ui.theme().text);
  // In a low window all of it scrolls together.
  const float room = ImGui::GetContentRegionAvail().y - ImGui::GetFrameHeightWithSpacing();
  const bool apart = room >= ui.px(120);
  if (apart) ImGui::BeginChild("page", {0.0F, room});
  if (!page.mouse.front().act.empty()) mouse_keys(ui, page.mouse);
  draw_commands(ui);
  if (apart) ImGui::EndChild();
  if (button(ui, "All keys…", {.icon = icon::kKeyboard, .help = "Every key there is"})) {
    requests.emplace_back(UiAction::kShowShortcuts);
    close();
  }
  flow(button_width(ui, "Change keys…", icon::kPencil), ui.px(6));
  if (button(ui, "Change keys…", {.icon = icon::kPencil, .help = "Give commands other keys"})) {
    requests.emplace_back(UiAction::kShowKeys);
    close();
  }
  return requests;
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
