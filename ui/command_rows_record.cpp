// Rows of recording: by script and by hand, from arming to the verdict.
#include "engine/workbench/take_plan.h"
#include "ui/command_rows.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

using namespace workbench;
using State = WorkbenchState;
using trial::Phase;

/// Keys of a take, and of the verdict on it, mean nothing else meanwhile.
constexpr std::string_view kTake = "recording";
constexpr std::string_view kVerdict = "recorded take";

std::string cannot_stop(const State& state) {
  return state.live ? "" : "Nothing is being recorded";
}

std::string no_take(const State& state) {
  if (!state.take) return "Nobody records by hand";
  return state.take->reviewing ? "The take has ended" : "";
}

std::string no_countdown(const State& state) {
  if (std::string reason = no_take(state); !reason.empty()) return reason;
  return state.live && state.live->status.phase == Phase::kCountdown ? "" : "It records already";
}

std::string cannot_pause(const State& state) {
  if (std::string reason = no_take(state); !reason.empty()) return reason;
  const bool records = state.live && state.live->status.phase != Phase::kCountdown;
  return records ? "" : "It does not record yet";
}

std::string no_verdict(const State& state) {
  return state.take && state.take->reviewing ? "" : "No take waits for a verdict";
}

Requests arm(const State& state) {
  RecordByHand take = another_take(state.last_take);
  take.from.reset();  // That was for one start.
  return {Command{take}, ShowPanel{PanelId::kView}};
}

Requests do_by_hand(trial::HandEvent event) {
  return one(Command{HandInput{{std::move(event)}}});
}

Requests begin(const State&) {
  return do_by_hand(trial::BeginTake{});
}

Requests end(const State&) {
  return do_by_hand(trial::EndTake{});
}

Requests pause(const State& state) {
  return do_by_hand(trial::PauseTake{state.live->status.phase != Phase::kPaused});
}

template <TakeVerdict verdict>
Requests judge(const State&) {
  return one(Command{JudgeTake{verdict}});
}

template <bool keep>
Requests stop(const State&) {
  return one(Command{StopRecording{keep}});
}

constexpr std::array<RowData, 11> kRecordRows{{
    {"record.arm",
     "Edit",
     "Record by hand",
     "Drive the tools by keys and mouse as last set in the form, after the countdown",
     icon::kKeyboard,
     {"R"},
     true,
     cannot_record,
     arm},
    {"demo.record",
     "Edit",
     "Record…",
     "Choose who drives each arm, and record a transfer in the simulator",
     icon::kRecord,
     {"Shift+R"},
     false,
     cannot_record,
     act<UiAction::kShowRecord>},
    {"record.begin",
     "Edit",
     "Begin to record now",
     "Do not wait for the countdown",
     nullptr,
     {"Space"},
     false,
     no_countdown,
     begin,
     kTake},
    {"record.end",
     "Edit",
     "End the take",
     "Then say whether it is kept",
     icon::kStop,
     {"R"},
     false,
     no_take,
     end,
     kTake},
    {"record.pause",
     "Edit",
     "Pause the take",
     "Simulated time stands; a note tells where",
     icon::kPause,
     {"P"},
     false,
     cannot_pause,
     pause,
     kTake},
    {"record.keep",
     "Edit",
     "Keep",
     "Put the take into the project",
     icon::kVerify,
     {"Enter", "KeypadEnter"},
     false,
     no_verdict,
     judge<TakeVerdict::kKeep>,
     kVerdict},
    {"record.again",
     "Edit",
     "Discard and re-record",
     "Throw the take away and begin anew",
     icon::kUndo,
     {"Backspace"},
     false,
     no_verdict,
     judge<TakeVerdict::kAgain>,
     kVerdict},
    {"record.next",
     "Edit",
     "Keep and next",
     "Put the take into the project and record another one",
     icon::kToEnd,
     {"N"},
     false,
     no_verdict,
     judge<TakeVerdict::kKeepAndNext>,
     kVerdict},
    {"record.discard",
     "Edit",
     "Discard the take",
     "Throw it away",
     icon::kTrash,
     {"Delete"},
     false,
     no_verdict,
     judge<TakeVerdict::kDiscard>,
     kVerdict},
    {"demo.stop",
     "Edit",
     "Stop and keep",
     "End the recording and put it into the project",
     icon::kStop,
     {"Shift+R"},
     false,
     cannot_stop,
     stop<true>,
     kTake},
    {"demo.discard",
     "Edit",
     "Stop and discard",
     "End the recording and throw it away",
     icon::kCross,
     {"Shift+Backspace"},
     false,
     cannot_stop,
     stop<false>,
     kTake},
}};

}  // namespace

std::span<const RowData> record_rows() {
  return kRecordRows;
}

std::string cannot_record(const WorkbenchState& state) {
  if (std::string reason = cannot_change(state); !reason.empty()) return reason;
  return state.live ? "A transfer is being recorded" : "";
}

}  // namespace trocar::ui
