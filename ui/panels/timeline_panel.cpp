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
constexpr float kLeastLanes = 72.0F;   // Of the height that lanes are scrolled in.

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
  // At rest: the speed that playing begins with.
  const double shown_speed = state.play_speed == 0.0 ? 1.0 : state.play_speed;
  int chosen = -1;
  for (int i = 0; i < 4; ++i) {
    if (kSpeeds[static_cast<std::size_t>(i)] == shown_speed) chosen = i;
  }
  if (segmented(ui, "Speed", chosen, kNames,
                {.help = "Play at this speed", .width = width - ui.px(84), .again = true})) {
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

void TimelinePanel::ask(const Ui& ui, const LaneLayout& layout, Requests& requests) {
  time_->want_curves(curves_of(lanes_));
  const workbench::ShowFilmstrip wanted =
      has(lanes_, Lane::kPictures) ? pictures_for(ui, layout) : workbench::ShowFilmstrip{};
  if (wanted == asked_) return;
  asked_ = wanted;
  requests.emplace_back(Command{wanted});
}

void TimelinePanel::scroll_lanes(Ui& ui, const LaneLayout& layout, float content, bool hovered) {
  const float room = layout.lanes.height();
  const float most = std::max(content - room, 0.0F);
  scroll_ = std::clamp(scroll_, 0.0F, most);
  if (most <= 0.0F) return grabbed_.reset();
  const ImGuiIO& io = ImGui::GetIO();
  const Rect bar{layout.lanes.x1 + ui.px(2), layout.lanes.y0, layout.lanes.x1 + ui.px(10), layout.lanes.y1};
  const float thumb = std::max(room * room / content, ui.px(16));
  const float way = bar.height() - thumb;
  const float at = bar.y0 + way * scroll_ / most;
  if (hovered && layout.names.contains(io.MousePos.x, io.MousePos.y)) scroll_ -= ui.px(28) * io.MouseWheel;
  if (ImGui::IsItemActivated() && io.MousePos.x >= bar.x0) {
    const float held = io.MousePos.y - at;
    grabbed_ = held >= 0.0F && held <= thumb ? held : 0.5F * thumb;
  }
  if (!ImGui::IsItemActive()) grabbed_.reset();
  if (grabbed_ && way > 0.0F) scroll_ = (io.MousePos.y - *grabbed_ - bar.y0) / way * most;
  scroll_ = std::clamp(scroll_, 0.0F, most);
  const float shown = std::round(bar.y0 + way * scroll_ / most);
  const bool lit = grabbed_ || (hovered && bar.contains(io.MousePos.x, io.MousePos.y));
  ImGui::GetWindowDrawList()->AddRectFilled({bar.x0, shown}, {bar.x1, shown + thumb},
                                            to_u32(lit ? ui.theme().text_dim : ui.theme().text_disabled), ui.px(4));
  note_rect(ui, "slider", "Scroll lanes", fmt::format("{:.0f}", scroll_), {bar.x0, shown, bar.x1, shown + thumb},
            {.help = "Drag to see the other lanes; or turn the wheel over their names"});
}

bool TimelinePanel::take_ruler_unit(Ui& ui, const LaneLayout& layout, bool hovered) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Rect rect{layout.names.x0, layout.ruler.y0, layout.names.x1 - ui.px(4), layout.ruler.y1};
  const bool over = hovered && rect.contains(mouse.x, mouse.y);
  if (ImGui::IsItemActivated()) unit_held_ = over;
  if (ImGui::IsItemDeactivated() && unit_held_ && over) time_->ruler = next(time_->ruler);
  const bool held = unit_held_;
  if (!ImGui::IsItemActive()) unit_held_ = false;
  ImGui::GetWindowDrawList()->AddRectFilled({rect.x0, rect.y0 + ui.px(2)}, {rect.x1, rect.y1 - ui.px(2)},
                                            to_u32(over ? ui.theme().hover : ui.theme().raised), ui.px(3));
  const FontScope font(ui.fonts().small);
  const std::string words = fmt::format("{}", title_of(time_->ruler));
  ImGui::GetWindowDrawList()->AddText({rect.x0 + ui.px(6), std::round(rect.centre_y() - 0.5F * ImGui::GetFontSize())},
                                      to_u32(ui.theme().text), words.c_str());
  const CommandRow& row = command("transport.ruler");
  const std::string keys(shown_keys(ui, row.id));
  if (over) ui.set_hint(fmt::format("{}: {} ({})", row.title, row.help, keys));
  note_rect(ui, "button", "Ruler", words, rect, {.help = row.help, .shortcut = keys});
  return held || over;
}

void TimelinePanel::draw_lane_area(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown,
                                   Requests& requests) {
  ImVec2 room = ImGui::GetContentRegionAvail();
  const float content = lanes_height(ui, lanes_);
  room.y = std::max(room.y, lanes_head(ui) + std::min(content, ui.px(kLeastLanes)));
  const bool hovered =
      canvas(ui, "Lanes", room, trim_words(mouse_.gate_in_s(shown), mouse_.gate_out_s(shown)),
             {.help = "Drag to select, Shift extends, click for the playhead; wheel zooms, right drag shifts"});
  const Rect area = item_rect();
  const LaneLayout layout = lay_out(ui, area, range_, scroll_);
  scroll_lanes(ui, layout, content, hovered);
  const bool over_names = layout.names.contains(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
  const TimelineGround ground{state, shown, layout, places_of(shown, data_.events()), length_of(shown)};
  const bool on_unit = take_ruler_unit(ui, layout, hovered);
  if (!grabbed_ && !on_unit) mouse_.take(ui, ground, hovered && !over_names, range_, requests);
  LaneLayout now = lay_out(ui, area, range_, scroll_);
  now.gate_in_s = mouse_.gate_in_s(shown);
  now.gate_out_s = mouse_.gate_out_s(shown);
  data_.update(shown, range_, std::max(static_cast<int>(now.lanes.width() / 2.0F), 1));
  ask(ui, now, requests);
  if (data_.pending()) ui.animate();
  ImGui::PushClipRect({now.names.x0, now.ruler.y0}, {area.x1, area.y1}, true);
  draw_ruler(ui, now, time_->ruler, data_.grid_steps());
  // Also while they are worked out anew: most of them stay. While an edit is made, those of what it would leave.
  const auto& review = state.preview && state.preview_review ? state.preview_review : state.review;
  const bool reviewed = review && review->of.document && review->of.document->id == shown.id;
  LaneGround drawn{shown, data_, {}, nullptr, state.filmstrip};
  if (reviewed) drawn.problems = review->review.problems;
  if (state.curves && state.curves->of.shown && state.curves->of.shown->id == shown.id)
    drawn.curves = state.curves.get();
  draw_lanes(ui, now, lanes_, drawn);
  draw_gaps(ui, now, data_.gaps());
  draw_gates(ui, now, mouse_.drag());
  if (state.selection) draw_selection(ui, now, *state.selection);
  if (const auto zoomed = mouse_.zoomed()) draw_zoomed(ui, now, *zoomed);
  draw_playhead(ui, now, state.playhead_s);
  if (const auto snapped = mouse_.snapped_s()) draw_snap(ui, now, *snapped);
  ImGui::PopClipRect();
}

void TimelinePanel::draw_live(Ui& ui, const WorkbenchState& state) {
  const double recorded_s = state.live_trace ? state.live_trace->points.back().t_s : 0.0;
  {
    const FontScope font(ui.fonts().strong);
    text(ui, fmt::format("{:.1f} s", recorded_s));
  }
  ImGui::SameLine(0.0F, ui.px(8));
  dim_text(ui, state.take && state.take->reviewing ? "Recorded, not kept yet" : "Recording");
  ImVec2 room = ImGui::GetContentRegionAvail();
  const LaneSet lanes = live_lanes();
  room.y = std::max(room.y, lanes_head(ui) + std::min(lanes_height(ui, lanes), ui.px(kLeastLanes)));
  const bool hovered = canvas(ui, "Live lanes", room, fmt::format("{:.1f} s", recorded_s), {});
  const Rect area = item_rect();
  // A view of ten seconds at first, then of all; it grows in steps, so that lanes do not shrink all the time.
  constexpr double kLeast_s = 10.0;
  const double shown_s = kLeast_s * std::exp2(std::ceil(std::log2(std::max(recorded_s / kLeast_s, 1.0))));
  const TimeRange range{0.0, shown_s};
  scroll_lanes(ui, lay_out(ui, area, range, scroll_), lanes_height(ui, lanes), hovered);
  LaneLayout layout = lay_out(ui, area, range, scroll_);
  layout.gate_out_s = recorded_s;
  live_.update(state.live_trace, range, std::max(static_cast<int>(layout.lanes.width() / 2.0F), 1));
  ImGui::PushClipRect({layout.names.x0, layout.ruler.y0}, {area.x1, area.y1}, true);
  draw_ruler(ui, layout, RulerUnit::kTime, {});
  if (state.live_trace) draw_live_lanes(ui, layout, live_);
  draw_playhead(ui, layout, recorded_s);
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
  if (draw_no_project(ui, state, requests)) return requests;
  if (state.live) {
    draw_live(ui, state);
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
  // Where it is low, the lanes get what room there is: the menus have what the second row has.
  const bool low = ImGui::GetContentRegionAvail().y < ui.px(170);
  LaneSet lanes = ~LaneSet(time_->hidden_lanes);
  if (low) {
    tools_.draw_lane_menu(ui, lanes);
    ImGui::SameLine(0.0F, ui.px(2));
  }
  draw_transport(ui, state, *shown, requests);
  if (!low) tools_.draw(ui, state, *shown, lanes, requests);
  time_->hidden_lanes = static_cast<std::uint32_t>((~lanes).to_ulong());
  lanes_ = lanes;
  ImGui::Dummy({0.0F, ui.px(1)});
  draw_lane_area(ui, state, *shown, requests);
  return requests;
}

}  // namespace trocar::ui
