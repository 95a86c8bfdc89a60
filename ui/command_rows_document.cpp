#include "ui/command_rows.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

using namespace workbench;
using State = WorkbenchState;

std::string cannot_open(const State& state) {
  return state.live ? "A transfer is being recorded" : "";
}

std::string cannot_trim_in(const State& state) {
  if (std::string reason = cannot_edit(state); !reason.empty()) return reason;
  const bool there = state.playhead_s - selected_demonstration(state)->begin_s < kSameTime_s;
  return there ? "It begins at the playhead already" : "";
}

std::string cannot_trim_out(const State& state) {
  if (std::string reason = cannot_edit(state); !reason.empty()) return reason;
  const bool there = selected_demonstration(state)->end_s - state.playhead_s < kSameTime_s;
  return there ? "It ends at the playhead already" : "";
}

std::string cannot_move_in_history(const State& state) {
  if (std::string reason = cannot_change(state); !reason.empty()) return reason;
  // An edit would land on the line that the recording does not know of.
  return state.live ? "A transfer is being recorded" : "";
}

std::string cannot_undo(const State& state) {
  if (std::string reason = cannot_move_in_history(state); !reason.empty()) return reason;
  return state.undoable ? "" : "Nothing to undo";
}

std::string cannot_redo(const State& state) {
  if (std::string reason = cannot_move_in_history(state); !reason.empty()) return reason;
  return state.redoable ? "" : "Nothing to redo";
}

std::string cannot_remove_model(const State& state) {
  const std::string reason = cannot_change(state);
  return reason.empty() ? no_model(state) : reason;
}

std::string cannot_train(const State& state) {
  if (std::string reason = cannot_change(state); !reason.empty()) return reason;
  return state.project->demonstrations.empty() ? "There is no demonstration to learn from" : "";
}

Requests undo(const State&) {
  return one(Command{Undo{}});
}

Requests checkpoint(const State& state) {
  return one(Command{NameCheckpoint{state.head, {}}});
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

std::string cannot_clear_gates(const State& state) {
  if (std::string reason = cannot_edit(state); !reason.empty()) return reason;
  const auto shown = selected_demonstration(state);
  const bool whole = shown->begin_s <= 0.0 && shown->end_s >= shown->full_duration_s();
  return whole ? "Nothing is trimmed" : "";
}

Requests clear_gates(const State& state) {
  return trim(state, 0.0, selected_demonstration(state)->full_duration_s());
}

Requests trim_idle(const State& state) {
  return one(Command{CommitEdit{EditDemonstration{state.demonstration, demonstration::TrimIdle{}}}});
}

std::string cannot_split(const State& state) {
  if (std::string reason = cannot_edit(state); !reason.empty()) return reason;
  const auto shown = selected_demonstration(state);
  const bool inside = state.playhead_s > shown->begin_s && state.playhead_s < shown->end_s;
  return inside ? "" : "The playhead is not between the gates";
}

Requests split(const State& state) {
  return one(Command{CommitEdit{SplitDemonstration{state.demonstration, state.playhead_s, ""}}});
}

Requests copy_demonstration(const State& state) {
  return one(Command{CommitEdit{CopyDemonstration{state.demonstration, "", {}}}});
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

constexpr std::array<RowData, 9> kFileRows{{
    {"file.new",
     "File",
     "New project…",
     "Make an empty project file with the standard board",
     icon::kFile,
     {"Ctrl+N"},
     false,
     cannot_open,
     act<UiAction::kNewProject>},
    {"file.open",
     "File",
     "Open project…",
     "Open a project file",
     icon::kFolder,
     {"Ctrl+O"},
     false,
     cannot_open,
     act<UiAction::kOpenProject>},
    {"file.import",
     "File",
     "Import…",
     "Take in demonstrations from a file of another program: look at it first, and say which column is what",
     icon::kPlus,
     {"Ctrl+I"},
     true,
     cannot_record,
     act<UiAction::kShowImport>},
    {"file.export_demonstrations",
     "File",
     "Export demonstrations…",
     "Write demonstrations as CSV, NPY or HDF5 for other programs, and read them again to be sure",
     icon::kTable,
     {"Ctrl+Alt+E"},
     false,
     no_demonstration,
     act<UiAction::kShowExportDemonstrations>},
    {"file.checkpoint",
     "File",
     "Checkpoint",
     "Name the state that the project is in, to find and compare it; all work is already saved",
     icon::kBook,
     {"Ctrl+S"},
     false,
     cannot_change,
     checkpoint},
    {"file.export_video",
     "File",
     "Export video…",
     "Film the selected demonstration",
     icon::kFilm,
     {"Ctrl+E"},
     false,
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
    {"file.export_plot",
     "File",
     "Export figure…",
     "Draw rollouts, their measures or the learning curve into a file",
     icon::kChart,
     {},
     false,
     no_model,
     act<UiAction::kShowExportPlot>},
    {"file.quit",
     "File",
     "Quit",
     "Close the window; all work is already saved",
     nullptr,
     {"Ctrl+Q"},
     true,
     nullptr,
     act<UiAction::kQuit>},
}};

constexpr std::array<RowData, 2> kUndoRows{{
    {"edit.undo", "Edit", "Undo", "Go back one step in the history", icon::kUndo, {"Ctrl+Z"}, false, cannot_undo, undo},
    {"edit.redo",
     "Edit",
     "Redo",
     "Go forward one step in the history",
     icon::kRedo,
     {"Ctrl+Shift+Z", "Ctrl+Y"},
     false,
     cannot_redo,
     redo},
}};

constexpr std::array<RowData, 12> kEditRows{{
    {"edit.trim_in",
     "Edit",
     "Trim in at playhead",
     "Leave out what is before the playhead; the recording keeps it",
     icon::kCut,
     {"I"},
     true,
     cannot_trim_in,
     trim_in},
    {"edit.trim_out",
     "Edit",
     "Trim out at playhead",
     "Leave out what is after the playhead; the recording keeps it",
     icon::kCut,
     {"O"},
     false,
     cannot_trim_out,
     trim_out},
    {"edit.clear_gates",
     "Edit",
     "Clear gates",
     "Show the whole recording again, trims undone",
     icon::kExpand,
     {"X"},
     false,
     cannot_clear_gates,
     clear_gates},
    {"edit.trim_idle",
     "Edit",
     "Trim idle",
     "Leave out both ends where no arm moves",
     icon::kCut,
     {"Ctrl+Shift+T"},
     false,
     cannot_edit,
     trim_idle},
    {"edit.split",
     "Edit",
     "Split at playhead",
     "Make two demonstrations: one up to the playhead, one from there on",
     icon::kCut,
     {"B"},
     false,
     cannot_split,
     split},
    {"edit.copy_demonstration",
     "Edit",
     "Copy demonstration",
     "Add another with the same recording and the same edits",
     icon::kCopy,
     {"Ctrl+D"},
     false,
     cannot_edit,
     copy_demonstration},
    {"edit.remove_demonstration",
     "Edit",
     "Delete demonstration",
     "Put the selected demonstration into the trash; undo or restore brings it back",
     icon::kTrash,
     {"Ctrl+Delete"},
     true,
     cannot_edit,
     remove_demonstration},
    {"edit.remove_model",
     "Edit",
     "Delete model",
     "Take the selected model out of the project; undo brings it back",
     icon::kTrash,
     {"Ctrl+Shift+Delete"},
     false,
     cannot_remove_model,
     remove_model},
    {"demo.verify",
     "Edit",
     "Verify replay",
     "Simulate the recorded input again and compare every state hash",
     icon::kVerify,
     {"Ctrl+R"},
     false,
     no_demonstration,
     verify},
    {"model.import",
     "Edit",
     "Import Q-table…",
     "Make a model of a Q-table or of rewards θ that were learned elsewhere",
     icon::kPlus,
     {},
     false,
     cannot_train,
     act<UiAction::kShowImportTable>},
    {"model.train",
     "Edit",
     "Train…",
     "Learn from demonstrations",
     icon::kTrain,
     {"Shift+T"},
     false,
     cannot_train,
     show<PanelId::kTrain>},
    {"model.compare",
     "Edit",
     "Compare models",
     "Show two models beside each other and what they measure",
     icon::kBalance,
     {},
     false,
     {},
     show<PanelId::kModels>},
}};

}  // namespace

std::string cannot_change(const State& state) {
  if (state.load == LoadState::kLoading) return "The project is being opened";
  return state.project == nullptr ? "No project is open" : "";
}

std::string cannot_edit(const State& state) {
  if (std::string reason = cannot_change(state); !reason.empty()) return reason;
  if (selected_trial(state) != nullptr) return "What was recorded of a trial stays as it is";
  return state.live ? "A transfer is being recorded" : no_demonstration(state);
}

Requests change(const State& state, demonstration::Edit edit) {
  return one(Command{CommitEdit{EditDemonstration{state.demonstration, std::move(edit)}}});
}

std::span<const RowData> file_rows() {
  return kFileRows;
}

std::span<const RowData> undo_rows() {
  return kUndoRows;
}

std::span<const RowData> edit_rows() {
  return kEditRows;
}

}  // namespace trocar::ui
