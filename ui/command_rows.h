/// The rows of the command table by menu; only `command_table` gathers them.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "ui/command_table.h"

namespace trocar::ui {

/// A row as constant data; empty keys do not count.
struct RowData {
  std::string_view id;
  std::string_view menu;
  std::string_view title;
  std::string_view help;
  const char* icon = nullptr;
  std::array<std::string_view, 2> keys;
  bool separator = false;
  std::string (*reason)(const WorkbenchState&) = nullptr;
  Requests (*run)(const WorkbenchState&) = nullptr;
  std::string_view context = "";
};

std::span<const RowData> file_rows();
std::span<const RowData> film_rows();
std::span<const RowData> undo_rows();
std::span<const RowData> clipboard_rows();
std::span<const RowData> edit_rows();
std::span<const RowData> modify_rows();
std::span<const RowData> record_rows();
std::span<const RowData> trial_rows();
std::span<const RowData> selection_rows();
std::span<const RowData> review_rows();
std::span<const RowData> tool_rows();
std::span<const RowData> view_rows();
std::span<const RowData> panel_rows();
std::span<const RowData> layout_rows();
std::span<const RowData> transport_rows();
std::span<const RowData> help_rows();

/// Why nothing of the project can be changed now; "" if it can.
std::string cannot_change(const WorkbenchState& state);
/// Why nothing can be recorded or taken in from elsewhere now; "" if it can.
std::string cannot_record(const WorkbenchState& state);
/// Why nothing can be done with the selected demonstration or model; "" if it can.
std::string no_demonstration(const WorkbenchState& state);
std::string no_model(const WorkbenchState& state);
/// Why the selected demonstration cannot be edited now; "" if it can.
std::string cannot_edit(const WorkbenchState& state);

/// Half a sample, in seconds: nothing lies between.
constexpr double kSameTime_s = 0.0025;

/// Commits an edit of the selected demonstration.
Requests change(const WorkbenchState& state, demonstration::Edit edit);

inline Requests one(Request request) {
  return {std::move(request)};
}

template <UiAction action>
Requests act(const WorkbenchState&) {
  return {action};
}

template <Side side>
Requests move_panel(const WorkbenchState&) {
  return {MovePanel{side}};
}

template <PanelId panel>
Requests show(const WorkbenchState&) {
  return {ShowPanel{panel}};
}

}  // namespace trocar::ui
