#include "ui/forms/form.h"

#include <algorithm>

#include "ui/icons.h"

namespace trocar::ui {

Requests Form::draw(Ui& ui, const WorkbenchState& state) {
  if (!open_) return {};
  const bool first = opened_;
  if (first) prepare(state);
  opened_ = false;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  // Whole on the screen at any scale; what does not fit can be scrolled to.
  const ImVec2 room{screen.x - 2.0F * ui.px(8), screen.y - 2.0F * ui.px(8)};
  const float wanted = height() > 0.0F ? std::min(ui.px(height()), room.y) : last_height_;
  const float top = std::clamp(0.24F * screen.y, ui.px(8), std::max(screen.y - ui.px(8) - wanted, ui.px(8)));
  const bool moved_up = top < 0.24F * screen.y;
  ImGui::SetNextWindowPos({0.5F * screen.x, top}, moved_up ? ImGuiCond_Always : ImGuiCond_Appearing, {0.5F, 0.0F});
  ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, room);
  ImGui::SetNextWindowSize({std::min(ui.px(width()), room.x), ui.px(height())}, ImGuiCond_Always);
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
    requests = draw_content(ui, state);
    const bool escaped = !keeps_escape && ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) &&
                         ui.input().pressed(Key::kEscape);
    if (crossed || escaped) close();
  }
  last_height_ = ImGui::GetWindowSize().y;
  ImGui::End();
  ImGui::PopStyleVar();
  return requests;
}

}  // namespace trocar::ui
