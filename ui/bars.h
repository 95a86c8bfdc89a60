/// The strips above and below the tiles: menu bar with workspace tabs, and status line.
#pragma once

#include <string>

#include "ui/panel.h"
#include "ui/settings.h"

namespace trocar::ui {

/// The menu bar across the top of the current window: menus, workspaces, project, lamps.
Requests draw_menu_bar(Ui& ui, const WorkbenchState& state, const Settings& settings, double frames_hz);
float menu_bar_height(const Ui& ui);

/// The buttons below it: record, undo, train and their like.
Requests draw_tool_bar(Ui& ui, const WorkbenchState& state);
float tool_bar_height(const Ui& ui);

struct StatusLine {
  std::string hint;          ///< Of what is under the pointer, from the last frame.
  std::string done;          ///< What was last done.
  bool just_done = false;    ///< The pointer has rested since: it is told in place of the hint.
  std::string last_command;  ///< As the command line would say it.
};
Requests draw_status_line(Ui& ui, const WorkbenchState& state, const StatusLine& line);
float status_line_height(const Ui& ui);

}  // namespace trocar::ui
