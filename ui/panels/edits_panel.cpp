#include "ui/panels/edits_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/demonstration/edit_sentence.h"
#include "engine/review/review.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using demonstration::Demonstration;
using demonstration::DemonstrationId;
using demonstration::Edit;
using demonstration::EditOption;
using demonstration::StackEntry;
using workbench::Command;
using workbench::CommitEdit;

std::vector<std::string> titles_of_edits() {
  std::vector<std::string> titles;
  for (const Edit& edit : demonstration::default_edits()) {
    titles.push_back(demonstration::title_of(demonstration::name_of(edit)));
  }
  return titles;
}

/// Where an edit is most likely wanted: over what is selected, else all between the gates; in the middle at the
/// playhead.
std::string likely(const EditOption& option, const Demonstration& shown, const WorkbenchState& state) {
  const double playhead_s = state.playhead_s;
  if (option.option == "from") return fmt::format("{:.3f}", state.selection ? state.selection->begin_s : shown.begin_s);
  if (option.option == "to") return fmt::format("{:.3f}", state.selection ? state.selection->end_s : shown.end_s);
  if (option.option == "clip-from") return fmt::format("{:.3f}", shown.begin_s);
  if (option.option == "clip-to") return fmt::format("{:.3f}", shown.end_s);
  if (option.option == "at") return fmt::format("{:.3f}", playhead_s);
  if (option.option == "block" && shown.block != demonstration::kUnknownPlace) return std::to_string(shown.block);
  if (option.option == "goal" && shown.goal != demonstration::kUnknownPlace) return std::to_string(shown.goal);
  return option.text;
}

/// A demonstration is chosen by name; its number behind it tells apart those of one name.
constexpr std::string_view kBeforeNumber = " · ";

std::string choice_of(const Demonstration& demonstration) {
  return fmt::format("{}{}{}", demonstration.name, kBeforeNumber, demonstration.id.value);
}

bool names_demonstration(const EditOption& option) {
  return option.option == "source";
}

/// In place of a bare number; one that the project does not have stays.
void offer_demonstrations(std::vector<EditOption>& options, const workbench::Project& project, DemonstrationId shown) {
  for (EditOption& option : options) {
    if (!names_demonstration(option)) continue;
    if (option.text == "0") option.text = std::to_string(shown.value);
    for (const auto& [id, demonstration] : project.demonstrations) {
      option.choices.push_back(choice_of(*demonstration));
      if (option.text == std::to_string(id.value)) option.text = option.choices.back();
    }
  }
}

bool names_model(const EditOption& option) {
  return option.option == "model";
}

/// Likewise; 0 leaves it to the segment.
void offer_models(std::vector<EditOption>& options, const workbench::Project& project) {
  for (EditOption& option : options) {
    if (!names_model(option)) continue;
    option.choices.push_back(fmt::format("Newest of the segment{}0", kBeforeNumber));
    if (option.text == "0") option.text = option.choices.back();
    for (const auto& [id, entry] : project.models) {
      option.choices.push_back(fmt::format("{}{}{}", entry->name, kBeforeNumber, id.value));
      if (option.text == std::to_string(id.value)) option.text = option.choices.back();
    }
  }
}

bool goes_by_policy(const std::vector<EditOption>& options) {
  return std::any_of(options.begin(), options.end(),
                     [](const EditOption& option) { return option.option == "shape" && option.text == "policy"; });
}

/// The points of a bridge are found where a policy gives them, and only there is a model of use.
bool is_of_use(const EditOption& option, bool policy) {
  return policy ? option.option != "via-mm" : !names_model(option);
}

Result<Edit> edit_of(std::string_view name, std::vector<EditOption> options) {
  const bool policy = goes_by_policy(options);
  for (EditOption& option : options) {
    if (policy && option.option == "via-mm") option.text.clear();
    const std::size_t at = option.text.rfind(kBeforeNumber);
    if ((names_demonstration(option) || names_model(option)) && at != std::string::npos) {
      option.text = option.text.substr(at + kBeforeNumber.size());
    }
  }
  return demonstration::edit_from_options(name, options);
}

std::string name_of_entry(const StackEntry& entry) {
  return entry.name.empty() ? demonstration::title_of(demonstration::name_of(*entry.edit)) : entry.name;
}

/// "2 errors, 5 warnings; before 3, 5".
std::string problems_with(const WorkbenchState& state) {
  using demonstration::Severity;
  const auto& after = state.preview_review;
  if (!after || after->of.document != state.preview->after) return "…";
  const auto counts = [](const workbench::ReviewView& view) {
    const auto& problems = view.review.problems;
    return std::pair{review::count_of(problems, Severity::kError), review::count_of(problems, Severity::kWarning)};
  };
  const auto [errors, warnings] = counts(*after);
  const std::string words = counted(errors, "error") + ", " + counted(warnings, "warning");
  if (!state.review) return words;
  const auto [errors_before, warnings_before] = counts(*state.review);
  return fmt::format("{}; before {}, {}", words, errors_before, warnings_before);
}

}  // namespace

void EditsPanel::begin(const Edit& edit, const workbench::Project& project, const Demonstration& shown,
                       std::int64_t entry) {
  draft_ =
      Draft{shown.id, entry, std::string(demonstration::name_of(edit)), demonstration::options_of(edit), {}, nullptr};
  offer_demonstrations(draft_->options, project, shown.id);
  offer_models(draft_->options, project);
}

void EditsPanel::begin_edit(const Edit& edit, const WorkbenchState& state) {
  const auto shown = selected_demonstration(state);
  if (shown == nullptr) return;
  begin(edit, *state.project, *shown, 0);
  for (EditOption& option : draft_->options) option.text = likely(option, *shown, state);
}

void EditsPanel::request_preview(Requests& requests) {
  const Result<Edit> edit = edit_of(draft_->name, draft_->options);
  draft_->problem = edit ? "" : edit.error().text();
  if (edit) requests.emplace_back(Command{workbench::PreviewEdit{*edit, draft_->entry}});
}

void EditsPanel::end(Requests& requests) {
  draft_.reset();
  requests.emplace_back(Command{workbench::EndPreview{}});
}

void EditsPanel::commit(Requests& requests) {
  const Result<Edit> edit = edit_of(draft_->name, draft_->options);
  if (!edit) return;
  const auto id = draft_->demonstration;
  if (draft_->entry == 0) {
    requests.emplace_back(Command{CommitEdit{workbench::EditDemonstration{id, *edit}}});
  } else {
    requests.emplace_back(Command{CommitEdit{workbench::ReplaceStackEntry{id, draft_->entry, *edit}}});
  }
  end(requests);
}

bool EditsPanel::draw_option(Ui& ui, EditOption& option) {
  const std::string label = option.unit.empty() ? option.label : fmt::format("{}, {}", option.label, option.unit);
  if (option.flag) {
    bool on = option.text == "yes";
    const bool changed = checkbox(ui, option.label, on, {.help = option.help});
    option.text = on ? "yes" : "no";
    return changed;
  }
  form_label(ui, label);
  if (option.choices.empty()) return text_field(ui, option.label, option.text, "", {.help = option.help});
  int chosen =
      static_cast<int>(std::find(option.choices.begin(), option.choices.end(), option.text) - option.choices.begin());
  if (!combo(ui, option.label, chosen, option.choices, {.help = option.help})) return false;
  option.text = option.choices[static_cast<std::size_t>(chosen)];
  return true;
}

void EditsPanel::draw_outcome(Ui& ui, const WorkbenchState& state) {
  if (!draft_->problem.empty()) return wrapped_text(ui, draft_->problem, ui.theme().danger);
  if (!state.preview) return dim_text(ui, "Working it out…");
  if (!state.preview->error.empty()) return wrapped_text(ui, state.preview->error, ui.theme().danger);
  const demonstration::Difference& difference = state.preview->difference;
  fact(ui, "Longer by", fmt::format("{:+.2f} s", difference.duration_change_s));
  fact(ui, "Moved", count(difference.moved) + " samples");
  fact(ui, "Furthest", fmt::format("{:.2f} mm", 1e3 * difference.max_deviation_m));
  fact(ui, "Problems", problems_with(state));
  for (const demonstration::SnapFigures& figures : state.preview->snap) {
    const char* tool = figures.arm == 0 ? "left" : "right";
    fact(ui, fmt::format("Actions, {}", tool), count(figures.actions));
    fact(ui, fmt::format("Error, {}", tool),
         fmt::format("max {:.2f}, mean {:.2f} mm", 1e3 * figures.max_error_m, 1e3 * figures.mean_error_m));
    fact(ui, fmt::format("Cells, {}", tool),
         fmt::format("{} skipped, {} repeated", figures.skipped_cells, figures.repeated_cells));
  }
}

void EditsPanel::draw_draft(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "Draft");
  heading(ui, demonstration::title_of(draft_->name));
  // Also when the demonstration has changed meanwhile, as by undo.
  const auto shown = selected_demonstration(state);
  bool changed = draft_->previewed != shown;
  draft_->previewed = shown;
  const bool policy = goes_by_policy(draft_->options);
  for (EditOption& option : draft_->options) {
    if (is_of_use(option, policy)) changed |= draw_option(ui, option);
  }
  if (changed) request_preview(requests);
  ImGui::Dummy({0.0F, ui.px(2)});
  draw_outcome(ui, state);
  ImGui::Dummy({0.0F, ui.px(2)});
  const bool impossible = !draft_->problem.empty() || (state.preview && !state.preview->error.empty());
  const bool apply = button(ui, draft_->entry == 0 ? "Apply" : "Change",
                            {.icon = icon::kVerify,
                             .help = "Commit the edit; it can be undone, changed and switched off",
                             .shortcut = "Enter",
                             .reason = impossible ? "The edit cannot be made as it is" : "",
                             .style = ButtonStyle::kPrimary});
  ImGui::SameLine();
  const bool cancel =
      button(ui, "Cancel", {.help = "Leave everything as it is", .shortcut = "Esc", .style = ButtonStyle::kQuiet});
  if (cancel || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) return end(requests);
  // Where no field is typed in and no widget is pressed by it.
  const bool entered =
      ui.input().pressed(Key::kEnter) && !ImGui::GetIO().WantTextInput && !ui.focus().shown() && !impossible;
  if (apply || entered) commit(requests);
}

void EditsPanel::draw_choice(Ui& ui, const WorkbenchState& state) {
  static const std::vector<std::string> kTitles = titles_of_edits();
  form_label(ui, "New edit");
  combo(ui, "Kind of edit", kind_, kTitles, {.help = "What to do to the demonstration"});
  const std::string why = state.live ? "A transfer is being recorded" : "";
  if (!button(ui, "Add edit…",
              {.icon = icon::kPlus, .help = "Set its parameters and see what it does", .reason = why})) {
    return;
  }
  begin_edit(demonstration::default_edits()[static_cast<std::size_t>(kind_)], state);
}

void EditsPanel::draw_entry(Ui& ui, const WorkbenchState& state, const Demonstration& shown, int place,
                            Requests& requests) {
  const StackEntry& entry = (*shown.stack)[static_cast<std::size_t>(place)];
  const Scope scope(ui, fmt::format("{}", place + 1));
  bool enabled = entry.enabled;
  if (checkbox(ui, name_of_entry(entry), enabled, {.help = demonstration::sentence(*entry.edit, shown.name)})) {
    requests.emplace_back(Command{CommitEdit{workbench::EnableStackEntry{shown.id, entry.id, enabled}}});
  }
  const int last = static_cast<int>(shown.stack->size()) - 1;
  const float tools = 4.0F * (ImGui::GetFrameHeight() + ui.px(4)) + 3.0F * ui.px(2);
  ImGui::SameLine(std::max(ImGui::GetWindowContentRegionMax().x - tools, ui.px(60)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(2), ui.px(4)});
  const auto tool = [&](std::string_view label, const char* sign, std::string_view help, std::string_view reason) {
    return icon_button(ui, label, {.icon = sign, .help = help, .reason = reason, .style = ButtonStyle::kQuiet});
  };
  if (tool("Change", icon::kPencil, "Change its parameters", "")) begin(*entry.edit, *state.project, shown, entry.id);
  ImGui::SameLine();
  if (tool("Earlier", icon::kArrowUp, "Apply it earlier", place == 0 ? "It is the first" : "")) {
    requests.emplace_back(Command{CommitEdit{workbench::MoveStackEntry{shown.id, entry.id, place - 1}}});
  }
  ImGui::SameLine();
  if (tool("Later", icon::kArrowDown, "Apply it later", place == last ? "It is the last" : "")) {
    requests.emplace_back(Command{CommitEdit{workbench::MoveStackEntry{shown.id, entry.id, place + 1}}});
  }
  ImGui::SameLine();
  if (tool("Remove", icon::kTrash, "Take it away; undo brings it back", "")) {
    requests.emplace_back(Command{CommitEdit{workbench::RemoveStackEntry{shown.id, entry.id}}});
  }
  ImGui::PopStyleVar();
  if (!entry.conflict.empty()) {
    wrapped_text(ui, fmt::format("{} Conflict, passed over: {}", icon::kWarning, entry.conflict), ui.theme().warning);
  }
}

void EditsPanel::draw_stack(Ui& ui, const WorkbenchState& state, const Demonstration& shown, Requests& requests) {
  const Scope scope(ui, "Stack");
  heading(ui, "Edits");
  if (shown.stack->empty())
    return wrapped_text(ui, "As it was recorded. Edits appear here, in their order", ui.theme().text_dim);
  for (int place = 0; place < static_cast<int>(shown.stack->size()); ++place) {
    ImGui::PushID(place);
    draw_entry(ui, state, shown, place, requests);
    ImGui::PopID();
  }
}

Requests EditsPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state)) return requests;
  const auto shown = selected_demonstration(state);
  if (draft_ && (shown == nullptr || shown->id != draft_->demonstration)) end(requests);
  if (shown == nullptr) {
    empty_state(ui, icon::kPencil, "Nothing to edit", "Select or record a demonstration", {});
    return requests;
  }
  if (draft_) {
    draw_draft(ui, state, requests);
  } else {
    draw_choice(ui, state);
  }
  ImGui::Dummy({0.0F, ui.px(6)});
  draw_stack(ui, state, *shown, requests);
  return requests;
}

}  // namespace trocar::ui
