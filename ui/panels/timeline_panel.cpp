#include "ui/panels/timeline_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::Command;

constexpr double kLeast_s = 0.05;      // Between the gates.
constexpr float kSpeedWidth = 266.0F;  // Of the speeds and Fit, at 100 %.

double length_of(const demonstration::Demonstration& shown) {
  return shown.samples.empty() ? 1.0 : shown.full_duration_s();
}

std::string trim_words(double in_s, double out_s) {
  return fmt::format("{:.2f}–{:.2f} s, {:.2f} s long", in_s, out_s, out_s - in_s);
}

}  // namespace

void TimelinePanel::fit(const WorkbenchState& state, const demonstration::Demonstration& shown) {
  if (fitted_ != state.demonstration) {
    fitted_ = state.demonstration;
    range_ = {0.0, length_of(shown)};
    range_.zoom(0.5 * length_of(shown), 1.06);
    drag_ = Drag::kNone;
  }
  range_.keep_within(length_of(shown));
  if (drag_ != Drag::kGateIn) gate_in_s_ = shown.begin_s;
  if (drag_ != Drag::kGateOut) gate_out_s_ = shown.end_s;
}

void TimelinePanel::draw_transport(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown,
                                   Requests& requests) {
  command_icon(ui, state, "transport.begin", requests);
  ImGui::SameLine(0.0F, ui.px(2));
  const bool playing = state.play_speed != 0.0;
  const CommandRow& play = command("transport.play");
  if (icon_button(ui, playing ? "Pause" : "Play",
                  {.icon = playing ? icon::kPause : icon::kPlay, .help = play.help, .shortcut = "Space"})) {
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
  const bool trimming = drag_ == Drag::kGateIn || drag_ == Drag::kGateOut;
  const std::string words =
      trimming ? "Trim to " + trim_words(gate_in_s_, gate_out_s_) : "of " + seconds(shown.end_s) + ", " + shown.name;
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
    range_ = {shown.begin_s, shown.end_s};
    range_.zoom(0.5 * (shown.begin_s + shown.end_s), 1.06);
  }
}

TimelinePanel::Drag TimelinePanel::what_is_at(const Ui& ui, const LaneLayout& layout, ImVec2 mouse) const {
  const float reach = ui.px(7);
  const float in = layout.x_of(gate_in_s_);
  const float out = layout.x_of(gate_out_s_);
  if (mouse.x >= in - reach && mouse.x <= in + ui.px(3)) return Drag::kGateIn;
  if (mouse.x <= out + reach && mouse.x >= out - ui.px(3)) return Drag::kGateOut;
  return Drag::kScrub;
}

void TimelinePanel::take_wheel(const LaneLayout& layout, double length_s) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseWheel != 0.0F && io.KeyShift) {
    range_.pan(-0.1 * range_.span_s() * static_cast<double>(io.MouseWheel));
  } else if (io.MouseWheel != 0.0F) {
    range_.zoom(layout.time_at(io.MousePos.x), std::pow(0.85, static_cast<double>(io.MouseWheel)));
  }
  if (io.MouseWheelH != 0.0F) range_.pan(-0.1 * range_.span_s() * static_cast<double>(io.MouseWheelH));
  range_.keep_within(length_s);
}

void TimelinePanel::finish_drag(const WorkbenchState& state, const demonstration::Demonstration& shown,
                                Requests& requests) {
  const bool gate = drag_ == Drag::kGateIn || drag_ == Drag::kGateOut;
  drag_ = Drag::kNone;
  if (!gate || (gate_in_s_ == shown.begin_s && gate_out_s_ == shown.end_s)) return;
  const demonstration::Trim trim{gate_in_s_, gate_out_s_};
  requests.emplace_back(Command{workbench::CommitEdit{workbench::EditDemonstration{state.demonstration, trim}}});
}

void TimelinePanel::take_mouse(Ui& ui, const LaneLayout& layout, bool hovered, const WorkbenchState& state,
                               const demonstration::Demonstration& shown, Requests& requests) {
  const ImGuiIO& io = ImGui::GetIO();
  if (hovered) take_wheel(layout, length_of(shown));
  const Drag under = what_is_at(ui, layout, io.MousePos);
  const bool gates = drag_ == Drag::kGateIn || drag_ == Drag::kGateOut;
  if (gates || (hovered && drag_ == Drag::kNone && under != Drag::kScrub)) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ui.set_hint("Drag to trim; the recording keeps what lies outside. Esc cancels");
  }
  if (ImGui::IsItemActivated()) drag_ = io.MouseDown[0] && !state.live ? under : Drag::kPan;
  if (drag_ != Drag::kNone && ui.input().pressed(Key::kEscape)) drag_ = Drag::kNone;
  if (ImGui::IsItemDeactivated()) finish_drag(state, shown, requests);
  if (!ImGui::IsItemActive() || drag_ == Drag::kNone) return;
  const double t_s = layout.time_at(io.MousePos.x);
  if (drag_ == Drag::kPan) {
    range_.pan(-range_.span_s() * static_cast<double>(io.MouseDelta.x / layout.lanes.width()));
    range_.keep_within(length_of(shown));
    return;
  }
  if (drag_ == Drag::kGateIn) gate_in_s_ = std::clamp(t_s, 0.0, gate_out_s_ - kLeast_s);
  if (drag_ == Drag::kGateOut) gate_out_s_ = std::clamp(t_s, gate_in_s_ + kLeast_s, length_of(shown));
  const double shown_s = drag_ == Drag::kGateIn ? gate_in_s_ : drag_ == Drag::kGateOut ? gate_out_s_ : t_s;
  const double kept_s = std::clamp(shown_s, shown.begin_s, shown.end_s);
  if (kept_s != state.playhead_s) requests.emplace_back(Command{workbench::SetPlayhead{kept_s}});
}

void TimelinePanel::draw_gates(Ui& ui, const LaneLayout& layout) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float in = std::round(layout.x_of(gate_in_s_));
  const float out = std::round(layout.x_of(gate_out_s_));
  const Rect& lanes = layout.lanes;
  const ImU32 veil = to_u32(ui.theme().panel, 0.72F);
  if (in > lanes.x0) list.AddRectFilled({lanes.x0, lanes.y0 + 1.0F}, {in, lanes.y1}, veil);
  if (out < lanes.x1) list.AddRectFilled({out, lanes.y0 + 1.0F}, {lanes.x1, lanes.y1}, veil);
  const auto gate = [&](float x, bool left, bool active, std::string_view label, double t_s) {
    const Rgba colour = active ? ui.theme().accent : ui.theme().text_dim;
    const float tab = ui.px(7);
    const float x0 = left ? x - tab : x;
    list.AddRectFilled({x - 1.0F, layout.ruler.y1 - ui.px(14)}, {x + 1.0F, lanes.y1}, to_u32(colour));
    list.AddRectFilled({x0, layout.ruler.y1 - ui.px(14)}, {x0 + tab, layout.ruler.y1}, to_u32(colour), ui.px(2));
    note_rect(ui, "slider", label, fmt::format("{:.3f}", t_s),
              {x0, layout.ruler.y1 - ui.px(14), x0 + tab, layout.ruler.y1}, {.help = "Drag to trim"});
  };
  gate(in, true, drag_ == Drag::kGateIn, "In gate", gate_in_s_);
  gate(out, false, drag_ == Drag::kGateOut, "Out gate", gate_out_s_);
}

void TimelinePanel::draw_playhead(Ui& ui, const LaneLayout& layout, double t_s) const {
  const float x = std::round(layout.x_of(t_s));
  if (x < layout.lanes.x0 || x > layout.lanes.x1) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = to_u32(ui.theme().accent);
  const float half = ui.px(5);
  const float y = layout.ruler.y1 - ui.px(7);
  list.AddRectFilled({x - 1.0F, y}, {x + 1.0F, layout.lanes.y1}, colour);
  list.AddRectFilled({x - half, y - ui.px(6)}, {x + half, y}, colour, ui.px(2));
  list.AddTriangleFilled({x - half, y}, {x + half, y}, {x, y + ui.px(6)}, colour);
}

void TimelinePanel::draw_lane_area(Ui& ui, const WorkbenchState& state, const demonstration::Demonstration& shown,
                                   Requests& requests) {
  ImVec2 room = ImGui::GetContentRegionAvail();
  room.y = std::max(room.y, lanes_height(ui));
  const bool hovered = canvas(ui, "Lanes", room, trim_words(gate_in_s_, gate_out_s_),
                              {.help = "Drag to move the playhead, wheel to zoom, right drag to shift"});
  const LaneLayout layout = lay_out(ui, item_rect(), range_);
  take_mouse(ui, layout, hovered, state, shown, requests);
  LaneLayout now = lay_out(ui, item_rect(), range_);
  now.gate_in_s = gate_in_s_;
  now.gate_out_s = gate_out_s_;
  data_.update(shown, range_, std::max(static_cast<int>(now.lanes.width() / 2.0F), 1));
  ImGui::PushClipRect({now.names.x0, now.ruler.y0}, {item_rect().x1, item_rect().y1}, true);
  draw_ruler(ui, now);
  draw_lanes(ui, now, shown, data_);
  draw_gates(ui, now);
  draw_playhead(ui, now, state.playhead_s);
  ImGui::PopClipRect();
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
    const std::array<EmptyStateAction, 1> actions{
        {{"Record…", icon::kRecord, command("demo.record").reason_now(state), "Record a scripted transfer"}}};
    const std::string_view sentence = "Select a demonstration in the library, or record one";
    if (empty_state(ui, icon::kSliders, "Nothing to show over time", sentence, actions) == 0) {
      requests.emplace_back(UiAction::kShowRecord);
    }
    return requests;
  }
  fit(state, *shown);
  draw_transport(ui, state, *shown, requests);
  ImGui::Dummy({0.0F, ui.px(1)});
  draw_lane_area(ui, state, *shown, requests);
  return requests;
}

}  // namespace trocar::ui
