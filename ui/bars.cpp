#include "ui/bars.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "ui/command_table.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::JobState;

void draw_menu_item(Ui& ui, const WorkbenchState& state, const CommandRow& row, Requests& requests) {
  const std::string reason = row.reason_now(state);
  const std::string keys(shown_keys(ui, row.id));
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
    const std::string label = shown_path(path);
    const bool clicked = ImGui::MenuItem((fitted(label, ui.px(300)) + "###" + label).c_str());
    note_item(ui, "menu item", label, "", {.help = "Open this project again"});
    if (clicked) requests.emplace_back(workbench::Command{workbench::OpenProject{path, false}});
  }
}

void draw_menu(Ui& ui, const WorkbenchState& state, const Settings& settings, std::string_view menu,
               Requests& requests);

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
  for (const std::string_view inner : command_menus()) {
    if (menu_above(inner) == menu) draw_menu(ui, state, settings, inner, requests);
  }
}

// How much of the menu bar is spelled out; the first for which there is room is taken.
enum class BarWords : std::uint8_t { kAll, kIcons, kOneMenu };

constexpr std::array<std::string_view, kWorkspaceCount> kWorkspaceCommands{
    "view.library", "view.author", "view.fields", "view.rollouts", "view.trials", "view.export"};

struct Lamp {
  std::string label;
  const char* icon = nullptr;
  std::string short_words;  ///< Beside the icon where room is short.
  bool on = false;          ///< Something moves: a spinner in place of the icon.
  std::string help;
  std::optional<PanelId> panel;  ///< Shown by a click.
};

std::size_t problems_of(const WorkbenchState& state) {
  if (!state.review) return 0;
  const auto& problems = state.review->review.problems;
  return review::count_of(problems, demonstration::Severity::kError) +
         review::count_of(problems, demonstration::Severity::kWarning);
}

// From right to left.
std::vector<Lamp> lamps_of(const WorkbenchState& state) {
  const auto running = std::count_if(state.jobs.begin(), state.jobs.end(), [](const workbench::JobView& job) {
    return job.state == JobState::kRunning || job.state == JobState::kQueued;
  });
  const auto reported = std::count_if(state.log.begin(), state.log.end(), [](const workbench::LogLine& line) {
    return line.severity != workbench::Severity::kInfo;
  });
  std::vector<Lamp> lamps;
  lamps.push_back({"SIM", icon::kChip, "", false, "SIM: every arm is simulated; no real arm is connected", {}});
  if (reported > 0) {
    lamps.push_back({count(reported) + " in the log", icon::kList, count(reported), false,
                     "Warnings and errors are in the log", PanelId::kLog});
  }
  // Notes are worth knowing and no problem.
  const auto problems = static_cast<std::int64_t>(problems_of(state));
  if (selected_demonstration(state) != nullptr && state.review) {
    lamps.push_back({count(problems) + (problems == 1 ? " problem" : " problems"),
                     problems == 0 ? icon::kVerify : icon::kWarning, count(problems), false,
                     "Errors and warnings about the selected demonstration", PanelId::kProblems});
  }
  if (running > 0) {
    lamps.push_back({count(running) + (running == 1 ? " job" : " jobs"), icon::kTasks, count(running), true,
                     "Show what runs", PanelId::kJobs});
  }
  return lamps;
}

std::string words_of(const Lamp& lamp, BarWords detail) {
  const std::string& words = detail == BarWords::kAll ? lamp.label : lamp.short_words;
  if (lamp.on) return fmt::format("     {}", words);
  return words.empty() ? std::string(lamp.icon) : std::string(lamp.icon) + "  " + words;
}

float framed_width(const std::string& words) {
  return ImGui::CalcTextSize(words.c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x;
}

float gap_of(const Ui& ui, BarWords detail) {
  return detail == BarWords::kAll ? ui.px(28) : ui.px(20);
}

float bar_width(const Ui& ui, const std::vector<Lamp>& lamps, BarWords detail) {
  float width = 2.0F * ui.px(12) + gap_of(ui, detail);
  for (const std::string_view menu : command_menus()) {
    const bool shown = detail != BarWords::kOneMenu && menu_above(menu).empty();
    if (shown) width += ImGui::CalcTextSize(menu.data(), menu.data() + menu.size()).x + ui.px(28);
  }
  if (detail == BarWords::kOneMenu) width += ImGui::CalcTextSize(icon::kBars).x + ui.px(28);
  for (std::size_t i = 0; i < kWorkspaceCount; ++i) {
    const auto workspace = static_cast<Workspace>(i);
    width +=
        ui.px(2) + framed_width(detail == BarWords::kAll ? std::string(title(workspace))
                                                         : std::string(icon_of(main_panel(static_cast<Workspace>(i)))));
  }
  for (const Lamp& lamp : lamps) width += framed_width(words_of(lamp, detail)) + ui.px(4);
  return width;
}

BarWords bar_words(const Ui& ui, const std::vector<Lamp>& lamps) {
  for (const BarWords detail : {BarWords::kAll, BarWords::kIcons}) {
    if (bar_width(ui, lamps, detail) <= ImGui::GetWindowWidth()) return detail;
  }
  return BarWords::kOneMenu;
}

// Of the next menu's name. ImGui does not say it once the menu is open: then its last item is the menu.
Rect menu_rect(const Ui& ui, std::string_view words) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool in_bar = ImGui::GetCurrentWindowRead()->DC.LayoutType == ImGuiLayoutType_Horizontal;
  if (!in_bar) {
    const float half = 0.5F * ImGui::GetStyle().ItemSpacing.y;
    return {at.x, at.y - half, at.x + ImGui::GetContentRegionAvail().x, at.y + ImGui::GetTextLineHeight() + half};
  }
  const float beside = std::floor(0.5F * ImGui::GetStyle().ItemSpacing.x);
  return {at.x - beside, 0.0F, at.x + ImGui::CalcTextSize(words.data(), words.data() + words.size()).x + 3.0F * beside,
          menu_bar_height(ui)};
}

void draw_menu(Ui& ui, const WorkbenchState& state, const Settings& settings, std::string_view menu,
               Requests& requests) {
  note_rect(ui, "menu", menu, "", menu_rect(ui, menu), {});
  const bool open = ImGui::BeginMenu(std::string(menu).c_str());
  if (open) ui.items().set_last_value("open");
  if (!open) return;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(10), ui.px(10)});
  draw_menu_items(ui, state, settings, menu, requests);
  ImGui::PopStyleVar();
  ImGui::EndMenu();
}

void draw_menus_of_bar(Ui& ui, const WorkbenchState& state, const Settings& settings, Requests& requests) {
  for (const std::string_view menu : command_menus()) {
    if (menu_above(menu).empty()) draw_menu(ui, state, settings, menu, requests);
  }
}

void draw_menus(Ui& ui, const WorkbenchState& state, const Settings& settings, BarWords detail, Requests& requests) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(14), ui.px(8)});
  if (detail != BarWords::kOneMenu) {
    draw_menus_of_bar(ui, state, settings, requests);
  } else {
    note_rect(ui, "menu", "All menus", "", menu_rect(ui, icon::kBars),
              {.help = "File, Edit, Select, Tool, View, Transport, Help"});
    const bool open = ImGui::BeginMenu(icon::kBars);
    if (open) ui.items().set_last_value("open");
    if (open) {
      ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(10), ui.px(10)});
      draw_menus_of_bar(ui, state, settings, requests);
      ImGui::PopStyleVar();
      ImGui::EndMenu();
    }
  }
  ImGui::PopStyleVar();
}

void draw_workspaces(Ui& ui, const Settings& settings, BarWords detail, Requests& requests) {
  const Scope scope(ui, "Workspaces");
  ImGui::SameLine(0.0F, gap_of(ui, detail));
  for (std::size_t i = 0; i < kWorkspaceCount; ++i) {
    const auto workspace = static_cast<Workspace>(i);
    if (i > 0) ImGui::SameLine(0.0F, ui.px(2));
    const std::string keys(shown_keys(ui, kWorkspaceCommands[i]));
    const std::string help = std::string(title(workspace)) + " workspace";
    const char* only = detail == BarWords::kAll ? nullptr : icon_of(main_panel(static_cast<Workspace>(i)));
    if (toggle(ui, title(workspace), settings.workspace == workspace,
               {.icon = only, .icon_only = only != nullptr, .help = help, .shortcut = keys})) {
      requests.emplace_back(ShowWorkspace{workspace});
    }
    if (settings.workspace != workspace) continue;
    const Rect rect = item_rect();
    ImGui::GetWindowDrawList()->AddRectFilled({rect.x0, rect.y1 - ui.px(2)}, {rect.x1, rect.y1},
                                              to_u32(ui.theme().accent));
  }
}

void draw_lamps(Ui& ui, const std::vector<Lamp>& lamps, BarWords detail, const Settings& settings, double frames_hz,
                Requests& requests) {
  const float free_from = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
  float x = ImGui::GetWindowWidth() - ui.px(12);
  const auto place = [&](const std::string& words) {
    x -= framed_width(words) + ui.px(4);
    ImGui::SameLine(x);
  };
  for (const Lamp& lamp : lamps) {
    const std::string words = words_of(lamp, detail);
    place(words);
    const WidgetOptions options{.icon = lamp.icon, .help = lamp.help};
    if (toggle_shown_as(ui, lamp.label, words, lamp.on, options) && lamp.panel) {
      requests.emplace_back(ShowPanel{*lamp.panel});
    }
    if (!lamp.on) continue;
    const Rect rect = item_rect();
    const float radius = 0.42F * ImGui::GetFontSize();
    const float left = rect.x0 + ImGui::GetStyle().FramePadding.x + radius;
    spinner_at(ui, {left, std::round(rect.centre_y())}, radius, ui.theme().accent);
  }
  const std::string rate = fmt::format("{:.0f} fps", frames_hz);
  if (settings.frame_rate && x - framed_width(rate) - ui.px(4) > free_from) {
    place(rate);
    ImGui::AlignTextToFramePadding();
    dim_text(ui, rate);
  }
}

// The buttons of the tool bar, and how they shrink: first the search field, then every button.
enum class ToolWords : std::uint8_t { kAll, kShortSearch, kIcons };

struct Tool {
  std::string_view id;
  std::string_view label;  ///< "": an icon always.
  ButtonStyle style = ButtonStyle::kQuiet;
  float space = 4.0F;  ///< Before it, pixels at 100 %.
};

std::vector<Tool> tools_of(const WorkbenchState& state) {
  std::vector<Tool> tools;
  if (state.take && state.take->reviewing) {
    tools.push_back({"record.keep", "Keep", ButtonStyle::kPrimary, 0.0F});
    tools.push_back({"record.discard", "Discard", ButtonStyle::kNormal, 8.0F});
  } else if (state.live) {
    tools.push_back({"demo.stop", "Stop and keep", ButtonStyle::kDanger, 0.0F});
    tools.push_back({"demo.discard", "Discard", ButtonStyle::kNormal, 8.0F});
  } else {
    tools.push_back({"demo.record", "Record…", ButtonStyle::kNormal, 0.0F});
  }
  tools.push_back({"edit.undo", "", ButtonStyle::kQuiet, 14.0F});
  tools.push_back({"edit.redo", "", ButtonStyle::kQuiet, 2.0F});
  tools.push_back({"edit.trim_idle", "Trim idle", ButtonStyle::kQuiet, 14.0F});
  tools.push_back({"demo.verify", "Verify replay"});
  tools.push_back({"model.train", "Train…"});
  tools.push_back({"file.export_video", "Export video…"});
  return tools;
}

float icon_width(const Ui& ui) {
  return ImGui::GetFrameHeight() + ui.px(4);
}

float search_width(const Ui& ui, ToolWords detail) {
  return detail == ToolWords::kAll ? ui.px(210) : icon_width(ui);
}

float tools_width(const Ui& ui, const std::vector<Tool>& tools, ToolWords detail) {
  float width = 2.0F * ui.px(10) + ui.px(14) + search_width(ui, detail);
  for (const Tool& tool : tools) {
    const bool icon_only = tool.label.empty() || detail == ToolWords::kIcons;
    width += ui.px(tool.space) + (icon_only ? icon_width(ui) : button_width(ui, tool.label, command(tool.id).icon));
  }
  return width;
}

ToolWords tool_words(const Ui& ui, const std::vector<Tool>& tools) {
  for (const ToolWords detail : {ToolWords::kAll, ToolWords::kShortSearch}) {
    if (tools_width(ui, tools, detail) <= ImGui::GetWindowWidth()) return detail;
  }
  return ToolWords::kIcons;
}

}  // namespace

float menu_bar_height(const Ui& ui) {
  return ui.px(38);
}

float tool_bar_height(const Ui& ui) {
  return ui.px(42);
}

Requests draw_menu_bar(Ui& ui, const WorkbenchState& state, const Settings& settings, double frames_hz) {
  Requests requests;
  const Scope scope(ui, "Menu");
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      {ui.px(10), 0.5F * (menu_bar_height(ui) - ui.fonts().body->FontSize)});
  if (ImGui::BeginMenuBar()) {
    const std::vector<Lamp> lamps = lamps_of(state);
    const BarWords detail = bar_words(ui, lamps);
    draw_menus(ui, state, settings, detail, requests);
    draw_workspaces(ui, settings, detail, requests);
    draw_lamps(ui, lamps, detail, settings, frames_hz, requests);
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
  const std::vector<Tool> tools = tools_of(state);
  const ToolWords detail = tool_words(ui, tools);
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const Tool& tool = tools[i];
    if (i > 0) ImGui::SameLine(0.0F, ui.px(tool.space));
    if (tool.label.empty() || detail == ToolWords::kIcons) {
      command_icon(ui, state, tool.id, requests, tool.style);
    } else {
      command_button(ui, state, tool.id, tool.label, tool.style, requests);
    }
  }
  const float width = search_width(ui, detail);
  ImGui::SameLine(ImGui::GetWindowWidth() - width - ui.px(10));
  if (detail != ToolWords::kAll) {
    command_icon(ui, state, "help.palette", requests);
    return requests;
  }
  const ColourScope dim(ImGuiCol_Text, ui.theme().text_dim);
  ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0.0F, 0.5F});
  if (button(ui, "Find a command…",
             {.icon = icon::kSearch,
              .help = "Every command by its name",
              .shortcut = shown_keys(ui, "help.palette"),
              .width = width})) {
    requests.emplace_back(UiAction::kShowPalette);
  }
  ImGui::PopStyleVar();
  return requests;
}

}  // namespace trocar::ui
