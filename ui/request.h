/// What a panel asks for: commands of the workbench, or acts of the window itself.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "engine/workbench/command.h"
#include "ui/keymap.h"
#include "ui/layouts.h"
#include "ui/tile_moves.h"
#include "ui/tile_tree.h"

namespace trocar::ui {

enum class UiAction {
  kNewProject,
  kOpenProject,
  kQuit,  ///< Asks first if something would be cut off.
  kQuitNow,
  kShowRecord,
  kShowImport,
  kShowExportDemonstrations,
  kShowExportVideo,
  kShowExportField,
  kShowExportPlot,
  kShowImportTable,
  kShowPalette,
  kShowShortcuts,
  kShowAbout,
  kScaleUp,
  kScaleDown,
  kScaleReset,
  kSwitchTheme,
  kFrameRate,
  kNextRuler,
  kResetLayout,
  kMaximise,
  kCopyCommand,
  kShowKeys,
  kShowHelp,  ///< Of the panel under the pointer.
  kShowLayouts,
  kUndoLayout,
  kRedoLayout,
  kClosePanel,
  kEqualise,
  kHideLeft,
  kHideRight,
};
/// Brings a panel to the front of its tile; opens it if it was closed.
struct ShowPanel {
  PanelId panel = PanelId::kLibrary;
};
struct ShowWorkspace {
  Workspace workspace = Workspace::kAuthor;
};
/// Which keys mean what, from now on.
struct ChooseKeys {
  KeyChoices keys;
};
/// Puts the panel under the pointer, or the one that the keyboard is in, into another tile.
struct MovePanel {
  Side side = Side::kLeft;
};
/// The tiles of the workspace from now on.
struct Arrange {
  Tile layout;
};
/// The layouts that are kept by name, of the workspace.
struct KeepLayouts {
  std::vector<NamedLayout> layouts;
};
/// Opens the form of an edit, at what is selected or where the playhead is.
struct BeginEdit {
  demonstration::Edit edit;
  int copies = 0;  ///< Not 0: so many copies get it, and the demonstration stays as it is.
};
/// Opens the form that writes a figure, at what a panel shows.
struct ShowPlotForm {
  workbench::PlotSettings settings;
};
/// Puts words on the clipboard.
struct CopyText {
  std::string text;
};

using Request = std::variant<workbench::Command, UiAction, ShowPanel, ShowWorkspace, ChooseKeys, MovePanel, Arrange,
                             KeepLayouts, BeginEdit, ShowPlotForm, CopyText>;
using Requests = std::vector<Request>;

}  // namespace trocar::ui
