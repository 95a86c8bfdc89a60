/// The strips above the tiles: the menu bar with workspace tabs, and the tool bar.
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

}  // namespace trocar::ui
