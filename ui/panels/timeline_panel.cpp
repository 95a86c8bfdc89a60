#include "ui/panels/timeline_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"
#include "ui/panels/time_snap.h"
#include "ui/panels/timeline_marks.h"

namespace trocar::ui {
namespace {

using workbench::Command;

constexpr float kSpeedWidth = 266.0F;  // Of the speeds and Fit, at 100 %.

std::string trim_words(double in_s, double out_s) {
  return fmt::format("{:.2f}–{:.2f} s, {:.2f} s long", in_s, out_s, out_s - in_s);
}

}  // namespace

void TimelinePanel::fit(const WorkbenchState& state, const demonstration::Demonstration& shown) {
  if (fitted_ != state.demonstration) {
    fitted_ = state.demonstration;
    mouse_.reset();
  }
  time_->follow(state.demonstration.value, length_of(shown));
}

void TimelinePanel::draw_transport(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown,
                                   Requests& requests) {
  command_icon(ui, state, "transport.begin", requests);
  ImGui::SameLine(0.0F, ui.px(2));
  const bool playing = state.play_speed != 0.0;
  const CommandRow& play = command("transport.play");
  if (icon_button(
          ui, playing ? "Pause" : "Play",
          {.icon = playing ? icon::kPause : icon::kPlay, .help = play.help, .shortcut = shown_keys(ui, play.id)})) {
    append(requests, play.run(state));
  }
  ImGui::SameLine(0.0F, ui.px(2));
  command_icon(ui, state, "transport.end", requests);
  draw_time(ui, state, shown);
  draw_speed(ui, state, shown, requests);
}

void TimelinePanel::draw_time(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown) const {
  const std::string time = fmt::format("{:.3f} s", state.playhead_s);
  {
    const FontScope font(ui.fonts().strong);
    flow(ImGui::CalcTextSize(time.c_str()).x, ui.px(14));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(time.c_str());
    note_item(ui, "text", "Playhead", fmt::format("{:.3f}", state.playhead_s), {});
  }
  const bool trimming = mouse_.trims();
  const std::string words = trimming ? "Trim to " + trim_words(mouse_.gate_in_s(shown), mouse_.gate_out_s(shown))
                                     : "of " + seconds(shown.end_s) + ", " + shown.name;
  const float used = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + ui.px(8);
  const float room = ImGui::GetWindowContentRegionMax().x - used - ui.px(kSpeedWidth + 8.0F);
  // A word or two at least; what it says is in the inspector, too.
  if (room < ui.px(60) && !trimming) return;
  ImGui::SameLine(0.0F, ui.px(8));
  ImGui::AlignTextToFramePadding();
  const ColourScope colour(ImGuiCol_Text, trimming ? ui.theme().accent : ui.theme().text_dim);
  ImGui::TextUnformatted(fitted(words, std::max(room, ui.px(60))).c_str());
}

void TimelinePanel::draw_speed(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown,
                               Requests& requests) {
  const float width = ui.px(kSpeedWidth);
  if (ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + ui.px(8) + width <= ImGui::GetWindowContentRegionMax().x) {
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
  }
  static const std::array<std::string, 4> kNames{"0.25×", "0.5×", "1×", "2×"};
  constexpr std::array<double, 4> kSpeeds{0.25, 0.5, 1.0, 2.0};
  int chosen = -1;
  for (int i = 0; i < 4; ++i) {
    if (kSpeeds[static_cast<std::size_t>(i)] == state.play_speed) chosen = i;
  }
  if (segmented(ui, "Speed", chosen, kNames, {.help = "Play at this speed", .width = width - ui.px(84)})) {
    requests.emplace_back(Command{workbench::Play{kSpeeds[static_cast<std::size_t>(chosen)]}});
  }
  const bool roomy =
      ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + ui.px(84) <= ImGui::GetWindowContentRegionMax().x;
  WidgetOptions fit{.icon = icon::kExpand, .help = "Show the whole demonstration", .style = ButtonStyle::kQuiet};
  if (roomy) fit.width = ui.px(76);
  flow(roomy ? fit.width : ImGui::GetFrameHeight() + ui.px(4), ui.px(8));
  if (roomy ? button(ui, "Fit", fit) : icon_button(ui, "Fit", fit)) {
    time_->show(shown.begin_s, shown.end_s);
  }
}

void TimelinePanel::draw_lane_area(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown,
                                   Requests& requests) {
  ImVec2 room = ImGui::GetContentRegionAvail();
  room.y = std::max(room.y, lanes_height(ui, lanes_));
  const bool hovered =
      canvas(ui, "Lanes", room, trim_words(mouse_.gate_in_s(shown), mouse_.gate_out_s(shown)),
             {.help = "Drag to select, Shift extends, click for the playhead; wheel zooms, right drag shifts"});
  const LaneLayout layout = lay_out(ui, item_rect(), range_);
  const TimelineGround ground{state, shown, layout, places_of(shown, data_.events()), length_of(shown)};
  mouse_.take(ui, ground, hovered, range_, requests);
  LaneLayout now = lay_out(ui, item_rect(), range_);
  now.gate_in_s = mouse_.gate_in_s(shown);
  now.gate_out_s = mouse_.gate_out_s(shown);
  data_.update(shown, range_, std::max(static_cast<int>(now.lanes.width() / 2.0F), 1));
  if (data_.pending()) ui.animate();
  ImGui::PushClipRect({now.names.x0, now.ruler.y0}, {item_rect().x1, item_rect().y1}, true);
  draw_ruler(ui, now);
  // Also while they are worked out anew: most of them stay. While an edit is made, those of what it would leave.
  const auto& review = state.preview && state.preview_review ? state.preview_review : state.review;
  const bool reviewed = review && review->of.document && review->of.document->id == shown.id;
  draw_lanes(ui, now, lanes_, shown, data_,
             reviewed ? std::span<const review::Problem>(review->review.problems) : std::span<const review::Problem>());
  draw_gaps(ui, now, data_.gaps());
  draw_gates(ui, now, mouse_.drag());
  if (state.selection) draw_selection(ui, now, *state.selection);
  if (const auto zoomed = mouse_.zoomed()) draw_zoomed(ui, now, *zoomed);
  draw_playhead(ui, now, state.playhead_s);
  if (const auto snapped = mouse_.snapped_s()) draw_snap(ui, now, *snapped);
  ImGui::PopClipRect();
}

// Menus and forms close on Escape, and fields give up what was typed: the selection stays then.
bool TimelinePanel::escapes(const Ui& ui) const {
  const bool open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  return ui.input().pressed(Key::kEscape) && !open && !ImGui::GetIO().WantTextInput &&
         mouse_.drag() == TimelineMouse::Drag::kNone;
}

Requests TimelinePanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state)) return requests;
  if (state.live) {
    empty_state(ui, icon::kRecord, "Recording", "The transfer appears here when it ends", {});
    return requests;
  }
  const auto shown = selected_demonstration(state);
  if (shown == nullptr || shown->gated().empty()) {
    const std::string reason = command("demo.record").reason_now(state);
    const std::array<EmptyStateAction, 1> actions{{{"Record…", icon::kRecord, reason, "Record a transfer"}}};
    const std::string_view sentence = "Select a demonstration in the library, or record one";
    if (empty_state(ui, icon::kSliders, "Nothing to show over time", sentence, actions) == 0) {
      requests.emplace_back(UiAction::kShowRecord);
    }
    return requests;
  }
  fit(state, *shown);
  const bool escaped = escapes(ui);
  if (escaped && state.selection) requests.emplace_back(Command{workbench::SetSelection{}});
  draw_transport(ui, state, *shown, requests);
  LaneSet lanes = ~LaneSet(time_->hidden_lanes);
  tools_.draw(ui, state, *shown, lanes, requests);
  time_->hidden_lanes = static_cast<std::uint32_t>((~lanes).to_ulong());
  lanes_ = lanes;
  ImGui::Dummy({0.0F, ui.px(1)});
  draw_lane_area(ui, state, *shown, requests);
  return requests;
}

}  // namespace trocar::ui
