/// The line below the tiles: what is under the pointer or was last done, and the last act as a command line.
#pragma once

#include <string>

#include "ui/panel.h"

namespace trocar::ui {

struct StatusLine {
  std::string hint;          ///< Of what is under the pointer, from the last frame.
  std::string done;          ///< What was last done.
  bool just_done = false;    ///< The pointer has rested since: it is told in place of the hint.
  std::string last_command;  ///< As the command line would say it.
};
Requests draw_status_line(Ui& ui, const WorkbenchState& state, const StatusLine& line);
float status_line_height(const Ui& ui);

}  // namespace trocar::ui
