/// What a panel asks for: commands of the workbench, or acts of the window itself.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "engine/workbench/command.h"
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
  kShowPalette,
  kShowShortcuts,
  kShowAbout,
  kScaleUp,
  kScaleDown,
  kScaleReset,
  kSwitchTheme,
  kResetLayout,
  kMaximise,
  kCopyCommand,
};
/// Brings a panel to the front of its tile.
struct ShowPanel {
  PanelId panel = PanelId::kLibrary;
};
struct ShowWorkspace {
  Workspace workspace = Workspace::kAuthor;
};
/// Opens the form of an edit, at what is selected or where the playhead is.
struct BeginEdit {
  demonstration::Edit edit;
};
/// Puts words on the clipboard.
struct CopyText {
  std::string text;
};

using Request = std::variant<workbench::Command, UiAction, ShowPanel, ShowWorkspace, BeginEdit, CopyText>;
using Requests = std::vector<Request>;

}  // namespace trocar::ui
