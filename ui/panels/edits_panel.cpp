#include "ui/panels/edits_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/demonstration/edit_sentence.h"
#include "engine/demonstration/edit_words.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using demonstration::Demonstration;
using demonstration::Edit;
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

std::string name_of_entry(const StackEntry& entry) {
  return entry.name.empty() ? demonstration::title_of(demonstration::name_of(*entry.edit)) : entry.name;
}

/// What tells this edit from another one of its kind, below its name.
void draw_particulars(Ui& ui, const Edit& edit) {
  const std::string words = demonstration::particulars(edit);
  if (words.empty()) return;
  const FontScope font(ui.fonts().small);
  const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
  const float left = ImGui::GetCursorPosX() + ui.px(24);
  ImGui::SetCursorPos({left, ImGui::GetCursorPosY() - ui.px(4)});
  const std::string shown = fitted(words, ImGui::GetContentRegionAvail().x);
  ImGui::TextUnformatted(shown.c_str());
  note_item(ui, "text", "Particulars", words, {.help = shown == words ? std::string_view() : std::string_view(words)});
}

}  // namespace

void EditsPanel::begin_edit(const BeginEdit& asked, const WorkbenchState& state) {
  form_.begin(asked, state);
}

void EditsPanel::draw_choice(Ui& ui, const WorkbenchState& state) {
  static const std::vector<std::string> kTitles = titles_of_edits();
  form_label(ui, "New edit");
  combo(ui, "Kind of edit", kind_, kTitles, {.help = "What to do to the demonstration"});
  if (!button(
          ui, "Add edit…",
          {.icon = icon::kPlus, .help = "Set its parameters and see what it does", .reason = being_recorded(state)})) {
    return;
  }
  begin_edit({demonstration::default_edits()[static_cast<std::size_t>(kind_)]}, state);
}

void EditsPanel::draw_entry(Ui& ui, const WorkbenchState& state, const Demonstration& shown, int place,
                            Requests& requests) {
  const StackEntry& entry = (*shown.stack)[static_cast<std::size_t>(place)];
  const Scope scope(ui, fmt::format("{}", place + 1));
  bool enabled = entry.enabled;
  const std::string_view live = being_recorded(state);
  const std::string says = demonstration::sentence(*entry.edit, shown.name);
  if (checkbox(ui, name_of_entry(entry), enabled, {.help = says, .reason = live})) {
    requests.emplace_back(Command{CommitEdit{workbench::EnableStackEntry{shown.id, entry.id, enabled}}});
  }
  const int last = static_cast<int>(shown.stack->size()) - 1;
  const float tools = 4.0F * (ImGui::GetFrameHeight() + ui.px(4)) + 3.0F * ui.px(2);
  ImGui::SameLine(std::max(ImGui::GetWindowContentRegionMax().x - tools, ui.px(60)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(2), ui.px(4)});
  const auto tool = [&](std::string_view label, const char* sign, std::string_view help, std::string_view reason) {
    const std::string_view first = live.empty() ? reason : live;
    return icon_button(ui, label, {.icon = sign, .help = help, .reason = first, .style = ButtonStyle::kQuiet});
  };
  if (tool("Change", icon::kPencil, "Change its parameters", ""))
    form_.begin(*entry.edit, *state.project, shown, entry.id);
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
  draw_particulars(ui, *entry.edit);
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
  if (draw_no_project(ui, state, requests)) return requests;
  const auto shown = selected_demonstration(state);
  if (form_.open() && (shown == nullptr || shown->id != form_.demonstration())) form_.end(requests);
  if (shown == nullptr) {
    empty_state(ui, icon::kPencil, "Nothing to edit", "Select or record a demonstration", {});
    return requests;
  }
  if (form_.open()) {
    form_.draw(ui, state, requests);
  } else {
    draw_choice(ui, state);
  }
  ImGui::Dummy({0.0F, ui.px(6)});
  draw_stack(ui, state, *shown, requests);
  return requests;
}

}  // namespace trocar::ui
