// A row for each kind of edit, which opens its form, and those that one key makes at once.
#include <array>

#include "engine/demonstration/quick_edits.h"
#include "ui/command_rows.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

using namespace workbench;
using State = WorkbenchState;
using demonstration::Segment;

template <typename Edited>
Requests begin(const State&) {
  return {BeginEdit{Edited{}}, ShowPanel{PanelId::kEdits}};
}

Requests begin_copies(const State&) {
  return {BeginEdit{demonstration::Perturb{}, 5}, ShowPanel{PanelId::kEdits}};
}

std::string at_the_end(const State& state) {
  if (std::string reason = cannot_edit(state); !reason.empty()) return reason;
  const bool inside = state.playhead_s < selected_demonstration(state)->end_s - kSameTime_s;
  return inside ? "" : "The playhead is at the end";
}

std::string cannot_label_selection(const State& state) {
  if (std::string reason = cannot_edit(state); !reason.empty()) return reason;
  return state.selection ? "" : "No time is selected: drag over the lanes, or Alt+I and Alt+O";
}

template <int nth>
Requests label_from_playhead(const State& state) {
  return change(state,
                demonstration::label_from(*selected_demonstration(state), static_cast<Segment>(nth), state.playhead_s));
}

template <int nth>
Requests label_selection(const State& state) {
  return change(
      state, demonstration::LabelSegment{static_cast<Segment>(nth), state.selection->begin_s, state.selection->end_s});
}

template <bool open>
Requests move_jaw(const State& state) {
  return change(state,
                demonstration::gripper_event(*selected_demonstration(state), state.gizmo.arms, state.playhead_s, open));
}

Requests mark(const State& state) {
  demonstration::AddNote note;
  note.text = "Marker";
  note.from_s = note.to_s = state.playhead_s;
  note.tag = "marker";
  return change(state, note);
}

template <typename Edited>
constexpr RowData form_row(std::string_view id, std::string_view title, std::string_view keys = {},
                           const char* sign = nullptr, bool separator = false, std::string_view menu = "Modify") {
  return {id, menu, title, Edited::kHelp, sign, {keys}, separator, cannot_edit, begin<Edited>};
}

constexpr RowData key_row(std::string_view id, std::string_view title, std::string_view help, std::string_view keys,
                          std::string (*reason)(const State&), Requests (*run)(const State&),
                          std::string_view menu = "Label", bool separator = false) {
  return {id, menu, title, help, nullptr, {keys}, separator, reason, run};
}

constexpr std::string_view kFromPlayhead = "From the playhead to the next segment";
constexpr std::string_view kOverSelection = "Over the selected time";

constexpr std::array<RowData, 39> kModifyRows{{
    form_row<demonstration::Trim>("modify.trim", "Trim…", "", icon::kCut),
    form_row<demonstration::TrimIdle>("modify.trim_idle", "Trim idle…"),
    form_row<demonstration::DeleteSpan>("modify.delete", "Delete…", "", icon::kTrash),
    form_row<demonstration::Splice>("modify.splice", "Splice…", "", icon::kPaste),
    form_row<demonstration::Overdub>("modify.overdub", "Overdub…"),
    form_row<demonstration::Bridge>("modify.bridge", "Bridge…", "Ctrl+B", icon::kRoad, true),
    form_row<demonstration::MoveTool>("modify.move", "Move tool…", "", icon::kArrows),
    form_row<demonstration::RotateTool>("modify.rotate", "Turn tool…", "", icon::kRefresh),
    form_row<demonstration::Offset>("modify.offset", "Offset…"),
    form_row<demonstration::Smooth>("modify.smooth", "Smooth…", "Ctrl+M", nullptr, true),
    form_row<demonstration::Simplify>("modify.simplify", "Simplify…", "Ctrl+Shift+M"),
    form_row<demonstration::Resample>("modify.resample", "Resample…"),
    form_row<demonstration::Retime>("modify.retime", "Retime…", "S", icon::kClock),
    form_row<demonstration::SnapToGrid>("modify.snap", "Snap to lattice…", "Ctrl+G", icon::kCubes),
    form_row<demonstration::SetJaw>("modify.jaw", "Gripper…", "", nullptr, true),
    form_row<demonstration::JawEvents>("modify.jaw_events", "Clean gripper events…"),
    key_row("modify.close_gripper", "Close gripper", "Of the chosen arm, from the playhead on", ";", at_the_end,
            move_jaw<false>, "Modify"),
    key_row("modify.open_gripper", "Open gripper", "Of the chosen arm, from the playhead on", "'", at_the_end,
            move_jaw<true>, "Modify"),
    form_row<demonstration::Rename>("modify.rename", "Rename…", "F2", icon::kPencil, true),
    form_row<demonstration::Mirror>("modify.mirror", "Mirror…"),
    form_row<demonstration::Retarget>("modify.retarget", "Retarget…"),
    form_row<demonstration::Perturb>("modify.perturb", "Perturb…"),
    {"modify.copies",
     "Modify",
     "Perturbed copies…",
     "Copies with smooth noise on their paths, in one step",
     nullptr,
     {},
     false,
     cannot_edit,
     begin_copies},
    form_row<demonstration::Revert>("modify.revert", "Revert to recording…", "Ctrl+Alt+R", icon::kHistory),
    form_row<demonstration::LabelSegment>("modify.label", "Label segment…", "", nullptr, false, "Label"),
    form_row<demonstration::ProposeLabels>("modify.propose_labels", "Propose labels…", "", nullptr, false, "Label"),
    key_row("modify.label_a", "Label A from playhead", kFromPlayhead, "1", at_the_end, label_from_playhead<0>, "Label",
            true),
    key_row("modify.label_b", "Label B from playhead", kFromPlayhead, "2", at_the_end, label_from_playhead<1>),
    key_row("modify.label_c", "Label C from playhead", kFromPlayhead, "3", at_the_end, label_from_playhead<2>),
    key_row("modify.label_d", "Label D from playhead", kFromPlayhead, "4", at_the_end, label_from_playhead<3>),
    key_row("modify.label_e", "Label E from playhead", kFromPlayhead, "5", at_the_end, label_from_playhead<4>),
    key_row("modify.select_a", "Label selection A", kOverSelection, "Shift+1", cannot_label_selection,
            label_selection<0>, "Label", true),
    key_row("modify.select_b", "Label selection B", kOverSelection, "Shift+2", cannot_label_selection,
            label_selection<1>),
    key_row("modify.select_c", "Label selection C", kOverSelection, "Shift+3", cannot_label_selection,
            label_selection<2>),
    key_row("modify.select_d", "Label selection D", kOverSelection, "Shift+4", cannot_label_selection,
            label_selection<3>),
    key_row("modify.select_e", "Label selection E", kOverSelection, "Shift+5", cannot_label_selection,
            label_selection<4>),
    key_row("modify.marker", "Marker at playhead", "A note at the playhead", "M", cannot_edit, mark, "Label", true),
    form_row<demonstration::AddNote>("modify.note", "Note…", "Shift+M", nullptr, false, "Label"),
    form_row<demonstration::RemoveNote>("modify.remove_note", "Remove note…", "", nullptr, false, "Label"),
}};

}  // namespace

std::span<const RowData> modify_rows() {
  return kModifyRows;
}

}  // namespace trocar::ui
