#include "ui/forms/quit_form.h"

#include <fmt/format.h>

#include <algorithm>

#include "ui/format.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

bool runs(const workbench::JobView& job) {
  return job.state == workbench::JobState::kRunning || job.state == workbench::JobState::kQueued;
}

bool wide_button(Ui& ui, std::string_view label, const char* sign, std::string_view help, ButtonStyle style) {
  return button(ui, label, {.icon = sign, .help = help, .width = -1.0F, .style = style});
}

void draw_jobs(Ui& ui, const WorkbenchState& state) {
  if (std::none_of(state.jobs.begin(), state.jobs.end(), runs)) return;
  wrapped_text(ui, "These are not finished and will be cancelled; they leave no half files behind.", ui.theme().text);
  UniqueNames unique;
  for (const workbench::JobView& job : state.jobs) {
    if (runs(job)) dim_text(ui, unique(job.title));
  }
}

}  // namespace

bool something_runs(const WorkbenchState& state) {
  return state.live.has_value() || std::any_of(state.jobs.begin(), state.jobs.end(), runs);
}

Requests QuitForm::draw_content(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (state.live) {
    wrapped_text(ui, fmt::format("A transfer is being recorded: {} so far.", seconds(state.live->elapsed_s)),
                 ui.theme().text);
  }
  draw_jobs(ui, state);
  ImGui::Dummy({0.0F, ui.px(4)});
  if (state.live) {
    if (wide_button(ui, "Keep and quit", icon::kStop, "End the recording and put it into the project",
                    ButtonStyle::kPrimary)) {
      requests = {workbench::Command{workbench::StopRecording{true}}, UiAction::kQuitNow};
    }
    if (wide_button(ui, "Discard and quit", icon::kTrash, "Throw the recording away", ButtonStyle::kDanger)) {
      requests = {workbench::Command{workbench::StopRecording{false}}, UiAction::kQuitNow};
    }
  } else if (wide_button(ui, something_runs(state) ? "Cancel them and quit" : "Quit", icon::kCross,
                         "All else is already saved", ButtonStyle::kDanger)) {
    requests = {UiAction::kQuitNow};
  }
  if (wide_button(ui, "Stay", icon::kPlay, "Go on working", ButtonStyle::kNormal)) close();
  return requests;
}

}  // namespace trocar::ui
