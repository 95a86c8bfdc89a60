#include "ui/command_table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "engine/core/check.h"
#include "ui/icons.h"
#include "ui/idle.h"
#include "ui/timeline_steps.h"

namespace trocar::ui {
namespace {

using namespace workbench;
using State = WorkbenchState;

Requests one(Request request) {
  return {std::move(request)};
}

template <UiAction action>
Requests act(const State&) {
  return {action};
}

template <PanelId panel>
Requests show(const State&) {
  return {ShowPanel{panel}};
}

template <Workspace workspace>
Requests workspace_(const State&) {
  return {ShowWorkspace{workspace}};
}

template <scene::CameraPreset preset>
Requests camera_(const State&) {
  return one(Command{SetCameraPreset{preset}});
}

std::string no_demonstration(const State& state) {
  if (state.project == nullptr) return "No project is open";
  return selected_demonstration(state) == nullptr ? "No demonstration is selected" : "";
}

std::string no_model(const State& state) {
  if (state.project == nullptr) return "No project is open";
  return selected_model(state) == nullptr ? "No model is selected" : "";
}

std::string cannot_record(const State& state) {
  if (state.project == nullptr) return "No project is open";
  return state.live ? "A transfer is being recorded" : "";
}

std::string cannot_edit(const State& state) {
  return state.live ? "A transfer is being recorded" : no_demonstration(state);
}

std::string cannot_stop(const State& state) {
  return state.live ? "" : "Nothing is being recorded";
}

std::string cannot_undo(const State& state) {
  return state.undoable ? "" : "Nothing to undo";
}

std::string cannot_redo(const State& state) {
  return state.redoable ? "" : "Nothing to redo";
}

std::string cannot_train(const State& state) {
  if (state.project == nullptr) return "No project is open";
  return state.project->demonstrations.empty() ? "There is no demonstration to learn from" : "";
}

std::string cannot_trim_idle(const State& state) {
  if (std::string reason = cannot_edit(state); !reason.empty()) return reason;
  return idle_trim(*selected_demonstration(state)) ? "" : "Both ends move: there is nothing idle to trim";
}

Requests undo(const State&) {
  return one(Command{Undo{}});
}

Requests redo(const State&) {
  return one(Command{Redo{}});
}

Requests trim(const State& state, double from_s, double to_s) {
  return one(Command{CommitEdit{EditDemonstration{state.demonstration, demonstration::Trim{from_s, to_s}}}});
}

Requests trim_in(const State& state) {
  return trim(state, state.playhead_s, selected_demonstration(state)->end_s);
}

Requests trim_out(const State& state) {
  return trim(state, selected_demonstration(state)->begin_s, state.playhead_s);
}

Requests trim_idle(const State& state) {
  const auto gates = idle_trim(*selected_demonstration(state));
  return gates ? trim(state, gates->from_s, gates->to_s) : Requests{};
}

Requests remove_demonstration(const State& state) {
  return one(Command{CommitEdit{RemoveDemonstration{state.demonstration}}});
}

Requests remove_model(const State& state) {
  return one(Command{CommitEdit{RemoveModel{state.model}}});
}

Requests verify(const State& state) {
  return one(Command{VerifyReplay{state.demonstration}});
}

Requests stop_recording(const State&) {
  return one(Command{StopRecording{true}});
}

Requests discard_recording(const State&) {
  return one(Command{StopRecording{false}});
}

Requests play(const State& state) {
  return one(Command{Play{state.play_speed == 0.0 ? 1.0 : 0.0}});
}

template <int steps>
Requests step_samples(const State& state) {
  return one(Command{SetPlayhead{stepped(*selected_demonstration(state), state.playhead_s, steps)}});
}

template <int direction>
Requests step_marker(const State& state) {
  return one(Command{SetPlayhead{next_boundary(*selected_demonstration(state), state.playhead_s, direction)}});
}

Requests to_begin(const State& state) {
  return one(Command{SetPlayhead{selected_demonstration(state)->begin_s}});
}

Requests to_end(const State& state) {
  return one(Command{SetPlayhead{selected_demonstration(state)->end_s}});
}

Requests ghosts(const State& state) {
  RolloutSettings settings = state.rollouts;
  settings.ghosts = !settings.ghosts;
  return one(Command{SetRollouts{settings}});
}

Requests field_visible(const State& state) {
  FieldSettings settings = state.field;
  settings.visible = !settings.visible;
  return one(Command{SetField{settings}});
}

std::vector<CommandRow> file_rows() {
  return {
      {"file.new",
       "File",
       "New project…",
       "Make an empty project file with the standard board",
       icon::kFile,
       {"Ctrl+N"},
       false,
       nullptr,
       act<UiAction::kNewProject>},
      {"file.open",
       "File",
       "Open project…",
       "Open a project file",
       icon::kFolder,
       {"Ctrl+O"},
       false,
       nullptr,
       act<UiAction::kOpenProject>},
      {"file.export_video",
       "File",
       "Export video…",
       "Film the selected demonstration",
       icon::kFilm,
       {"Ctrl+E"},
       true,
       no_demonstration,
       act<UiAction::kShowExportVideo>},
      {"file.export_field",
       "File",
       "Export field…",
       "Write the shown field as a figure or as numbers",
       icon::kDownload,
       {"Ctrl+Shift+E"},
       false,
       no_model,
       act<UiAction::kShowExportField>},
      {"file.quit",
       "File",
       "Quit",
       "Close the window; all work is already saved",
       nullptr,
       {"Ctrl+Q"},
       true,
       nullptr,
       act<UiAction::kQuit>},
  };
}

std::vector<CommandRow> edit_rows() {
  return {
      {"edit.undo",
       "Edit",
       "Undo",
       "Go back one step in the history",
       icon::kUndo,
       {"Ctrl+Z"},
       false,
       cannot_undo,
       undo},
      {"edit.redo",
       "Edit",
       "Redo",
       "Go forward one step in the history",
       icon::kRedo,
       {"Ctrl+Shift+Z", "Ctrl+Y"},
       false,
       cannot_redo,
       redo},
      {"edit.trim_in",
       "Edit",
       "Trim in at playhead",
       "Leave out what is before the playhead; the recording keeps it",
       icon::kCut,
       {"I"},
       true,
       cannot_edit,
       trim_in},
      {"edit.trim_out",
       "Edit",
       "Trim out at playhead",
       "Leave out what is after the playhead; the recording keeps it",
       icon::kCut,
       {"O"},
       false,
       cannot_edit,
       trim_out},
      {"edit.trim_idle",
       "Edit",
       "Trim idle",
       "Leave out both ends where no arm moves",
       icon::kCut,
       {"Ctrl+Shift+T"},
       false,
       cannot_trim_idle,
       trim_idle},
      {"edit.remove_demonstration",
       "Edit",
       "Delete demonstration",
       "Take the selected demonstration out of the project; undo brings it back",
       icon::kTrash,
       {"Delete"},
       true,
       cannot_edit,
       remove_demonstration},
      {"edit.remove_model",
       "Edit",
       "Delete model",
       "Take the selected model out of the project; undo brings it back",
       icon::kTrash,
       {"Shift+Delete"},
       false,
       no_model,
       remove_model},
      {"demo.record",
       "Edit",
       "Record…",
       "Let the scripted operators carry out a transfer in the simulator and record it",
       icon::kRecord,
       {"R"},
       true,
       cannot_record,
       act<UiAction::kShowRecord>},
      {"demo.stop",
       "Edit",
       "Stop and keep",
       "End the recording and put it into the project",
       icon::kStop,
       {"Shift+R"},
       false,
       cannot_stop,
       stop_recording},
      {"demo.discard",
       "Edit",
       "Stop and discard",
       "End the recording and throw it away",
       icon::kCross,
       {"Shift+Backspace"},
       false,
       cannot_stop,
       discard_recording},
      {"demo.verify",
       "Edit",
       "Verify replay",
       "Simulate the recorded input again and compare every state hash",
       icon::kVerify,
       {"Ctrl+R"},
       false,
       no_demonstration,
       verify},
      {"model.train",
       "Edit",
       "Train…",
       "Learn from demonstrations",
       icon::kTrain,
       {"T"},
       false,
       cannot_train,
       show<PanelId::kTrain>},
  };
}

std::vector<CommandRow> view_rows() {
  return {
      {"view.library",
       "View",
       "Library workspace",
       "Demonstrations and models at full width",
       nullptr,
       {"Ctrl+1"},
       false,
       nullptr,
       workspace_<Workspace::kLibrary>},
      {"view.author",
       "View",
       "Author workspace",
       "View and timeline to record and edit",
       nullptr,
       {"Ctrl+2"},
       false,
       nullptr,
       workspace_<Workspace::kAuthor>},
      {"view.fields",
       "View",
       "Fields workspace",
       "What was learned, cell by cell",
       nullptr,
       {"Ctrl+3"},
       false,
       nullptr,
       workspace_<Workspace::kFields>},
      {"view.rollouts",
       "View",
       "Rollouts workspace",
       "What the agent does from perturbed starts",
       nullptr,
       {"Ctrl+4"},
       false,
       nullptr,
       workspace_<Workspace::kRollouts>},
      {"view.camera_paper",
       "View",
       "Paper camera",
       "The view of the paper's figures",
       icon::kCamera,
       {"Alt+1"},
       true,
       nullptr,
       camera_<scene::CameraPreset::kPaper>},
      {"view.camera_top",
       "View",
       "Top camera",
       "Straight down",
       icon::kCamera,
       {"Alt+2"},
       false,
       nullptr,
       camera_<scene::CameraPreset::kTop>},
      {"view.camera_side",
       "View",
       "Side camera",
       "Along y",
       icon::kCamera,
       {"Alt+3"},
       false,
       nullptr,
       camera_<scene::CameraPreset::kSide>},
      {"view.camera_front",
       "View",
       "Front camera",
       "Along x",
       icon::kCamera,
       {"Alt+4"},
       false,
       nullptr,
       camera_<scene::CameraPreset::kFront>},
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
       {"G"},
       false,
       no_model,
       ghosts},
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
       "Dark or light",
       icon::kAdjust,
       {},
       false,
       nullptr,
       act<UiAction::kSwitchTheme>},
      {"view.maximise",
       "View",
       "Maximise panel",
       "Give the panel under the pointer the whole window, or its place back",
       icon::kExpand,
       {"Ctrl+Space"},
       true,
       nullptr,
       act<UiAction::kMaximise>},
      {"view.reset_layout",
       "View",
       "Reset layout",
       "Put the panels of this workspace back in their places",
       nullptr,
       {},
       false,
       nullptr,
       act<UiAction::kResetLayout>},
  };
}

std::vector<CommandRow> transport_rows() {
  return {
      {"transport.play",
       "Transport",
       "Play or pause",
       "Run the playhead in real time",
       icon::kPlay,
       {"Space"},
       false,
       no_demonstration,
       play},
      {"transport.forward",
       "Transport",
       "One sample forward",
       "5 ms",
       nullptr,
       {"Right"},
       false,
       no_demonstration,
       step_samples<1>},
      {"transport.back",
       "Transport",
       "One sample back",
       "5 ms",
       nullptr,
       {"Left"},
       false,
       no_demonstration,
       step_samples<-1>},
      {"transport.forward_10",
       "Transport",
       "Ten samples forward",
       "50 ms",
       nullptr,
       {"Shift+Right"},
       false,
       no_demonstration,
       step_samples<10>},
      {"transport.back_10",
       "Transport",
       "Ten samples back",
       "50 ms",
       nullptr,
       {"Shift+Left"},
       false,
       no_demonstration,
       step_samples<-10>},
      {"transport.next_segment",
       "Transport",
       "Next segment",
       "To the next beginning of a segment",
       nullptr,
       {"Ctrl+Right"},
       false,
       no_demonstration,
       step_marker<1>},
      {"transport.last_segment",
       "Transport",
       "Previous segment",
       "To the beginning of a segment before",
       nullptr,
       {"Ctrl+Left"},
       false,
       no_demonstration,
       step_marker<-1>},
      {"transport.begin",
       "Transport",
       "To the beginning",
       "To the in gate",
       icon::kToBegin,
       {"Home"},
       false,
       no_demonstration,
       to_begin},
      {"transport.end",
       "Transport",
       "To the end",
       "To the out gate",
       icon::kToEnd,
       {"End"},
       false,
       no_demonstration,
       to_end},
  };
}

std::vector<CommandRow> help_rows() {
  return {
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
       {"F1", "Shift+/"},
       false,
       nullptr,
       act<UiAction::kShowShortcuts>},
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
  };
}

std::vector<CommandRow> make_table() {
  std::vector<CommandRow> table;
  for (std::vector<CommandRow> rows : {file_rows(), edit_rows(), view_rows(), transport_rows(), help_rows()}) {
    for (CommandRow& row : rows) table.push_back(std::move(row));
  }
  return table;
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// 0: not found. A title that begins with the words wins over one that has them, over menu and help.
int rank(const CommandRow& row, const std::vector<std::string>& words) {
  const std::string title = lower(row.title);
  const std::string all = title + " " + lower(row.menu) + " " + lower(row.help);
  int score = 1;
  for (const std::string& word : words) {
    if (all.find(word) == std::string::npos) return 0;
    if (title.find(word) != std::string::npos) score += 10;
    if (title.starts_with(word)) score += 10;
  }
  return score;
}

}  // namespace

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
  for (const char c : lower(typed) + " ") {
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
  for (const auto& [score, row] : ranked) rows.push_back(row);
  return rows;
}

std::shared_ptr<const demonstration::Demonstration> selected_demonstration(const State& state) {
  if (state.project == nullptr) return nullptr;
  const auto found = state.project->demonstrations.find(state.demonstration);
  return found == state.project->demonstrations.end() ? nullptr : found->second;
}

std::shared_ptr<const workbench::ModelEntry> selected_model(const State& state) {
  if (state.project == nullptr) return nullptr;
  const auto found = state.project->models.find(state.model);
  return found == state.project->models.end() ? nullptr : found->second;
}

}  // namespace trocar::ui
