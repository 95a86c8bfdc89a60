// Rows about the tiles: open panels, move them, put sides of the window away, keep layouts.
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "ui/command_rows.h"
#include "ui/format.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

RowData layout_row(std::string_view id, std::string_view title, std::string_view help, const char* icon,
                   std::string_view keys, bool separator, Requests (*run)(const WorkbenchState&)) {
  return {id, "Layout", title, help, icon, {keys}, separator, nullptr, run};
}

const std::vector<RowData>& made_layout_rows() {
  static const std::vector<RowData> rows{
      layout_row("layout.named", "Layouts…", "Keep this layout by a name, or go to another", icon::kThLarge,
                 "Ctrl+Shift+P", false, act<UiAction::kShowLayouts>),
      layout_row("view.reset_layout", "Reset layout", "Put the panels of this workspace back in their places", nullptr,
                 "", false, act<UiAction::kResetLayout>),
      layout_row("layout.undo", "Undo layout", "Take back what was last done to the tiles", icon::kUndo, "Ctrl+Alt+U",
                 true, act<UiAction::kUndoLayout>),
      layout_row("layout.redo", "Redo layout", "Do it to the tiles again", icon::kRedo, "Ctrl+Shift+Alt+U", false,
                 act<UiAction::kRedoLayout>),
      layout_row("layout.hide_left", "Left side", "Put the left side of the window away, or show it again", nullptr,
                 "F9", true, act<UiAction::kHideLeft>),
      layout_row("layout.hide_right", "Right side", "Put the right side of the window away, or show it again", nullptr,
                 "F10", false, act<UiAction::kHideRight>),
      layout_row("layout.move_left", "Move panel left", "Into the tile on the left, or a new one at the edge", nullptr,
                 "Ctrl+Shift+Alt+Left", true, move_panel<Side::kLeft>),
      layout_row("layout.move_right", "Move panel right", "Into the tile on the right, or a new one at the edge",
                 nullptr, "Ctrl+Shift+Alt+Right", false, move_panel<Side::kRight>),
      layout_row("layout.move_up", "Move panel up", "Into the tile above, or a new one at the edge", nullptr,
                 "Ctrl+Shift+Alt+Up", false, move_panel<Side::kUp>),
      layout_row("layout.move_down", "Move panel down", "Into the tile below, or a new one at the edge", nullptr,
                 "Ctrl+Shift+Alt+Down", false, move_panel<Side::kDown>),
      layout_row("layout.equalise", "Equalise tiles", "Make the tiles beside or above each other equally large",
                 nullptr, "", false, act<UiAction::kEqualise>),
      layout_row("layout.close_panel", "Close panel", "Take the panel under the pointer away; the menu Panels opens it",
                 icon::kCross, "Ctrl+W", true, act<UiAction::kClosePanel>)};
  return rows;
}

/// The words of a row for each panel, which live as long as the program.
struct PanelWords {
  std::string id;
  std::string title;
  std::string help;
};

PanelWords words_of(PanelId panel) {
  const std::string name(title(panel));
  return {"panel." + lower_case(name), name + " panel",
          "Bring the panel " + name + " to the front; open it if it was closed"};
}

template <std::size_t... i>
std::vector<RowData> rows_for(const std::array<PanelWords, kPanelCount>& words, std::index_sequence<i...>) {
  return {RowData{words[i].id,
                  "Panels",
                  words[i].title,
                  words[i].help,
                  icon_of(static_cast<PanelId>(i)),
                  {},
                  false,
                  nullptr,
                  show<static_cast<PanelId>(i)>}...};
}

template <std::size_t... i>
std::array<PanelWords, kPanelCount> all_words(std::index_sequence<i...>) {
  return {words_of(static_cast<PanelId>(i))...};
}

}  // namespace

std::span<const RowData> panel_rows() {
  constexpr auto kAll = std::make_index_sequence<kPanelCount>();
  static const std::array<PanelWords, kPanelCount> words = all_words(kAll);
  static const std::vector<RowData> rows = rows_for(words, kAll);
  return rows;
}

std::span<const RowData> layout_rows() {
  return made_layout_rows();
}

}  // namespace trocar::ui
