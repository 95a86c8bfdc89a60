#include "ui/panels/timeline_mouse.h"

#include <algorithm>
#include <cmath>

#include "ui/panels/common.h"
#include "ui/panels/time_snap.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::SetPlayhead;
using workbench::SetSelection;
using workbench::TimeSpan;

constexpr double kLeast_s = 0.05;    // Between the gates.
constexpr float kReach = 7.0F;       // Of an edge, pixels at 100 %.
constexpr float kClickReach = 3.0F;  // A press that moves less is a click.

bool near_edge(const Ui& ui, const LaneLayout& layout, double edge_s, float x) {
  return std::abs(layout.x_of(edge_s) - x) <= ui.px(kReach);
}

TimeSpan in_order(double a_s, double b_s) {
  return {std::min(a_s, b_s), std::max(a_s, b_s)};
}

}  // namespace

double TimelineMouse::gate_in_s(const demonstration::Demonstration& shown) const {
  return drag_ == Drag::kGateIn && moved_ ? current_s_ : shown.begin_s;
}

double TimelineMouse::gate_out_s(const demonstration::Demonstration& shown) const {
  return drag_ == Drag::kGateOut && moved_ ? current_s_ : shown.end_s;
}

std::optional<TimeSpan> TimelineMouse::zoomed() const {
  if (drag_ != Drag::kZoom || !moved_) return std::nullopt;
  return in_order(anchor_s_, current_s_);
}

TimelineMouse::Drag TimelineMouse::what_is_at(const Ui& ui, const TimelineGround& ground, ImVec2 mouse) const {
  const LaneLayout& layout = ground.layout;
  if (mouse.y >= layout.lanes.y0) return Drag::kSelect;
  if (mouse.y < layout.gates.y0) return Drag::kScrub;
  // Gates are no more to be moved than anything else of the document.
  if (!being_recorded(ground.state).empty()) return Drag::kScrub;
  const float reach = ui.px(kReach);
  const float in = layout.x_of(ground.shown.begin_s);
  const float out = layout.x_of(ground.shown.end_s);
  if (mouse.x >= in - reach - ui.px(3) && mouse.x <= in + reach) return Drag::kGateIn;
  if (mouse.x <= out + reach + ui.px(3) && mouse.x >= out - reach) return Drag::kGateOut;
  return Drag::kScrub;
}

void TimelineMouse::show_what_is_under(Ui& ui, Drag under) const {
  const Drag seen = drag_ == Drag::kNone ? under : drag_;
  if (seen == Drag::kGateIn || seen == Drag::kGateOut) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ui.set_hint("Drag to trim; the recording keeps what lies outside. Esc cancels");
  } else if (seen == Drag::kScrub) {
    ui.set_hint("Drag to move the playhead; wheel zooms, right drag shifts");
  } else if (drag_ == Drag::kSelect) {
    ui.set_hint("Selects time; Ctrl inverts snapping, Esc cancels");
  }
}

double TimelineMouse::time_of_mouse(const Ui& ui, const TimelineGround& ground) {
  const LaneLayout& layout = ground.layout;
  const ImGuiIO& io = ImGui::GetIO();
  const double t_s = std::clamp(layout.time_at(io.MousePos.x), 0.0, ground.length_s);
  snapped_s_.reset();
  if (ground.state.snapping != io.KeyCtrl) {
    const double reach_s = layout.range.span_s() * static_cast<double>(ui.px(kReach) / layout.lanes.width());
    snapped_s_ = nearest_place(ground.places, t_s, reach_s);
  }
  return snapped_s_.value_or(std::clamp(at_sample(t_s), 0.0, ground.length_s));
}

void TimelineMouse::press(const Ui& ui, const TimelineGround& ground, Drag under) {
  const ImGuiIO& io = ImGui::GetIO();
  drag_ = io.MouseDown[0] ? under : io.MouseDown[2] ? Drag::kZoom : Drag::kPan;
  moved_ = false;
  edge_ = false;
  pressed_x_ = io.MousePos.x;
  current_s_ = time_of_mouse(ui, ground);
  anchor_s_ = current_s_;
  selection_before_ = ground.state.selection;
  if (drag_ != Drag::kSelect) return;
  const auto& selection = ground.state.selection;
  if (!selection) {
    if (io.KeyShift) anchor_s_ = ground.state.playhead_s;
    return;
  }
  const bool at_begin = near_edge(ui, ground.layout, selection->begin_s, io.MousePos.x);
  const bool at_end = near_edge(ui, ground.layout, selection->end_s, io.MousePos.x);
  if (!io.KeyShift && !at_begin && !at_end) return;
  const bool nearer_begin = std::abs(current_s_ - selection->begin_s) < std::abs(current_s_ - selection->end_s);
  anchor_s_ = nearer_begin ? selection->end_s : selection->begin_s;
  moved_ = io.KeyShift;
  edge_ = true;
}

void TimelineMouse::move(const Ui& ui, const TimelineGround& ground, TimeRange& range, Requests& requests) {
  const ImGuiIO& io = ImGui::GetIO();
  moved_ = moved_ || std::abs(io.MousePos.x - pressed_x_) > ui.px(kClickReach);
  if (drag_ == Drag::kPan) {
    range.pan(-range.span_s() * static_cast<double>(io.MouseDelta.x / ground.layout.lanes.width()));
    return range.keep_within(ground.length_s);
  }
  current_s_ = time_of_mouse(ui, ground);
  if (drag_ == Drag::kGateIn) current_s_ = std::clamp(current_s_, 0.0, ground.shown.end_s - kLeast_s);
  if (drag_ == Drag::kGateOut) current_s_ = std::clamp(current_s_, ground.shown.begin_s + kLeast_s, ground.length_s);
  if (drag_ == Drag::kSelect && moved_) {
    const TimeSpan span = in_order(anchor_s_, current_s_);
    if (ground.state.selection != span) requests.emplace_back(Command{SetSelection{span}});
  }
  const bool follows = drag_ == Drag::kScrub || (trims() && moved_);
  const double kept_s = std::clamp(current_s_, ground.shown.begin_s, ground.shown.end_s);
  if (follows && kept_s != ground.state.playhead_s) requests.emplace_back(Command{SetPlayhead{kept_s}});
}

void TimelineMouse::release(const TimelineGround& ground, TimeRange& range, Requests& requests) {
  const double in_s = gate_in_s(ground.shown);
  const double out_s = gate_out_s(ground.shown);
  if (trims() && being_recorded(ground.state).empty() &&
      (in_s != ground.shown.begin_s || out_s != ground.shown.end_s)) {
    const demonstration::Trim trim{in_s, out_s};
    requests.emplace_back(
        Command{workbench::CommitEdit{workbench::EditDemonstration{ground.state.demonstration, trim}}});
  }
  if (const auto span = zoomed(); span && span->length_s() > 0.0) {
    range = {span->begin_s, span->end_s};
    range.keep_within(ground.length_s);
  }
  // A click is about an instant.
  if (drag_ == Drag::kSelect && !moved_) {
    requests.emplace_back(Command{SetPlayhead{current_s_}});
    if (ground.state.selection) requests.emplace_back(Command{SetSelection{}});
  }
  reset();
}

void TimelineMouse::cancel(Requests& requests) {
  if (drag_ == Drag::kSelect) requests.emplace_back(Command{SetSelection{selection_before_}});
  reset();
}

void TimelineMouse::double_click(const TimelineGround& ground, Requests& requests) {
  const double t_s = ground.layout.time_at(ImGui::GetIO().MousePos.x);
  for (const demonstration::SegmentSpan& span : ground.shown.segments) {
    if (t_s < span.begin_s || t_s >= span.end_s) continue;
    requests.emplace_back(Command{SetSelection{TimeSpan{span.begin_s, span.end_s}}});
    return reset();
  }
}

void TimelineMouse::take_wheel(const TimelineGround& ground, TimeRange& range) const {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseWheel != 0.0F && io.KeyAlt) {
    range.pan(-0.1 * range.span_s() * static_cast<double>(io.MouseWheel));
  } else if (io.MouseWheel != 0.0F) {
    const double step = io.KeyCtrl ? 0.96 : io.KeyShift ? 0.6 : 0.85;
    range.zoom(ground.layout.time_at(io.MousePos.x), std::pow(step, static_cast<double>(io.MouseWheel)));
  }
  if (io.MouseWheelH != 0.0F) range.pan(-0.1 * range.span_s() * static_cast<double>(io.MouseWheelH));
  range.keep_within(ground.length_s);
}

std::optional<TimeSpan> TimelineMouse::edges(const TimelineGround& ground) const {
  if (!moved_) return std::nullopt;
  if (trims()) return TimeSpan{gate_in_s(ground.shown), gate_out_s(ground.shown)};
  if (drag_ != Drag::kSelect || !edge_) return std::nullopt;
  return in_order(anchor_s_, current_s_);
}

void TimelineMouse::take(Ui& ui, const TimelineGround& ground, bool hovered, TimeRange& range, Requests& requests) {
  take_drag(ui, ground, hovered, range, requests);
  const std::optional<TimeSpan> seen = edges(ground);
  if (seen != ground.state.edges) requests.emplace_back(Command{workbench::ShowEdges{seen}});
}

void TimelineMouse::take_drag(Ui& ui, const TimelineGround& ground, bool hovered, TimeRange& range,
                              Requests& requests) {
  const ImGuiIO& io = ImGui::GetIO();
  snapped_s_.reset();
  if (hovered) take_wheel(ground, range);
  const Drag under = what_is_at(ui, ground, io.MousePos);
  if (hovered || drag_ != Drag::kNone) show_what_is_under(ui, under);
  if (ImGui::IsItemActivated()) press(ui, ground, under);
  if (hovered && under == Drag::kSelect && ImGui::IsMouseDoubleClicked(0)) return double_click(ground, requests);
  if (drag_ != Drag::kNone && ui.input().pressed(Key::kEscape)) return cancel(requests);
  if (drag_ == Drag::kNone) return;
  if (ImGui::IsItemDeactivated()) return release(ground, range, requests);
  if (ImGui::IsItemActive()) move(ui, ground, range, requests);
}

}  // namespace trocar::ui
