#include "ui/status_line.h"

#include <algorithm>
#include <string_view>

#include "ui/format.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

float mono_width(const Ui& ui, const std::string& words) {
  const FontScope mono(ui.fonts().mono);
  return ImGui::CalcTextSize(words.c_str()).x;
}

/// The sentence at the left and the last command at the right; where both are too long, the sentence gets more.
struct StatusRoom {
  float sentence = 0.0F;  ///< Pixels.
  float command = 0.0F;
};

StatusRoom status_room(const Ui& ui, float room, const std::string& sentence, const std::string& command) {
  if (command.empty()) return {room, 0.0F};
  constexpr float kCommandShare = 0.42F;
  const float both = room - ui.px(24);
  const float wanted = ImGui::CalcTextSize(sentence.c_str()).x + 1.0F;
  const float width = std::min(mono_width(ui, command) + 1.0F, std::max(kCommandShare * both, both - wanted));
  return {both - width, width};
}

void draw_last_command(Ui& ui, const StatusLine& line, ImVec2 end, float top, float width, Requests& requests) {
  const float copy = ui.px(26);
  ImGui::SetCursorPos({end.x - copy, top + ui.px(1)});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(4), 0.5F * (copy - ImGui::GetFontSize())});
  if (icon_button(ui, "Copy as command",
                  {.icon = icon::kCopy,
                   .help = "Copy the last act as a command line",
                   .shortcut = shown_keys(ui, "help.copy_command"),
                   .width = copy,
                   .style = ButtonStyle::kQuiet})) {
    requests.emplace_back(UiAction::kCopyCommand);
  }
  ImGui::PopStyleVar();
  const FontScope mono(ui.fonts().mono);
  const std::string words = fitted(line.last_command, width);
  ImGui::SetCursorPos({end.x - copy - ui.px(8) - ImGui::CalcTextSize(words.c_str()).x, end.y});
  const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
  ImGui::TextUnformatted(words.c_str());
  note_item(ui, "text", "Last command", line.last_command, {.help = line.last_command});
}

/// What the tool in hand does, and what its modifiers do; "" if none is in hand.
std::string_view tool_hint(const WorkbenchState& state) {
  using workbench::GizmoKind;
  if (state.live && state.take && !state.take->reviewing) {
    switch (state.take->request.options.mode) {
      case trial::HandMode::kContinuous:
        return "W S A D E Q (I K J L O U) move while held, C (N) jaws; Shift: finely, V: clutch, P: pause, R: end";
      case trial::HandMode::kStep:
        return "W S A D E Q (I K J L O U) move by one cell, C (N) jaws; V: clutch, P: pause, R: end";
      case trial::HandMode::kWaypoint:
        return "Set the place by keys or mouse, Enter goes there, C (N) jaws; Shift: finely, P: pause, R: end";
    }
  }
  if (state.gizmo.kind == GizmoKind::kMove) {
    return "Drag an arrow or a square; X Y Z: one axis, Ctrl: whole cells, wheel: how far in time, Esc: put it down";
  }
  if (state.gizmo.kind == GizmoKind::kTurn) {
    return "Drag a ring; X Y Z: one axis, Ctrl: whole steps, wheel: how far in time, Esc: put it down";
  }
  return {};
}

std::string project_words(const WorkbenchState& state) {
  using workbench::LoadState;
  if (state.load == LoadState::kLoading) return "Opening " + shown_path(state.path);
  if (state.load == LoadState::kFailed) return "Could not open " + shown_path(state.path);
  return state.project == nullptr ? std::string("No project") : shown_path(state.path);
}

}  // namespace

float status_line_height(const Ui& ui) {
  return ui.px(28);
}

Requests draw_status_line(Ui& ui, const WorkbenchState& state, const StatusLine& line) {
  Requests requests;
  const Scope scope(ui, "Status");
  const FontScope font(ui.fonts().small);
  const float top = ImGui::GetCursorPosY();
  const float y = top + 0.5F * (status_line_height(ui) - ImGui::GetTextLineHeight());
  const float right = ImGui::GetWindowWidth() - ui.px(10);
  const std::string project = project_words(state);
  const std::string tool(tool_hint(state));
  const std::string& still = line.hint.empty() ? tool : line.hint;
  const bool tells = !line.done.empty() && (still.empty() || line.just_done);
  const std::string hint = tells ? line.done : still.empty() ? project : still;
  const float copy = line.last_command.empty() ? 0.0F : ui.px(26) + ui.px(8);
  const StatusRoom room = status_room(ui, right - ui.px(12) - copy, hint, line.last_command);
  const std::string shown = fitted(hint, room.sentence);
  ImGui::SetCursorPos({ui.px(12), y});
  {
    const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
    ImGui::TextUnformatted(shown.c_str());
    note_item(ui, "text", "Hint", hint, {.help = shown == hint ? std::string_view{} : std::string_view(hint)});
  }
  if (!line.last_command.empty()) draw_last_command(ui, line, {right, y}, top, room.command, requests);
  return requests;
}

}  // namespace trocar::ui
