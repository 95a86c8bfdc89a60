/// Every act of the window as one row: menus, toolbar, palette, keys and the shortcut sheet are made from this table.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/workbench/workbench.h"
#include "ui/keymap.h"
#include "ui/request.h"

namespace trocar::ui {

using workbench::WorkbenchState;

struct CommandRow {
  std::string_view id;     ///< "edit.undo": for settings and documents; never changes.
  std::string_view menu;   ///< One of `command_menus`.
  std::string_view title;  ///< "Undo"
  std::string_view help;
  const char* icon = nullptr;
  std::vector<std::string_view> keys;  ///< To begin with; see `Keymap` for those that hold.
  bool separator = false;              ///< A line above it in the menu.
  std::string_view context;            ///< "": its keys always mean it; else only in that context, and first.
  /// Why it cannot be done now; "" if it can. Null: it always can.
  std::string (*reason)(const WorkbenchState&) = nullptr;
  Requests (*run)(const WorkbenchState&) = nullptr;

  std::string reason_now(const WorkbenchState& state) const {
    return reason == nullptr ? std::string() : reason(state);
  }
};

/// The names that rows have as their menu, in order: those of the menu bar, "Panels" and "Layout" being menus of View.
std::span<const std::string_view> command_menus();
/// The menu that a menu is in; "" for the menu bar.
std::string_view menu_above(std::string_view menu);

/// The whole table, in the order of the menus.
const std::vector<CommandRow>& command_table();
/// Precondition: there is such a row.
const CommandRow& command(std::string_view id);

/// The rows that the palette offers for what was typed, best first: every word must be found in title, menu or help.
std::vector<const CommandRow*> search_commands(std::string_view typed);

/// The selected demonstration or model; null if there is none. What was recorded of a trial is looked at as a
/// demonstration, but not edited: then `selected_trial` is it.
std::shared_ptr<const demonstration::Demonstration> selected_demonstration(const WorkbenchState& state);
std::shared_ptr<const workbench::TrialEntry> selected_trial(const WorkbenchState& state);
std::shared_ptr<const workbench::ModelEntry> selected_model(const WorkbenchState& state);

}  // namespace trocar::ui
