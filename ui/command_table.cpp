#include "ui/command_table.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/core/check.h"
#include "ui/command_rows.h"
#include "ui/format.h"

namespace trocar::ui {
namespace {

using State = WorkbenchState;

std::vector<CommandRow> make_table() {
  std::vector<CommandRow> table;
  for (const auto rows : {file_rows(), undo_rows(), clipboard_rows(), edit_rows(), modify_rows(), record_rows(),
                          trial_rows(), film_rows(), review_rows(), selection_rows(), tool_rows(), view_rows(),
                          panel_rows(), layout_rows(), transport_rows(), help_rows()}) {
    for (const RowData& row : rows) {
      table.push_back(
          {row.id, row.menu, row.title, row.help, row.icon, {}, row.separator, row.context, row.reason, row.run});
      for (const std::string_view keys : row.keys) {
        if (!keys.empty()) table.back().keys.push_back(keys);
      }
    }
  }
  return table;
}

// 0: not found. A title that begins with the words wins over one that has them, over menu and help.
int rank(const CommandRow& row, const std::vector<std::string>& words) {
  const std::string title = lower_case(row.title);
  const std::string all = title + " " + lower_case(row.menu) + " " + lower_case(row.help);
  int score = 1;
  for (const std::string& word : words) {
    if (all.find(word) == std::string::npos) return 0;
    if (title.find(word) != std::string::npos) score += 10;
    if (title.starts_with(word)) score += 10;
  }
  return score;
}

}  // namespace

std::span<const std::string_view> command_menus() {
  static constexpr std::array<std::string_view, 11> kMenus{"File", "Edit",   "Modify", "Label",     "Select", "Tool",
                                                           "View", "Panels", "Layout", "Transport", "Help"};
  return kMenus;
}

std::string_view menu_above(std::string_view menu) {
  return menu == "Panels" || menu == "Layout" ? "View" : "";
}

const std::vector<CommandRow>& command_table() {
  static const std::vector<CommandRow> table = make_table();
  return table;
}

const CommandRow& command(std::string_view id) {
  const auto& table = command_table();
  const auto found = std::find_if(table.begin(), table.end(), [id](const CommandRow& row) { return row.id == id; });
  TROCAR_CHECK(found != table.end());
  return *found;
}

std::vector<const CommandRow*> search_commands(std::string_view typed) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : lower_case(typed) + " ") {
    if (c != ' ') {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::exchange(word, {}));
    }
  }
  std::vector<std::pair<int, const CommandRow*>> ranked;
  for (const CommandRow& row : command_table()) {
    if (const int score = rank(row, words); score > 0) ranked.emplace_back(-score, &row);
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const CommandRow*> rows;
  rows.reserve(ranked.size());
  for (const auto& [score, row] : ranked) rows.push_back(row);
  return rows;
}

std::shared_ptr<const demonstration::Demonstration> selected_demonstration(const State& state) {
  if (state.project == nullptr) return nullptr;
  const auto found = state.project->demonstrations.find(state.demonstration);
  if (found != state.project->demonstrations.end()) return found->second;
  const auto trial = selected_trial(state);
  return trial == nullptr ? nullptr : trial->shown;
}

std::shared_ptr<const workbench::TrialEntry> selected_trial(const State& state) {
  if (state.project == nullptr) return nullptr;
  const auto found = state.project->trials.find(workbench::TrialId{state.demonstration.value});
  return found == state.project->trials.end() ? nullptr : found->second;
}

std::shared_ptr<const workbench::ModelEntry> selected_model(const State& state) {
  if (state.project == nullptr) return nullptr;
  const auto found = state.project->models.find(state.model);
  return found == state.project->models.end() ? nullptr : found->second;
}

std::string no_demonstration(const State& state) {
  if (state.project == nullptr) return "No project is open";
  return selected_demonstration(state) == nullptr ? "No demonstration is selected" : "";
}

std::string no_model(const State& state) {
  if (state.project == nullptr) return "No project is open";
  return selected_model(state) == nullptr ? "No model is selected" : "";
}

}  // namespace trocar::ui
