#include "ui/panels/activity_panels.h"

#include <algorithm>
#include <string>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::JobState;
using workbench::JobView;

struct JobWords {
  const char* sign;
  const char* words;
  Rgba colour;
};

JobWords words_of(const Theme& theme, JobState state) {
  switch (state) {
    case JobState::kQueued:
      return {icon::kClock, "waiting", theme.text_dim};
    case JobState::kRunning:
      return {icon::kSpinner, "running", theme.accent};
    case JobState::kDone:
      return {icon::kVerify, "done", theme.good};
    case JobState::kFailed:
      return {icon::kCross, "failed", theme.danger};
    case JobState::kCancelled:
      return {icon::kStop, "cancelled", theme.text_dim};
  }
  return {icon::kInfo, "", theme.text};
}

void draw_job(Ui& ui, const JobView& job, const std::string& name, Requests& requests) {
  const JobWords words = words_of(ui.theme(), job.state);
  const bool alive = job.state == JobState::kQueued || job.state == JobState::kRunning;
  const float left = ImGui::GetCursorPosX();
  const float right = ImGui::GetWindowContentRegionMax().x;
  ImGui::AlignTextToFramePadding();
  {
    const ColourScope colour(ImGuiCol_Text, words.colour);
    ImGui::TextUnformatted(words.sign);
  }
  ImGui::SameLine(left + ui.px(24));
  const std::string percentage =
      job.state == JobState::kRunning ? std::to_string(static_cast<int>(100.0 * job.fraction)) + " %" : words.words;
  const float tail = ImGui::CalcTextSize(percentage.c_str()).x + (alive ? ui.px(40) : 0.0F);
  ImGui::TextUnformatted(fitted(job.title, right - left - ui.px(34) - tail).c_str());
  note_item(ui, "text", name, words.words, {.help = job.title});
  const Scope scope(ui, name);
  ImGui::SameLine(right - tail);
  {
    const ColourScope colour(ImGuiCol_Text, words.colour);
    ImGui::TextUnformatted(percentage.c_str());
  }
  if (alive) {
    ImGui::SameLine(right - ui.px(32));
    if (icon_button(
            ui, "Cancel",
            {.icon = icon::kCross, .help = "Stop this job; nothing is left behind", .style = ButtonStyle::kQuiet})) {
      requests.emplace_back(Command{workbench::CancelJob{job.id}});
    }
  }
  if (job.state == JobState::kRunning) {
    progress_bar(ui, "Progress", job.fraction, right - left);
    ui.animate();
  }
  if (!job.message.empty()) {
    const FontScope font(ui.fonts().small);
    ImGui::SetCursorPosX(left + ui.px(24));
    wrapped_text(ui, job.message, job.state == JobState::kFailed ? ui.theme().danger : ui.theme().text_dim);
  }
}

}  // namespace

Requests JobsPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (state.jobs.empty()) {
    empty_state(ui, icon::kTasks, "", "Nothing runs. Trainings, checks and exports appear here", {});
    return requests;
  }
  UniqueNames unique;
  for (const JobView& job : state.jobs) {
    ImGui::PushID(static_cast<int>(job.id.value));
    draw_job(ui, job, unique(job.title), requests);
    ImGui::PopID();
  }
  return requests;
}

Requests LogPanel::draw(Ui& ui, const WorkbenchState& state) {
  if (state.log.empty()) {
    empty_state(ui, icon::kList, "", "Nothing to report", {});
    return {};
  }
  const FontScope font(ui.fonts().mono);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), ui.px(3)});
  UniqueNames unique;
  for (const workbench::LogLine& line : state.log) {
    {
      const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
      ImGui::TextUnformatted(line.time.c_str());
    }
    ImGui::SameLine();
    const Rgba colour = line.severity == workbench::Severity::kError     ? ui.theme().danger
                        : line.severity == workbench::Severity::kWarning ? ui.theme().warning
                                                                         : ui.theme().text;
    const char* sign = line.severity == workbench::Severity::kInfo ? "" : icon::kWarning;
    {
      const ColourScope tint(ImGuiCol_Text, colour);
      if (*sign != '\0') {
        ImGui::TextUnformatted(sign);
        ImGui::SameLine(0.0F, ui.px(6));
      }
      ImGui::PushTextWrapPos(0.0F);
      ImGui::TextUnformatted(line.text.c_str());
      ImGui::PopTextWrapPos();
      note_item(ui, "text", unique(line.text), "", {});
    }
  }
  ImGui::PopStyleVar();
  if (state.log.size() != seen_) ImGui::SetScrollHereY(1.0F);
  seen_ = state.log.size();
  return {};
}

}  // namespace trocar::ui
