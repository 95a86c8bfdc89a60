#include "ui/panels/problems_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/review/fixes.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using demonstration::Severity;
using review::Problem;
using workbench::Command;

struct SeverityLook {
  const char* sign;  ///< Each of another shape.
  const char* word;
  Rgba colour;
};

SeverityLook look_of(const Theme& theme, Severity severity) {
  switch (severity) {
    case Severity::kError:
      return {icon::kCross, "Error", theme.danger};
    case Severity::kWarning:
      return {icon::kWarning, "Warning", theme.warning};
    case Severity::kInfo:
      return {icon::kInfo, "Note", theme.text_dim};
  }
  return {icon::kInfo, "", theme.text};
}

std::string when(const Problem& problem) {
  return problem.begin_s == problem.end_s ? fmt::format("{:.2f} s", problem.begin_s)
                                          : fmt::format("{:.2f} – {:.2f} s", problem.begin_s, problem.end_s);
}

std::string summary(const std::vector<Problem>& problems) {
  return fmt::format("{}, {}, {}", counted(review::count_of(problems, Severity::kError), "error"),
                     counted(review::count_of(problems, Severity::kWarning), "warning"),
                     counted(review::count_of(problems, Severity::kInfo), "note"));
}

bool draw_row(Ui& ui, const Problem& problem, const std::string& name, bool selected) {
  const SeverityLook look = look_of(ui.theme(), problem.severity);
  const float line = ImGui::GetTextLineHeight();
  const float height = 2.0F * line + ui.px(10);
  const ImVec2 at = ImGui::GetCursorPos();
  const std::string help = problem.message + ": go there";
  const bool clicked = selectable_row(ui, name, selected, fmt::format("{} {}", look.word, when(problem)),
                                      {.help = help, .height = height});
  const ImVec2 next = ImGui::GetCursorPos();
  const float left = at.x + ui.px(6);
  const float right = ImGui::GetWindowContentRegionMax().x - ui.px(6);
  ImGui::SetCursorPos({left, at.y + ui.px(4)});
  {
    const ColourScope colour(ImGuiCol_Text, look.colour);
    ImGui::TextUnformatted(look.sign);
    ImGui::SetCursorPos({left + ui.px(22), at.y + ui.px(4)});
    ImGui::TextUnformatted(look.word);
  }
  const float words = left + ui.px(32) + ImGui::CalcTextSize(look.word).x;
  const std::string time = fitted(when(problem), right - words);
  ImGui::SetCursorPos({right - ImGui::CalcTextSize(time.c_str()).x, at.y + ui.px(4)});
  {
    const ColourScope dim(ImGuiCol_Text, ui.theme().text_dim);
    ImGui::TextUnformatted(time.c_str());
  }
  ImGui::SetCursorPos({left + ui.px(22), at.y + ui.px(6) + line});
  ImGui::TextUnformatted(fitted(problem.message, right - left - ui.px(22)).c_str());
  ImGui::SetCursorPos(next);
  return clicked;
}

}  // namespace

void ProblemsPanel::follow(const WorkbenchState& state, Requests& requests) {
  if (seen_ == state.review) return;
  seen_ = state.review;
  selected_.clear();
  if (previewed_.empty()) return;
  previewed_.clear();
  requests.emplace_back(Command{workbench::EndPreview{}});
}

void ProblemsPanel::draw_simulation(Ui& ui, const WorkbenchState& state) const {
  if (!state.simulation) return;
  const Scope scope(ui, "Simulation");
  const workbench::SimulationView& found = *state.simulation;
  ImGui::Dummy({0.0F, ui.px(2)});
  if (!found.error.empty()) {
    badge(ui, icon::kWarning, "Not simulated", ui.theme().warning);
    return wrapped_text(ui, found.error, ui.theme().text);
  }
  if (!found.result) {
    badge(ui, icon::kSpinner, "Simulating", ui.theme().accent);
    return ui.animate();
  }
  if (found.result->transferred()) {
    badge(ui, icon::kVerify, "Transferred in the simulator", ui.theme().good);
  } else {
    badge(ui, icon::kCross, "Not transferred in the simulator", ui.theme().danger);
  }
  wrapped_text(ui, found.result->sentence, ui.theme().text);
}

void ProblemsPanel::draw_fix(Ui& ui, const WorkbenchState& state, const Problem& problem, Requests& requests) {
  if (problem.fix.empty()) return wrapped_text(ui, "No quick fix", ui.theme().text_dim);
  const Result<demonstration::Edit> edit = review::edit_of_fix(problem);
  if (!edit) return wrapped_text(ui, edit.error().text(), ui.theme().danger);
  wrapped_text(ui, "Fix: " + problem.fix, ui.theme().text_dim);
  const std::string why = state.live             ? std::string(being_recorded(state))
                          : state.review_pending ? "The problems are being worked out"
                                                 : "";
  if (previewed_ != problem.id) {
    if (!button(ui, "Fix…",
                {.icon = icon::kPencil, .help = "See what the fix does before it is made", .reason = why})) {
      return;
    }
    previewed_ = problem.id;
    requests.emplace_back(Command{workbench::PreviewEdit{*edit, 0}});
    return;
  }
  const bool known = state.preview != nullptr;
  const std::string impossible = known ? state.preview->error : "";
  if (!known) dim_text(ui, "Working it out…");
  if (!impossible.empty()) wrapped_text(ui, impossible, ui.theme().danger);
  if (known && impossible.empty()) {
    const demonstration::Difference& difference = state.preview->difference;
    fact(ui, "Longer by", fmt::format("{:+.2f} s", difference.duration_change_s));
    fact(ui, "Moved", count(difference.moved) + " samples");
    fact(ui, "Furthest", fmt::format("{:.2f} mm", 1e3 * difference.max_deviation_m));
  }
  const bool apply = button(ui, "Apply fix",
                            {.icon = icon::kVerify,
                             .help = "Commit the edit; it can be undone, changed and switched off",
                             .reason = !why.empty()         ? std::string_view(why)
                                       : impossible.empty() ? std::string_view()
                                                            : std::string_view("The edit cannot be made as it is"),
                             .style = ButtonStyle::kPrimary});
  flow(button_width(ui, "Cancel", nullptr), ui.px(8));
  const bool cancel =
      button(ui, "Cancel", {.help = "Leave everything as it is", .shortcut = "Esc", .style = ButtonStyle::kQuiet});
  if (!apply && !cancel && !ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) return;
  previewed_.clear();
  if (apply)
    requests.emplace_back(Command{workbench::CommitEdit{workbench::EditDemonstration{state.demonstration, *edit}}});
  requests.emplace_back(Command{workbench::EndPreview{}});
}

void ProblemsPanel::draw_problem(Ui& ui, const WorkbenchState& state, const Problem& problem, Requests& requests) {
  const Scope scope(ui, problem.id);
  ImGui::Indent(ui.px(28));
  ImGui::Dummy({0.0F, ui.px(1)});
  // The row says it already where there is room for all of it.
  if (ImGui::CalcTextSize(problem.message.c_str()).x > ImGui::GetContentRegionAvail().x - ui.px(6)) {
    wrapped_text(ui, problem.message, ui.theme().text);
  }
  draw_fix(ui, state, problem, requests);
  ImGui::Dummy({0.0F, ui.px(4)});
  ImGui::Unindent(ui.px(28));
}

void ProblemsPanel::draw_list(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "List");
  UniqueNames unique;
  // Errors first, each kind in the order of time.
  std::vector<const Problem*> order;
  for (const Problem& problem : state.review->review.problems) order.push_back(&problem);
  std::stable_sort(order.begin(), order.end(),
                   [](const Problem* a, const Problem* b) { return a->severity > b->severity; });
  for (const Problem* each : order) {
    const Problem& problem = *each;
    ImGui::PushID(problem.id.c_str());
    const bool selected = problem.id == selected_;
    if (draw_row(ui, problem, unique(problem.message), selected)) {
      selected_ = problem.id;
      if (!previewed_.empty() && previewed_ != problem.id) {
        previewed_.clear();
        requests.emplace_back(Command{workbench::EndPreview{}});
      }
      requests.emplace_back(Command{workbench::SetPlayhead{problem.begin_s}});
      if (problem.end_s > problem.begin_s) {
        requests.emplace_back(Command{workbench::SetSelection{workbench::TimeSpan{problem.begin_s, problem.end_s}}});
      }
    }
    if (selected) draw_problem(ui, state, problem, requests);
    ImGui::PopID();
  }
}

void draw_summary(Ui& ui, const std::string& words) {
  const FontScope font(ui.fonts().small);
  const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
  ImGui::TextUnformatted(words.c_str());
  note_item(ui, "text", "Summary", words, {});
}

Requests ProblemsPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  follow(state, requests);
  if (selected_demonstration(state) == nullptr) {
    empty_state(ui, icon::kWarning, "Nothing to check", "Select or record a demonstration", {});
    return requests;
  }
  command_button(ui, state, "demo.fix_all", "Fix all", ButtonStyle::kNormal, requests);
  flow(button_width(ui, "Simulate", icon::kChip), ui.px(8));
  command_button(ui, state, "demo.simulate", "Simulate", ButtonStyle::kNormal, requests);
  draw_simulation(ui, state);
  if (!state.review) {
    empty_state(ui, icon::kClock, "", "Checking the demonstration", {});
    ui.animate();
    return requests;
  }
  const std::vector<Problem>& problems = state.review->review.problems;
  const bool nothing = problems.empty() && !state.review_pending;
  if (!nothing) draw_summary(ui, state.review_pending ? "Checking again" : summary(problems));
  if (!state.review->incomplete.empty()) wrapped_text(ui, state.review->incomplete, ui.theme().warning);
  if (nothing) {
    empty_state(ui, icon::kVerify, "0 problems", "Nothing was found that should not be learned from", {});
    return requests;
  }
  draw_list(ui, state, requests);
  return requests;
}

}  // namespace trocar::ui
