// Rows about time: the clipboard, the selection, and playing.
#include <algorithm>
#include <cmath>

#include "engine/demonstration/events.h"
#include "ui/command_rows.h"
#include "ui/icons.h"
#include "ui/timeline_steps.h"

namespace trocar::ui {
namespace {

using namespace workbench;
using State = WorkbenchState;

std::string nothing_selected(const State& state) {
  if (std::string reason = no_demonstration(state); !reason.empty()) return reason;
  return state.selection ? "" : "No time is selected: drag over the lanes, or Alt+I and Alt+O";
}

std::string cannot_take_out(const State& state) {
  if (std::string reason = cannot_edit(state); !reason.empty()) return reason;
  if (std::string reason = nothing_selected(state); !reason.empty()) return reason;
  return deletion(*selected_demonstration(state), *state.selection, true) ? "" : "Nothing would stay";
}

std::string cannot_paste(const State& state) {
  if (std::string reason = cannot_edit(state); !reason.empty()) return reason;
  return state.clipboard ? "" : "Nothing was copied";
}

template <bool ripple>
Requests take_out(const State& state) {
  const Result<demonstration::Edit> edit = deletion(*selected_demonstration(state), *state.selection, ripple);
  return edit ? change(state, *edit) : Requests{};
}

Requests copy(const State& state) {
  return one(Command{CopyRun{state.demonstration, *state.selection}});
}

Requests cut(const State& state) {
  Requests requests = copy(state);
  for (Request& request : take_out<true>(state)) requests.push_back(std::move(request));
  return requests;
}

template <demonstration::Align align>
Requests paste_aligned(const State& state) {
  return change(state,
                paste(*state.clipboard, *selected_demonstration(state), state.playhead_s, state.selection, align));
}

Requests select(double begin_s, double end_s) {
  return one(Command{SetSelection{TimeSpan{begin_s, end_s}}});
}

Requests select_all(const State& state) {
  const auto shown = selected_demonstration(state);
  return select(shown->begin_s, shown->end_s);
}

const demonstration::SegmentSpan* segment_at_playhead(const demonstration::Demonstration& shown, double t_s) {
  for (const demonstration::SegmentSpan& span : shown.segments) {
    if (t_s >= span.begin_s && t_s < span.end_s) return &span;
  }
  return nullptr;
}

std::string no_segment(const State& state) {
  if (std::string reason = no_demonstration(state); !reason.empty()) return reason;
  const bool there = segment_at_playhead(*selected_demonstration(state), state.playhead_s) != nullptr;
  return there ? "" : "The playhead is in no segment";
}

Requests select_segment(const State& state) {
  const auto shown = selected_demonstration(state);
  const auto* span = segment_at_playhead(*shown, state.playhead_s);
  return select(span->begin_s, span->end_s);
}

Requests select_from(const State& state) {
  const auto shown = selected_demonstration(state);
  const bool later = state.selection && state.selection->end_s > state.playhead_s;
  return select(state.playhead_s, later ? state.selection->end_s : shown->end_s);
}

Requests select_to(const State& state) {
  const auto shown = selected_demonstration(state);
  const bool earlier = state.selection && state.selection->begin_s < state.playhead_s;
  return select(earlier ? state.selection->begin_s : shown->begin_s, state.playhead_s);
}

Requests select_none(const State&) {
  return one(Command{SetSelection{}});
}

// The playhead goes to `t_s` and takes the selection's end with it that is at the playhead.
Requests extend(const State& state, double t_s) {
  const double here_s = state.playhead_s;
  const TimeSpan now = state.selection.value_or(TimeSpan{here_s, here_s});
  const bool at_begin = std::abs(here_s - now.begin_s) < std::abs(here_s - now.end_s);
  Requests requests = select(at_begin ? now.end_s : now.begin_s, t_s);
  requests.emplace_back(Command{SetPlayhead{t_s}});
  return requests;
}

template <int steps>
Requests extend_samples(const State& state) {
  return extend(state, stepped(*selected_demonstration(state), state.playhead_s, steps));
}

template <int direction>
Requests extend_to_event(const State& state) {
  return extend(state, demonstration::next_event(*selected_demonstration(state), state.playhead_s, direction));
}

constexpr std::array<RowData, 7> kClipboardRows{{
    {"edit.cut",
     "Edit",
     "Cut",
     "Copy the selected time and take it out; what follows moves up",
     icon::kCut,
     {"Ctrl+X"},
     true,
     cannot_take_out,
     cut},
    {"edit.copy",
     "Edit",
     "Copy",
     "Remember the selected time as it is now, both arms, jaws and labels",
     icon::kCopy,
     {"Ctrl+C"},
     false,
     nothing_selected,
     copy},
    {"edit.paste",
     "Edit",
     "Paste",
     "Put in what was copied, where it was on the board; at the playhead, or in place of the selection",
     icon::kPaste,
     {"Ctrl+V"},
     false,
     cannot_paste,
     paste_aligned<demonstration::Align::kAsRecorded>},
    {"edit.paste_meeting",
     "Edit",
     "Paste to meet",
     "Put in what was copied, moved so that each tool goes on from where it is",
     icon::kPaste,
     {"Ctrl+Shift+V"},
     false,
     cannot_paste,
     paste_aligned<demonstration::Align::kMeet>},
    {"edit.paste_to_peg",
     "Edit",
     "Paste to this peg",
     "Put in what was copied, moved from its start peg to this demonstration's",
     icon::kPaste,
     {},
     false,
     cannot_paste,
     paste_aligned<demonstration::Align::kPeg>},
    {"edit.ripple_delete",
     "Edit",
     "Delete time",
     "Take the selected time out; what follows moves up",
     icon::kTrash,
     {"Shift+Delete"},
     false,
     cannot_take_out,
     take_out<true>},
    {"edit.lift",
     "Edit",
     "Lift time",
     "Take the selected time out and leave a gap, to be bridged",
     icon::kEject,
     {"Delete"},
     false,
     cannot_take_out,
     take_out<false>},
}};

constexpr std::array<RowData, 11> kSelectionRows{{
    {"select.all",
     "Select",
     "Select all",
     "Select everything from the in gate to the out gate",
     nullptr,
     {"Ctrl+A"},
     false,
     no_demonstration,
     select_all},
    {"select.segment",
     "Select",
     "Select segment",
     "Select the segment that the playhead is in",
     nullptr,
     {"Alt+S"},
     false,
     no_segment,
     select_segment},
    {"select.none",
     "Select",
     "Select nothing",
     "Select no time; Esc does so in the timeline",
     nullptr,
     {"Ctrl+Shift+A"},
     false,
     nothing_selected,
     select_none},
    {"select.from",
     "Select",
     "Select from playhead",
     "Let the selection begin at the playhead",
     nullptr,
     {"Alt+I"},
     true,
     no_demonstration,
     select_from},
    {"select.to",
     "Select",
     "Select to playhead",
     "Let the selection end at the playhead",
     nullptr,
     {"Alt+O"},
     false,
     no_demonstration,
     select_to},
    {"select.forward",
     "Select",
     "Extend by a sample",
     "Move the playhead, and the end of the selection with it",
     nullptr,
     {"Alt+Right"},
     true,
     no_demonstration,
     extend_samples<1>},
    {"select.back",
     "Select",
     "Extend back by a sample",
     "Move the playhead, and the end of the selection with it",
     nullptr,
     {"Alt+Left"},
     false,
     no_demonstration,
     extend_samples<-1>},
    {"select.forward_10",
     "Select",
     "Extend by ten samples",
     "Move the playhead by 50 ms, and the end of the selection with it",
     nullptr,
     {"Shift+Alt+Right"},
     false,
     no_demonstration,
     extend_samples<10>},
    {"select.back_10",
     "Select",
     "Extend back by ten samples",
     "Move the playhead by 50 ms, and the end of the selection with it",
     nullptr,
     {"Shift+Alt+Left"},
     false,
     no_demonstration,
     extend_samples<-10>},
    {"select.next_event",
     "Select",
     "Extend to the next event",
     "Up to the next segment, note, grasp or move of a gripper",
     nullptr,
     {"Ctrl+Alt+Right"},
     false,
     no_demonstration,
     extend_to_event<1>},
    {"select.last_event",
     "Select",
     "Extend to the event before",
     "Back to the last segment, note, grasp or move of a gripper",
     nullptr,
     {"Ctrl+Alt+Left"},
     false,
     no_demonstration,
     extend_to_event<-1>},
}};

}  // namespace

std::span<const RowData> clipboard_rows() {
  return kClipboardRows;
}

std::span<const RowData> selection_rows() {
  return kSelectionRows;
}

}  // namespace trocar::ui
