// Rows about problems: show them, mend them, try the demonstration in the simulator.
#include "ui/command_rows.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

using namespace workbench;
using State = WorkbenchState;

std::string cannot_fix(const State& state) {
  if (state.live) return "A transfer is being recorded";
  const std::string why = no_demonstration(state);
  if (!why.empty()) return why;
  if (!state.review || state.review_pending) return "The problems are being worked out";
  for (const review::Problem& problem : state.review->review.problems) {
    if (!problem.fix.empty()) return "";
  }
  return state.review->review.problems.empty() ? "There are no problems" : "No problem has a quick fix";
}

Requests fix_all(const State& state) {
  return one(Command{FixProblems{state.demonstration}});
}

std::string cannot_simulate(const State& state) {
  const std::string why = no_demonstration(state);
  if (!why.empty()) return why;
  return state.simulation && !state.simulation->result && state.simulation->error.empty() ? "It is being simulated"
                                                                                          : "";
}

Requests simulate(const State& state) {
  return one(Command{SimulateDemonstration{state.demonstration}});
}

constexpr std::array<RowData, 3> kReviewRows{{
    {"demo.problems",
     "Edit",
     "Show problems",
     "What is wrong or odd about the selected demonstration",
     icon::kWarning,
     {"F7"},
     true,
     no_demonstration,
     show<PanelId::kProblems>},
    {"demo.fix_all",
     "Edit",
     "Fix all problems",
     "Make every quick fix that helps, together one step of the history",
     icon::kPencil,
     {"Shift+F7"},
     false,
     cannot_fix,
     fix_all},
    {"demo.simulate",
     "Edit",
     "Simulate as edited",
     "Drive the simulator with the setpoints as they are now: is the block still transferred?",
     icon::kChip,
     {"Ctrl+Shift+R"},
     false,
     cannot_simulate,
     simulate},
}};

}  // namespace

std::span<const RowData> review_rows() {
  return kReviewRows;
}

}  // namespace trocar::ui
