#include "ui/panels/review_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/command_table.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

constexpr std::array<std::string_view, 4> kVerdicts{"record.keep", "record.again", "record.next", "record.discard"};

void draw_verdicts(Ui& ui, const WorkbenchState& state, Requests& requests) {
  for (std::size_t i = 0; i < kVerdicts.size(); ++i) {
    const CommandRow& row = command(kVerdicts[i]);
    const std::string keys(shown_keys(ui, row.id));
    if (i > 0) flow(button_width(ui, row.title, row.icon, keys), ui.px(8));
    const ButtonStyle style = i == 0 ? ButtonStyle::kPrimary : i == 3 ? ButtonStyle::kQuiet : ButtonStyle::kNormal;
    const std::string reason = row.reason_now(state);
    if (button(ui, row.title,
               {.icon = row.icon,
                .says_keys = true,
                .help = row.help,
                .shortcut = keys,
                .reason = reason,
                .style = style})) {
      append(requests, row.run(state));
    }
  }
}

}  // namespace

void ReviewBar::draw(Ui& ui, const WorkbenchState& state, Requests& requests) {
  if (!state.take || !state.take->reviewing) return;
  const Scope scope(ui, "Take");
  const float most = 0.6F * ImGui::GetContentRegionAvail().y;
  const float height = std::min(std::max(height_, ImGui::GetFrameHeight() + ui.px(12)), most);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(6)});
  ImGui::BeginChild("Take", {0.0F, height}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  const std::string words = fmt::format("{}: {}", state.take->name, state.take->summary);
  wrapped_text(ui, words, ui.theme().text);
  draw_verdicts(ui, state, requests);
  const float needed = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y + ui.px(6) + ImGui::GetScrollY();
  if (std::abs(needed - height_) > 0.5F) ui.animate();
  height_ = needed;
  ImGui::EndChild();
}

}  // namespace trocar::ui
