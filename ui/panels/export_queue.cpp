#include "ui/panels/export_queue.h"

#include <fmt/format.h>

#include <cmath>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::JobState;
using workbench::JobView;

struct Told {
  const char* sign = nullptr;
  std::string words;
  Rgba colour;
};

Told told_of(const Theme& theme, const JobView& job) {
  switch (job.state) {
    case JobState::kQueued:
      return {icon::kClock, "waits", theme.text_dim};
    case JobState::kRunning:
      return {job.paused ? icon::kPause : icon::kSpinner, film_progress_words(job),
              job.paused ? theme.warning : theme.accent};
    case JobState::kDone:
      return {icon::kVerify, "in " + shown_path(job.film), theme.good};
    case JobState::kFailed:
      return {icon::kCross, job.message, theme.danger};
    case JobState::kCancelled:
      return {icon::kStop, "cancelled: no file is left", theme.text_dim};
  }
  return {};
}

void draw_film(Ui& ui, const JobView& job, const std::string& name, Requests& requests) {
  const Told told = told_of(ui.theme(), job);
  const float left = ImGui::GetCursorPosX();
  const float wide = ImGui::GetContentRegionAvail().x;
  const bool alive = job.state == JobState::kQueued || job.state == JobState::kRunning;
  const float buttons = alive ? ui.px(72) : 0.0F;
  ImGui::AlignTextToFramePadding();
  {
    const ColourScope colour(ImGuiCol_Text, told.colour);
    ImGui::TextUnformatted(told.sign);
  }
  ImGui::SameLine(left + ui.px(24));
  ImGui::TextUnformatted(fitted(job.film.filename().string(), wide - ui.px(30) - buttons).c_str());
  const std::string where = job.film.string();
  note_item(ui, "text", name, told.words, {.help = where});
  const Scope scope(ui, name);
  if (alive) {
    ImGui::SameLine(left + wide - ui.px(66));
    const bool runs = job.state == JobState::kRunning;
    if (icon_button(
            ui, job.paused ? "Go on" : "Pause",
            {.icon = job.paused ? icon::kPlay : icon::kPause,
             .help = job.paused ? "Go on with the next frame" : "Stand still after this frame; what is behind waits",
             .reason = runs ? "" : "It has not begun",
             .style = ButtonStyle::kQuiet})) {
      requests.emplace_back(Command{workbench::PauseJob{job.id, !job.paused}});
    }
    ImGui::SameLine(left + wide - ui.px(32));
    if (icon_button(ui, "Cancel",
                    {.icon = icon::kCross, .help = "Give it up; no file is left", .style = ButtonStyle::kQuiet})) {
      requests.emplace_back(Command{workbench::CancelJob{job.id}});
    }
    if (runs) {
      progress_bar(ui, "Progress", job.fraction, wide);
      if (!job.paused) ui.animate();
    }
  }
  {
    const FontScope font(ui.fonts().small);
    ImGui::SetCursorPosX(left + ui.px(24));
    wrapped_text(ui, told.words, job.state == JobState::kFailed ? ui.theme().danger : ui.theme().text_dim);
    if (job.state == JobState::kDone && !job.message.empty()) {
      ImGui::SetCursorPosX(left + ui.px(24));
      wrapped_text(ui, job.message, ui.theme().text_dim);
    }
  }
  ImGui::Dummy({0.0F, ui.px(4)});
}

}  // namespace

std::string film_progress_words(const JobView& job) {
  const std::string frames = job.of > 0 ? fmt::format("frame {} of {}", count(job.done), count(job.of)) : "begins";
  const int left_s = job.left_s ? static_cast<int>(std::ceil(*job.left_s)) : 0;
  const std::string left = job.paused   ? "paused"
                           : job.left_s ? fmt::format("{}:{:02} left", left_s / 60, left_s % 60)
                                        : "– left";
  return fmt::format("{}, {:.0f} %, {}", frames, std::floor(100.0 * job.fraction), left);
}

void draw_film_queue(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "Queue");
  UniqueNames unique;
  bool any = false;
  for (const JobView& job : state.jobs) {
    if (job.film.empty()) continue;
    any = true;
    ImGui::PushID(static_cast<int>(job.id.value));
    draw_film(ui, job, unique(job.film.filename().string()), requests);
    ImGui::PopID();
  }
  if (!any) {
    empty_state(ui, icon::kFilm, "No films yet", "What is added to the queue on the page File is rendered here", {},
                ui.px(160));
  }
}

}  // namespace trocar::ui
