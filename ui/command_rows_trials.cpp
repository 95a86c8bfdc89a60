// Rows of trials: from the start of a block to stop, which always works.
#include "ui/command_rows.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

using namespace workbench;
using State = WorkbenchState;

/// Keys of trials mean nothing else while there are any.
constexpr std::string_view kTrialKeys = "trials";

std::string cannot_start_trials(const State& state) {
  if (state.trials) return "Trials are prepared already";
  return cannot_record(state);
}

std::string no_trials(const State& state) {
  return state.trials ? "" : "No trials are prepared";
}

std::string no_transfer(const State& state) {
  if (std::string reason = no_trials(state); !reason.empty()) return reason;
  return state.live ? "" : "No transfer goes on";
}

std::string cannot_begin_block(const State& state) {
  if (std::string reason = no_trials(state); !reason.empty()) return reason;
  if (state.live) return "A transfer goes on";
  return state.trials->phase == TrialsPhase::kDone ? "All blocks are over" : "";
}

Requests prepare_trials(const State&) {
  return {ShowWorkspace{Workspace::kTrials}, ShowPanel{PanelId::kTrials}};
}
Requests begin_block(const State&) {
  return one(Command{StartBlock{}});
}
Requests pause_trials(const State& state) {
  return one(Command{PauseTrials{!state.trials->paused}});
}
Requests stop_trial(const State&) {
  return one(Command{StopTrial{}});
}
Requests end_trials(const State&) {
  return one(Command{EndTrials{}});
}
Requests mark_instant(const State&) {
  return one(Command{MarkIncident{}});
}

constexpr std::array<RowData, 6> kTrialRows{{
    {"trials.start",
     "Edit",
     "Run trials…",
     "Manual and shared-control transfers, by a script or a person",
     icon::kPlay,
     {},
     true,
     cannot_start_trials,
     prepare_trials},
    {"trials.block",
     "Edit",
     "Start the block",
     "The next block of the protocol, or the transfers that are left of this one",
     icon::kPlay,
     {"F5"},
     false,
     cannot_begin_block,
     begin_block,
     kTrialKeys},
    {"trials.pause",
     "Edit",
     "Pause between trials",
     "The transfer that goes on is finished; no other begins",
     icon::kPause,
     {"F6"},
     false,
     no_trials,
     pause_trials,
     kTrialKeys},
    {"trials.mark",
     "Edit",
     "Mark an incident",
     "The instant is in the record, to be looked at later",
     icon::kPencil,
     {"F8"},
     false,
     no_transfer,
     mark_instant,
     kTrialKeys},
    {"trials.stop",
     "Edit",
     "Stop the trial",
     "At once: the tool holds, and the transfer is aborted. A soft stop, not an emergency stop",
     icon::kStop,
     {"Escape"},
     false,
     no_transfer,
     stop_trial,
     kTrialKeys},
    {"trials.end",
     "Edit",
     "End the trials",
     "Gives up what is left; a transfer that goes on is kept as interrupted",
     icon::kCross,
     {},
     false,
     no_trials,
     end_trials,
     kTrialKeys},
}};

}  // namespace

std::span<const RowData> trial_rows() {
  return kTrialRows;
}

}  // namespace trocar::ui
