#include "ui/panels/activity_panels.h"

#include <algorithm>
#include <map>
#include <string>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::HistoryNode;
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

namespace {

// The line from the root to HEAD; what is not on it is an abandoned or undone branch.
std::set<std::int64_t> line_to_head(const WorkbenchState& state) {
  std::map<std::int64_t, std::int64_t> parents;
  for (const HistoryNode& node : state.history) parents[node.id] = node.parent;
  std::set<std::int64_t> line;
  for (std::int64_t at = state.head; at != 0 && line.insert(at).second;) {
    const auto found = parents.find(at);
    at = found == parents.end() ? 0 : found->second;
  }
  return line;
}

bool draw_node(Ui& ui, const std::string& label, const std::string& name, std::string_view time, bool head,
               bool on_line) {
  const float height = ui.px(26);
  const ImVec2 at = ImGui::GetCursorPos();
  const std::string help = label + ": go to this state; nothing is lost";
  const bool clicked = selectable_row(ui, name, head, head ? "HEAD" : "", {.help = help, .height = height});
  const Rect rect = item_rect();
  const ImVec2 next = ImGui::GetCursorPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float x = rect.x0 + ui.px(12);
  const Rgba colour = head ? ui.theme().accent : on_line ? ui.theme().text_dim : ui.theme().text_disabled;
  list.AddRectFilled({x - 1.0F, rect.y0}, {x + 1.0F, rect.y1}, to_u32(ui.theme().line));
  if (on_line) {
    list.AddCircleFilled({x, rect.centre_y()}, ui.px(4), to_u32(colour), 12);
  } else {
    list.AddCircleFilled({x, rect.centre_y()}, ui.px(4), to_u32(ui.theme().panel), 12);
    list.AddCircle({x, rect.centre_y()}, ui.px(4), to_u32(colour), 12, 1.5F);
  }
  const float text_y = at.y + 0.5F * (height - ImGui::GetTextLineHeight()) - 1.0F;
  const float right = ImGui::GetWindowContentRegionMax().x - ui.px(4);
  const float clock = time.empty() ? 0.0F : ImGui::CalcTextSize(time.data(), time.data() + time.size()).x;
  ImGui::SetCursorPos({at.x + ui.px(26), text_y});
  {
    const ColourScope words(ImGuiCol_Text, on_line ? ui.theme().text : ui.theme().text_dim);
    ImGui::TextUnformatted(fitted(label, right - at.x - ui.px(36) - clock).c_str());
  }
  if (!time.empty()) {
    ImGui::SetCursorPos({right - clock, text_y});
    const ColourScope words(ImGuiCol_Text, ui.theme().text_dim);
    ImGui::TextUnformatted(time.data(), time.data() + time.size());
  }
  ImGui::SetCursorPos(next);
  return clicked;
}

// "2026-03-01T12:03:41Z" to "12:03".
std::string_view clock_of(std::string_view iso) {
  return iso.size() >= 16 && iso[10] == 'T' ? iso.substr(11, 5) : iso;
}

}  // namespace

Requests HistoryPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state)) return requests;
  if (state.history.empty()) {
    empty_state(ui, icon::kHistory, "", "Every edit appears here and can be undone, also tomorrow", {});
    return requests;
  }
  const std::set<std::int64_t> line = line_to_head(state);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), 0.0F});
  UniqueNames unique;
  for (auto it = state.history.rbegin(); it != state.history.rend(); ++it) {
    ImGui::PushID(static_cast<int>(it->id));
    const std::string& label = it->description.empty() ? it->name : it->description;
    if (draw_node(ui, label, unique(label), clock_of(it->time), it->id == state.head, line.contains(it->id)) &&
        it->id != state.head) {
      requests.emplace_back(Command{workbench::GoToHistory{it->id}});
    }
    ImGui::PopID();
  }
  if (draw_node(ui, "Empty project", unique("Empty project"), "", state.head == 0, true) && state.head != 0) {
    requests.emplace_back(Command{workbench::GoToHistory{0}});
  }
  ImGui::PopStyleVar();
  return requests;
}

}  // namespace trocar::ui
