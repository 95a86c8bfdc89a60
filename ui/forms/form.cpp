#include "ui/forms/form.h"

#include <algorithm>
#include <cmath>

#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {

// In the middle, a little above it: whole on the screen at any scale. Once its size is known it stays where it is, or
// where it was dragged to, as long as all of it can be seen.
void Form::place(Ui& ui) {
  constexpr int kSettles = 4;  // Frames.
  constexpr float kAbove = 0.42F;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 room{screen.x - 2.0F * ui.px(8), screen.y - 2.0F * ui.px(8)};
  const float wanted = height() > 0.0F ? std::min(ui.px(height()), room.y) : last_height_;
  const float top = ui.px(8) + kAbove * std::max(room.y - wanted, 0.0F);
  const bool settled = frames_ >= kSettles;
  const bool below = last_y_ + last_height_ > screen.y - ui.px(8) + 1.0F;
  ImGui::SetNextWindowPos({std::round(0.5F * screen.x), std::round(top)},
                          settled && !below ? ImGuiCond_Appearing : ImGuiCond_Always, {0.5F, 0.0F});
  ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, room);
  ImGui::SetNextWindowSize({std::min(ui.px(width()), room.x), std::min(ui.px(height()), room.y)}, ImGuiCond_Always);
  if (!settled) ui.animate();
  ++frames_;
}

Requests Form::draw_all(Ui& ui, const WorkbenchState& state) {
  if (!has_footer()) return draw_content(ui, state);
  const float margin = ImGui::GetStyle().WindowPadding.y;
  const float footer = ImGui::GetFrameHeight() + ui.px(8);
  const float most = ImGui::GetIO().DisplaySize.y - 2.0F * ui.px(8) - ImGui::GetCursorPosY() - footer - margin;
  const float height = content_height_ > 0.0F ? std::min(content_height_, most) : most;
  ImGui::BeginChild("content", {0.0F, height}, false, content_height_ > most ? 0 : ImGuiWindowFlags_NoScrollbar);
  Requests requests = draw_content(ui, state);
  const float needed = ImGui::GetCursorPosY() + ImGui::GetScrollY() - ImGui::GetStyle().ItemSpacing.y + ui.px(2);
  if (std::abs(needed - content_height_) > 0.5F) ui.animate();
  content_height_ = needed;
  ImGui::EndChild();
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y + ui.px(8));
  append(requests, draw_footer(ui, state));
  return requests;
}

Requests Form::draw(Ui& ui, const WorkbenchState& state) {
  if (!open_) return {};
  const bool first = opened_;
  if (first) prepare(state);
  opened_ = false;
  place(ui);
  if (first) ImGui::SetNextWindowFocus();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(18), ui.px(14)});
  const ColourScope ground(ImGuiCol_WindowBg, mix(ui.theme().panel, ui.theme().raised, 0.35F));
  Requests requests;
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                      ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
  if (ImGui::Begin(std::string(title()).c_str(), nullptr, kFlags)) {
    const Scope scope(ui, title());
    heading(ui, title());
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::GetFrameHeight());
    const bool crossed =
        icon_button(ui, "Close", {.icon = icon::kCross, .shortcut = "Escape", .style = ButtonStyle::kQuiet});
    ImGui::Dummy({0.0F, ui.px(2)});
    const bool keeps_escape = this->keeps_escape();
    requests = draw_all(ui, state);
    const bool escaped = !keeps_escape && ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) &&
                         ui.input().pressed(Key::kEscape);
    if (crossed || escaped) close();
  }
  last_height_ = ImGui::GetWindowSize().y;
  last_y_ = ImGui::GetWindowPos().y;
  ImGui::End();
  ImGui::PopStyleVar();
  return requests;
}

}  // namespace trocar::ui
