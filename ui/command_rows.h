/// The rows of the command table by menu; only `command_table` gathers them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ui/command_table.h"

namespace trocar::ui {

std::vector<CommandRow> file_rows();
std::vector<CommandRow> edit_rows();
std::vector<CommandRow> view_rows();
std::vector<CommandRow> transport_rows();
std::vector<CommandRow> help_rows();

/// Why nothing can be done with the selected demonstration or model; "" if it can.
std::string no_demonstration(const WorkbenchState& state);
std::string no_model(const WorkbenchState& state);

inline Requests one(Request request) {
  return {std::move(request)};
}

template <UiAction action>
Requests act(const WorkbenchState&) {
  return {action};
}

template <PanelId panel>
Requests show(const WorkbenchState&) {
  return {ShowPanel{panel}};
}

}  // namespace trocar::ui
