#include "ui/command_rows.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using namespace workbench;
using State = WorkbenchState;

template <Workspace workspace>
Requests switch_workspace(const State&) {
  return {ShowWorkspace{workspace}};
}

template <scene::CameraPreset preset>
Requests look_from(const State&) {
  return one(Command{SetCameraPreset{preset}});
}

Requests ghosts(const State& state) {
  RolloutSettings settings = state.rollouts;
  settings.ghosts = !settings.ghosts;
  return one(Command{SetRollouts{settings}});
}

Requests field_visible(const State& state) {
  FieldSettings settings = state.field;
  settings.visible = !shows_field(settings);
  // Nothing of it was chosen yet: the slice through the goal is what one looks for first.
  if (settings.visible && !shows_field(settings)) {
    const bool known = state.insight && state.insight->entry != nullptr;
    const learning::Model* model = known ? state.insight->entry->model.get() : nullptr;
    settings.slices[2] = model == nullptr ? spatial::Grid().n / 2 : model->grid.coordinates(model->goal).z;
  }
  return one(Command{SetField{settings}});
}

std::string no_comparison(const State& state) {
  return state.comparing ? "" : "Compare with something first, in the panel Diff";
}

Requests comparison_in_view(const State& state) {
  ComparisonSettings settings = *state.comparing;
  settings.in_view = !settings.in_view;
  return one(Command{CompareWith{settings}});
}

constexpr std::array<RowData, 21> kViewRows{{
    {"view.library",
     "View",
     "Library workspace",
     "Demonstrations and models at full width",
     nullptr,
     {"Ctrl+1"},
     false,
     nullptr,
     switch_workspace<Workspace::kLibrary>},
    {"view.author",
     "View",
     "Author workspace",
     "View and timeline to record and edit",
     nullptr,
     {"Ctrl+2"},
     false,
     nullptr,
     switch_workspace<Workspace::kAuthor>},
    {"view.fields",
     "View",
     "Fields workspace",
     "What was learned, cell by cell",
     nullptr,
     {"Ctrl+3"},
     false,
     nullptr,
     switch_workspace<Workspace::kFields>},
    {"view.rollouts",
     "View",
     "Rollouts workspace",
     "What the agent does from perturbed starts",
     nullptr,
     {"Ctrl+4"},
     false,
     nullptr,
     switch_workspace<Workspace::kRollouts>},
    {"view.trials",
     "View",
     "Trials workspace",
     "Manual against shared control, run and compared",
     nullptr,
     {"Ctrl+5"},
     false,
     nullptr,
     switch_workspace<Workspace::kTrials>},
    {"view.export",
     "View",
     "Export workspace",
     "Films: composed, looked at, and rendered in a queue",
     nullptr,
     {"Ctrl+6"},
     false,
     nullptr,
     switch_workspace<Workspace::kExport>},
    {"view.camera_paper",
     "View",
     "Paper camera",
     "The view of the paper's figures",
     icon::kCamera,
     {"Alt+1"},
     true,
     nullptr,
     look_from<scene::CameraPreset::kPaper>},
    {"view.camera_top",
     "View",
     "Top camera",
     "Straight down",
     icon::kCamera,
     {"Alt+2"},
     false,
     nullptr,
     look_from<scene::CameraPreset::kTop>},
    {"view.camera_side",
     "View",
     "Side camera",
     "Along y",
     icon::kCamera,
     {"Alt+3"},
     false,
     nullptr,
     look_from<scene::CameraPreset::kSide>},
    {"view.camera_front",
     "View",
     "Front camera",
     "Along x",
     icon::kCamera,
     {"Alt+4"},
     false,
     nullptr,
     look_from<scene::CameraPreset::kFront>},
    {"view.field",
     "View",
     "Field in the view",
     "Show or hide the field in the 3-D view",
     icon::kThLarge,
     {"Shift+F"},
     true,
     no_model,
     field_visible},
    {"view.ghosts",
     "View",
     "Ghosts in the view",
     "Show or hide the agent's paths in the 3-D view",
     icon::kRoad,
     {"Alt+G"},
     false,
     no_model,
     ghosts},
    {"view.curves",
     "View",
     "Show curves",
     "Bring position, speed, acceleration, jerk and jaw over time to the front",
     icon::kChart,
     {},
     false,
     no_demonstration,
     show<PanelId::kCurves>},
    {"view.diff",
     "View",
     "Show differences",
     "Compare the demonstration with its original, its past or another one",
     icon::kBranch,
     {},
     false,
     no_demonstration,
     show<PanelId::kDiff>},
    {"view.comparison",
     "View",
     "Differences in the view",
     "Draw or hide the path that the demonstration is compared with, and how far the tools are from it",
     icon::kEye,
     {"Shift+G"},
     false,
     no_comparison,
     comparison_in_view},
    {"view.scale_up",
     "View",
     "Larger text",
     "Scale everything up, to 300 % at most",
     nullptr,
     {"Ctrl+="},
     true,
     nullptr,
     act<UiAction::kScaleUp>},
    {"view.scale_down",
     "View",
     "Smaller text",
     "Scale everything down, to 75 % at least",
     nullptr,
     {"Ctrl+-"},
     false,
     nullptr,
     act<UiAction::kScaleDown>},
    {"view.scale_reset",
     "View",
     "Normal text",
     "Scale to 100 %",
     nullptr,
     {"Ctrl+0"},
     false,
     nullptr,
     act<UiAction::kScaleReset>},
    {"view.theme",
     "View",
     "Switch theme",
     "Dark, light, high contrast",
     icon::kAdjust,
     {},
     false,
     nullptr,
     act<UiAction::kSwitchTheme>},
    {"view.frame_rate",
     "View",
     "Frames per second",
     "Say in the menu bar how often the window is drawn; while nothing changes it is not",
     nullptr,
     {},
     false,
     nullptr,
     act<UiAction::kFrameRate>},
    {"view.maximise",
     "View",
     "Maximise panel",
     "Give the panel under the pointer the whole window, or its place back",
     icon::kExpand,
     {"Ctrl+Space"},
     true,
     nullptr,
     act<UiAction::kMaximise>},
}};

constexpr std::array<RowData, 7> kHelpRows{{
    {"help.page",
     "Help",
     "Help on this panel",
     "What the panel under the pointer is for, and all of its commands",
     icon::kBook,
     {"F1"},
     false,
     nullptr,
     act<UiAction::kShowHelp>},
    {"help.palette",
     "Help",
     "Command palette…",
     "Find any command by its name",
     icon::kSearch,
     {"Ctrl+P", "Ctrl+K"},
     false,
     nullptr,
     act<UiAction::kShowPalette>},
    {"help.shortcuts",
     "Help",
     "Keyboard shortcuts…",
     "Every key there is",
     icon::kKeyboard,
     {"Shift+/"},
     false,
     nullptr,
     act<UiAction::kShowShortcuts>},
    {"help.keys",
     "Help",
     "Change keys…",
     "Give commands other keys, or those of another program",
     icon::kPencil,
     {},
     false,
     nullptr,
     act<UiAction::kShowKeys>},
    {"help.copy_command",
     "Help",
     "Copy last command",
     "Copy the last act as a command line",
     icon::kCopy,
     {"Ctrl+Shift+C"},
     false,
     nullptr,
     act<UiAction::kCopyCommand>},
    {"help.log",
     "Help",
     "Show log",
     "Bring the log to the front",
     icon::kList,
     {},
     false,
     nullptr,
     show<PanelId::kLog>},
    {"help.about",
     "Help",
     "About Trocar…",
     "Version and what it stands on",
     icon::kInfo,
     {},
     false,
     nullptr,
     act<UiAction::kShowAbout>},
}};

}  // namespace

std::span<const RowData> view_rows() {
  return kViewRows;
}

std::span<const RowData> help_rows() {
  return kHelpRows;
}

}  // namespace trocar::ui
