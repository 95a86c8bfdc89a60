#include "ui/bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ui/command_table.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::JobState;

void draw_menu_item(Ui& ui, const WorkbenchState& state, const CommandRow& row, Requests& requests) {
  const std::string reason = row.reason_now(state);
  const std::string keys = row.keys.empty() ? std::string() : std::string(row.keys.front());
  const ColourScope colour(ImGuiCol_Text, reason.empty() ? ui.theme().text : ui.theme().text_disabled);
  const ColourScope keys_colour(ImGuiCol_TextDisabled, ui.theme().text_dim);
  const bool clicked = ImGui::MenuItem(std::string(row.title).c_str(), keys.c_str(), false, reason.empty());
  note_item(ui, "menu item", row.title, "", {.help = row.help, .shortcut = keys, .reason = reason});
  if (clicked) append(requests, row.run(state));
}

void draw_recent(Ui& ui, const Settings& settings, Requests& requests) {
  if (settings.recent.empty()) return;
  ImGui::Separator();
  for (const std::string& path : settings.recent) {
    const std::string label = fitted(shown_path(path), ui.px(300));
    const bool clicked = ImGui::MenuItem(label.c_str());
    note_item(ui, "menu item", label, "", {.help = "Open this project again"});
    if (clicked) requests.emplace_back(workbench::Command{workbench::OpenProject{path, false}});
  }
}

// Its scope ends before the menu's window does.
void draw_menu_items(Ui& ui, const WorkbenchState& state, const Settings& settings, std::string_view menu,
                     Requests& requests) {
  const Scope scope(ui, menu);
  for (const CommandRow& row : command_table()) {
    if (row.menu != menu) continue;
    if (row.separator) ImGui::Separator();
    draw_menu_item(ui, state, row, requests);
  }
  if (menu == "File") draw_recent(ui, settings, requests);
}

void draw_menus(Ui& ui, const WorkbenchState& state, const Settings& settings, Requests& requests) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(14), ui.px(8)});
  for (const char* menu : {"File", "Edit", "View", "Transport", "Help"}) {
    const bool open = ImGui::BeginMenu(menu);
    note_item(ui, "menu", menu, open ? "open" : "", {});
    if (!open) continue;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(10), ui.px(8)});
    draw_menu_items(ui, state, settings, menu, requests);
    ImGui::PopStyleVar();
    ImGui::EndMenu();
  }
  ImGui::PopStyleVar();
}

void draw_workspaces(Ui& ui, const Settings& settings, Requests& requests) {
  const Scope scope(ui, "Workspaces");
  ImGui::SameLine(0.0F, ui.px(28));
  for (std::size_t i = 0; i < kWorkspaceCount; ++i) {
    const auto workspace = static_cast<Workspace>(i);
    if (i > 0) ImGui::SameLine(0.0F, ui.px(2));
    const std::string keys = fmt::format("Ctrl+{}", i + 1);
    const std::string help = std::string(title(workspace)) + " workspace";
    if (toggle(ui, title(workspace), settings.workspace == workspace, {.help = help, .shortcut = keys})) {
      requests.emplace_back(ShowWorkspace{workspace});
    }
    if (settings.workspace != workspace) continue;
    const Rect rect = item_rect();
    ImGui::GetWindowDrawList()->AddRectFilled({rect.x0, rect.y1 - ui.px(2)}, {rect.x1, rect.y1},
                                              to_u32(ui.theme().accent));
  }
}

// The lamps at the right end, drawn from right to left.
void draw_lamps(Ui& ui, const WorkbenchState& state, double frames_hz, Requests& requests) {
  const auto running = std::count_if(state.jobs.begin(), state.jobs.end(), [](const workbench::JobView& job) {
    return job.state == JobState::kRunning || job.state == JobState::kQueued;
  });
  const auto problems = std::count_if(state.log.begin(), state.log.end(), [](const workbench::LogLine& line) {
    return line.severity != workbench::Severity::kInfo;
  });
  float x = ImGui::GetWindowWidth() - ui.px(12);
  const auto place = [&](const std::string& words) {
    const float width = ImGui::CalcTextSize(words.c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x;
    x -= width + ui.px(4);
    ImGui::SameLine(x);
  };
  const std::string sim = std::string(icon::kChip) + "  SIM";
  place(sim);
  toggle(ui, "SIM", false, {.icon = icon::kChip, .help = "Every arm is simulated; no real arm is connected"});
  if (problems > 0) {
    const std::string label = count(problems) + (problems == 1 ? " problem" : " problems");
    place(std::string(icon::kWarning) + "  " + label);
    if (toggle(ui, label, false, {.icon = icon::kWarning, .help = "Warnings and errors are in the log"})) {
      requests.emplace_back(ShowPanel{PanelId::kLog});
    }
  }
  if (running > 0) {
    const std::string label = count(running) + (running == 1 ? " job" : " jobs");
    place(std::string(icon::kTasks) + "  " + label);
    if (toggle(ui, label, true, {.icon = icon::kTasks, .help = "Show what runs"})) {
      requests.emplace_back(ShowPanel{PanelId::kJobs});
    }
  }
  if (frames_hz > 0.0) {
    const std::string words = fmt::format("{:.0f} fps", frames_hz);
    place(words);
    ImGui::AlignTextToFramePadding();
    dim_text(ui, words);
  }
}

}  // namespace

float menu_bar_height(const Ui& ui) {
  return ui.px(38);
}

float tool_bar_height(const Ui& ui) {
  return ui.px(42);
}

float status_line_height(const Ui& ui) {
  return ui.px(28);
}

Requests draw_menu_bar(Ui& ui, const WorkbenchState& state, const Settings& settings, double frames_hz) {
  Requests requests;
  const Scope scope(ui, "Menu");
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      {ui.px(10), 0.5F * (menu_bar_height(ui) - ui.fonts().body->FontSize)});
  if (ImGui::BeginMenuBar()) {
    draw_menus(ui, state, settings, requests);
    draw_workspaces(ui, settings, requests);
    draw_lamps(ui, state, frames_hz, requests);
    ImGui::EndMenuBar();
  }
  ImGui::PopStyleVar();
  return requests;
}

Requests draw_tool_bar(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  const Scope scope(ui, "Toolbar");
  ImGui::SetCursorPosX(ui.px(10));
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 0.5F * (tool_bar_height(ui) - ImGui::GetFrameHeight()));
  if (state.live) {
    command_button(ui, state, "demo.stop", "Stop and keep", ButtonStyle::kDanger, requests);
    ImGui::SameLine();
    command_button(ui, state, "demo.discard", "Discard", ButtonStyle::kNormal, requests);
  } else {
    command_button(ui, state, "demo.record", "Record…", ButtonStyle::kNormal, requests);
  }
  ImGui::SameLine(0.0F, ui.px(14));
  for (const std::string_view id : {"edit.undo", "edit.redo"}) {
    command_icon(ui, state, id, requests);
    ImGui::SameLine(0.0F, ui.px(2));
  }
  ImGui::SameLine(0.0F, ui.px(14));
  command_button(ui, state, "edit.trim_idle", "Trim idle", ButtonStyle::kQuiet, requests);
  ImGui::SameLine(0.0F, ui.px(4));
  command_button(ui, state, "demo.verify", "Verify replay", ButtonStyle::kQuiet, requests);
  ImGui::SameLine(0.0F, ui.px(4));
  command_button(ui, state, "model.train", "Train…", ButtonStyle::kQuiet, requests);
  ImGui::SameLine(0.0F, ui.px(4));
  command_button(ui, state, "file.export_video", "Export video…", ButtonStyle::kQuiet, requests);
  const std::string find = "Find a command…";
  const float width = ui.px(210);
  ImGui::SameLine(ImGui::GetWindowWidth() - width - ui.px(10));
  const ColourScope dim(ImGuiCol_Text, ui.theme().text_dim);
  ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0.0F, 0.5F});
  if (button(ui, find,
             {.icon = icon::kSearch, .help = "Every command by its name", .shortcut = "Ctrl+P", .width = width})) {
    requests.emplace_back(UiAction::kShowPalette);
  }
  ImGui::PopStyleVar();
  return requests;
}

Requests draw_status_line(Ui& ui, const WorkbenchState& state, const StatusLine& line) {
  Requests requests;
  const Scope scope(ui, "Status");
  const FontScope font(ui.fonts().small);
  const float top = ImGui::GetCursorPosY();
  const float height = status_line_height(ui);
  const float y = top + 0.5F * (height - ImGui::GetTextLineHeight());
  const float right = ImGui::GetWindowWidth() - ui.px(10);
  const std::string project = state.project == nullptr ? std::string("No project") : shown_path(state.path);
  ImGui::SetCursorPos({ui.px(12), y});
  const std::string hint = line.hint.empty() ? project : line.hint;
  const std::string shown = fitted(hint, 0.55F * right);
  {
    const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
    ImGui::TextUnformatted(shown.c_str());
    note_item(ui, "text", "Hint", hint, {});
  }
  if (line.last_command.empty()) return requests;
  const float copy = ui.px(26);
  ImGui::SetCursorPos({right - copy, top + ui.px(1)});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(4), ui.px(5)});
  if (icon_button(ui, "Copy as command",
                  {.icon = icon::kCopy,
                   .help = "Copy the last act as a command line",
                   .shortcut = "Ctrl+Shift+C",
                   .width = copy,
                   .style = ButtonStyle::kQuiet})) {
    requests.emplace_back(UiAction::kCopyCommand);
  }
  ImGui::PopStyleVar();
  const FontScope mono(ui.fonts().mono);
  const std::string words = fitted(line.last_command, 0.42F * right);
  ImGui::SetCursorPos({right - copy - ui.px(8) - ImGui::CalcTextSize(words.c_str()).x, y});
  const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
  ImGui::TextUnformatted(words.c_str());
  note_item(ui, "text", "Last command", line.last_command, {});
  return requests;
}

}  // namespace trocar::ui
