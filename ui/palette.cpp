#include "ui/palette.h"

#include <algorithm>

#include "ui/command_table.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {

void Palette::open() {
  open_ = focus_ = true;
  typed_.clear();
  chosen_ = 0;
}

namespace {

// A row: icon and title, the reason or the help dimmed, the keys at the right.
bool draw_row(Ui& ui, const CommandRow& row, const std::string& reason, bool chosen) {
  const float height = ui.px(30);
  const ImVec2 at = ImGui::GetCursorPos();
  const std::string keys(shown_keys(ui, row.id));
  const bool clicked = selectable_row(ui, row.title, chosen, reason.empty() ? "" : "disabled",
                                      {.shortcut = keys, .reason = reason, .height = height});
  const ImVec2 next = ImGui::GetCursorPos();
  const float y = at.y + 0.5F * (height - ImGui::GetTextLineHeight());
  const float right = ImGui::GetWindowContentRegionMax().x - ui.px(10);
  const float keys_width = ImGui::CalcTextSize(keys.c_str()).x;
  {
    const ColourScope colour(ImGuiCol_Text, reason.empty() ? ui.theme().text : ui.theme().text_disabled);
    ImGui::SetCursorPos({at.x + ui.px(10), y});
    if (row.icon != nullptr) ImGui::TextUnformatted(row.icon);
    ImGui::SetCursorPos({at.x + ui.px(38), y});
    ImGui::TextUnformatted(row.title.data(), row.title.data() + row.title.size());
  }
  const ColourScope dim(ImGuiCol_Text, ui.theme().text_dim);
  ImGui::SameLine(0.0F, ui.px(14));
  const std::string_view words = reason.empty() ? row.help : std::string_view(reason);
  const float room = right - keys_width - ui.px(14) - ImGui::GetCursorPosX();
  if (room > ui.px(60)) {
    ImGui::TextUnformatted(fitted(words, room).c_str());
  } else {
    ImGui::NewLine();
  }
  ImGui::SetCursorPos({right - keys_width, y});
  ImGui::TextUnformatted(keys.c_str());
  ImGui::SetCursorPos(next);
  return clicked;
}

}  // namespace

void Palette::draw_rows(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const auto rows = search_commands(typed_);
  const int last = static_cast<int>(rows.size()) - 1;
  const bool down = ui.input().pressed(Key::kDown);
  const bool up = ui.input().pressed(Key::kUp);
  chosen_ = std::clamp(chosen_ + (down ? 1 : 0) - (up ? 1 : 0), 0, std::max(last, 0));
  if (rows.empty()) dim_text(ui, "No command is called that");
  ImGui::BeginChild("rows");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), 0.0F});
  for (int i = 0; i <= last; ++i) {
    const CommandRow& row = *rows[static_cast<std::size_t>(i)];
    const std::string reason = row.reason_now(state);
    const bool clicked = draw_row(ui, row, reason, i == chosen_);
    if (i == chosen_ && (down || up)) ImGui::SetScrollHereY(0.5F);
    const bool entered = i == chosen_ && ui.input().pressed(Key::kEnter);
    if ((clicked || entered) && reason.empty()) {
      open_ = false;
      append(requests, row.run(state));
    }
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

Requests Palette::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (!open_) return requests;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5F * screen.x, 0.12F * screen.y}, ImGuiCond_Always, {0.5F, 0.0F});
  ImGui::SetNextWindowSize({std::min(ui.px(660), 0.9F * screen.x), std::min(ui.px(420), 0.7F * screen.y)});
  if (focus_) ImGui::SetNextWindowFocus();
  const ColourScope ground(ImGuiCol_WindowBg, mix(ui.theme().panel, ui.theme().raised, 0.35F));
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoScrollbar;
  ImGui::Begin("Palette", nullptr, kFlags);
  {
    const Scope scope(ui, "Palette");
    if (focus_) ImGui::SetKeyboardFocusHere();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(12), ui.px(9)});
    const std::string before = typed_;
    text_field(ui, "Command", typed_, "Type a command");
    ImGui::PopStyleVar();
    if (typed_ != before) chosen_ = 0;
    draw_rows(ui, state, requests);
  }
  const bool left = !focus_ && !ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
  if (left || ui.input().pressed(Key::kEscape)) open_ = false;
  focus_ = false;
  ImGui::End();
  return requests;
}

}  // namespace trocar::ui
