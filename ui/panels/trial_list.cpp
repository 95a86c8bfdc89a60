#include "ui/panels/trial_list.h"

#include <fmt/format.h>

#include <cmath>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::Command;

/// Its name, how it ended and when, who made it; dimmed where it is left out.
void draw_trial_row(Ui& ui, const workbench::TrialEntry& trial, const Rect& row) {
  using demonstration::Outcome;
  const Theme& theme = ui.theme();
  const trial::TrialRecord& record = trial.record;
  const bool succeeded = record.outcome == Outcome::kSuccess;
  const bool failed = record.outcome == Outcome::kDropped || record.outcome == Outcome::kFault;
  const Rgba colour = succeeded ? theme.good : failed ? theme.danger : theme.warning;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = std::round(row.centre_y() - 0.5F * ImGui::GetFontSize());
  const auto text = [&](float share, float room, Rgba ink, const std::string& words) {
    const float x = std::round(row.x0 + ui.px(8) + share * (row.width() - ui.px(16)));
    list.AddText({x, y}, to_u32(ink), fitted(words, room * (row.width() - ui.px(16)) - ui.px(6)).c_str());
  };
  const float sign = ImGui::CalcTextSize("✓ ").x;
  text(0.0F, 0.26F, trial.excluded ? theme.text_dim : theme.text, trial.name);
  const float x = row.x0 + ui.px(8) + 0.26F * (row.width() - ui.px(16));
  list.AddText({std::round(x), y}, to_u32(colour), succeeded ? icon::kVerify : failed ? icon::kCross : icon::kPause);
  const std::string outcome(demonstration::to_string(record.outcome));
  list.AddText({std::round(x + sign + ui.px(6)), y}, to_u32(trial.excluded ? theme.text_dim : theme.text),
               fitted(outcome, 0.26F * row.width() - sign - ui.px(12)).c_str());
  text(0.54F, 0.18F, trial.excluded ? theme.text_dim : theme.text,
       record.completion_s ? seconds(*record.completion_s) : "–");
  text(0.72F, 0.28F, theme.text_dim, trial.excluded ? "left out" : record.operator_kind);
}

}  // namespace

void TrialList::draw_judgement(Ui& ui, const workbench::TrialEntry& trial, Requests& requests) {
  const Scope scope(ui, "Judgement");
  const trial::TrialRecord& record = trial.record;
  heading(ui, trial.name);
  fact(ui, "Made by", record.operator_kind + (record.skill.empty() ? "" : " " + record.skill));
  fact(ui, "Right arm", record.assistant);
  // A transfer succeeds if the block is not dropped (section V.B); whether it is on its peg is another question.
  const bool beside = record.outcome == demonstration::Outcome::kSuccess && !record.placed;
  fact(ui, "Outcome", fmt::format("{}{}", demonstration::to_string(record.outcome), beside ? ", not placed" : ""));
  fact(ui, "Completion", record.completion_s ? seconds(*record.completion_s) : "–");
  fact(ui, "Agent's share", fmt::format("{:.0f} %", 100.0 * record.metrics.agent_share));
  fact(ui, "Path", fmt::format("{:.0f} mm", 1e3 * record.metrics.path_length_m));
  fact(ui, "Seed, block", fmt::format("{}, {}", record.seed, record.block));
  if (trial.excluded) {
    fact(ui, "Left out", trial.reason);
    if (button(ui, "Include", {.icon = icon::kVerify, .help = "It counts in the results again"})) {
      requests.emplace_back(Command{workbench::CommitEdit{workbench::JudgeTrial{trial.id, false, ""}}});
    }
  } else {
    form_label(ui, "Reason");
    text_field(ui, "Reason", why_, "Why it is left out");
    if (button(ui, "Exclude",
               {.icon = icon::kCross,
                .help = "Leave it out of the results; it stays in the project",
                .reason = why_.empty() ? "Say why first" : ""})) {
      requests.emplace_back(Command{workbench::CommitEdit{workbench::JudgeTrial{trial.id, true, why_}}});
    }
  }
  ImGui::SameLine();
  if (button(ui, "Verify replay", {.icon = icon::kRefresh, .help = "Simulate it again and compare every hash"})) {
    requests.emplace_back(Command{workbench::VerifyReplay{demonstration::DemonstrationId{trial.id.value}}});
  }
}

void TrialList::draw(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "List");
  if (state.project->trials.empty()) {
    empty_state(ui, icon::kTasks, "No trials yet", "What is run on the page Run stays here, with its record", {},
                ui.px(160));
    return;
  }
  const workbench::TrialEntry* selected = nullptr;
  for (const auto& [id, trial] : state.project->trials) {
    const bool is_selected = state.demonstration.value == id.value;
    if (is_selected) selected = trial.get();
    const trial::TrialRecord& record = trial->record;
    const std::string value = fmt::format("{}{}{}, {}", demonstration::to_string(record.outcome),
                                          record.completion_s ? " " + seconds(*record.completion_s) : "",
                                          trial->excluded ? ", left out" : "", record.operator_kind);
    ImGui::PushID(static_cast<int>(id.value));
    if (selectable_row(ui, trial->name, is_selected, value,
                       {.help = "Show it in the view and in the timeline", .height = ui.px(24)})) {
      requests.emplace_back(Command{workbench::SelectDemonstration{demonstration::DemonstrationId{id.value}}});
    }
    draw_trial_row(ui, *trial, item_rect());
    ImGui::PopID();
  }
  ImGui::Dummy({0.0F, ui.px(4)});
  if (selected != nullptr) draw_judgement(ui, *selected, requests);
}

}  // namespace trocar::ui
