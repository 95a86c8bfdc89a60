#include "ui/panels/gizmo_overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/demonstration/motion.h"
#include "ui/command_table.h"
#include "ui/format.h"

namespace trocar::ui {
namespace {

using demonstration::Arms;
using demonstration::Demonstration;
using demonstration::Waypoint;
using Eigen::Vector2f;
using Eigen::Vector3d;
using workbench::Command;
using workbench::GizmoKind;
using workbench::WaypointDraft;

constexpr float kLength_px = 78.0F;
constexpr float kReach_px = 9.0F;
/// With Ctrl a tool moves by whole cells of the lattice and turns by whole steps.
constexpr double kSnap_m = 0.0025;
constexpr double kSnap_rad = 5.0 * std::numbers::pi / 180.0;
constexpr std::array<Rgba, 3> kAxisColours{{{236, 110, 104, 255}, {116, 200, 120, 255}, {96, 164, 240, 255}}};
constexpr Rgba kPlain{236, 238, 242, 255};
constexpr Rgba kTaken{255, 208, 84, 255};
constexpr Rgba kOutline{16, 18, 21, 255};

ImVec2 at(const Vector2f& p) {
  return {p.x(), p.y()};
}

/// Where the tools that the settings mean are at an instant.
spatial::Pose pose_at(const Demonstration& shown, const workbench::GizmoSettings& settings, double at_s) {
  const demonstration::Sample sample = shown.sample_at(at_s);
  const std::size_t arm = settings.arms == Arms::kRight ? 1 : 0;
  spatial::Pose pose = sample.arms[arm].measured.pose();
  if (settings.arms == Arms::kBoth) pose.p = 0.5 * (pose.p + sample.arms[1].measured.pose().p);
  const bool turned = settings.kind == GizmoKind::kTurn && settings.frame == demonstration::TurnFrame::kTool;
  if (!turned) pose.q = Eigen::Quaterniond::Identity();
  return pose;
}

Vector3d snapped(const Vector3d& value, double step) {
  return step * (value / step).array().round().matrix();
}

Vector3d displacement(const Handle& handle, const spatial::Pose& X_WG, const ViewPort& view, const Vector2f& from,
                      const Vector2f& to, bool snap) {
  if (handle.kind != HandleKind::kRing) {
    const Vector3d by_m = dragged_by(handle, X_WG, view, from, to);
    return snap ? snapped(by_m, kSnap_m) : by_m;
  }
  const double by_rad = turned_by(handle, X_WG, view, from, to);
  return (snap ? kSnap_rad * std::round(by_rad / kSnap_rad) : by_rad) * Vector3d::Unit(handle.axis);
}

std::string words_of(const WaypointDraft& draft, const Vector3d& by) {
  const bool turn = std::holds_alternative<demonstration::RotateTool>(draft.edit);
  const Vector3d shown = by * (turn ? 180.0 / std::numbers::pi : 1e3);
  return fmt::format("{:+.2f}  {:+.2f}  {:+.2f} {}   within {:.2f} s", shown.x(), shown.y(), shown.z(),
                     turn ? "°" : "mm", workbench::radius_of(draft));
}

Rgba colour_of(const Handle& handle, bool taken) {
  if (taken) return kTaken;
  if (handle.kind == HandleKind::kCentre) return kPlain;
  return kAxisColours[static_cast<std::size_t>(handle.axis)];
}

void draw_letter(Ui& ui, const std::string& words, const Vector2f& where, Rgba colour) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const FontScope font(ui.fonts().small);
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  list.AddCircleFilled(at(where), ui.px(9), to_u32(colour), 20);
  list.AddText({std::round(where.x() - 0.5F * size.x), std::round(where.y() - 0.5F * size.y)}, to_u32(kOutline),
               words.c_str());
}

}  // namespace

Vector2f mouse_now() {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  return {mouse.x, mouse.y};
}

void draw_handle(Ui& ui, const HandleShape& shape, bool taken) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Rgba colour = colour_of(shape.handle, taken);
  std::vector<ImVec2> points;
  points.reserve(shape.points.size());
  for (const Vector2f& p : shape.points) points.push_back(at(p));
  const float thick = ui.px(taken ? 4 : 3);
  switch (shape.handle.kind) {
    case HandleKind::kAxis:
      list.AddLine(points[0], points[1], to_u32(kOutline, 0.55F), thick + ui.px(2));
      list.AddLine(points[0], points[1], to_u32(colour), thick);
      return draw_letter(ui, name_of(shape.handle), shape.grip, colour);
    case HandleKind::kPlane:
      list.AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), to_u32(colour, taken ? 0.8F : 0.45F));
      list.AddPolyline(points.data(), static_cast<int>(points.size()), to_u32(colour), ImDrawFlags_Closed, ui.px(1.5F));
      return;
    case HandleKind::kRing:
      list.AddPolyline(points.data(), static_cast<int>(points.size()), to_u32(kOutline, 0.55F), ImDrawFlags_Closed,
                       thick + ui.px(2));
      list.AddPolyline(points.data(), static_cast<int>(points.size()), to_u32(colour), ImDrawFlags_Closed, thick);
      return draw_letter(ui, name_of(shape.handle).substr(5), shape.grip, colour);
    case HandleKind::kCentre:
      list.AddCircleFilled(at(shape.grip), ui.px(7), to_u32(colour, 0.9F), 20);
      list.AddCircle(at(shape.grip), ui.px(7), to_u32(kOutline), 20, ui.px(1.5F));
      return;
  }
}

void note_grip(Ui& ui, std::string_view label, std::string_view value, const Vector2f& p, const Rect& picture) {
  const float half = ui.px(12);
  const Rect rect{p.x() - half, p.y() - half, p.x() + half, p.y() + half};
  const bool within = rect.x0 >= picture.x0 && rect.y0 >= picture.y0 && rect.x1 <= picture.x1 && rect.y1 <= picture.y1;
  if (within) note_rect(ui, "mark", label, value, rect);
}

bool gizmo_shown(const WorkbenchState& state) {
  const auto shown = selected_demonstration(state);
  return state.gizmo.kind != GizmoKind::kNone && shown != nullptr && !state.live && state.play_speed == 0.0 &&
         !shown->gated().empty();
}

void GizmoOverlay::begin(const WorkbenchState& state, const ViewPort& view, const Handle& handle,
                         const Vector2f& mouse) {
  const auto shown = selected_demonstration(state);
  const WaypointDraft draft = workbench::draft_at(*shown, state.gizmo, state.playhead_s);
  drag_ = Drag{handle, mouse, pose_at(*shown, state.gizmo, state.playhead_s), view, shown, draft, draft};
}

void GizmoOverlay::follow(Ui& ui, const Vector2f& mouse, Requests& requests) {
  Drag& drag = *drag_;
  const ImGuiIO& io = ImGui::GetIO();
  const Vector3d by = displacement(drag.handle, drag.X_WG, drag.view, drag.from, mouse, ui.input().modifiers().control);
  double radius_s = workbench::radius_of(drag.now);
  if (io.MouseWheel != 0.0F) {
    radius_s = std::clamp(radius_s * std::pow(1.1, static_cast<double>(io.MouseWheel)), 0.02, 30.0);
  }
  ui.take_wheel();
  WaypointDraft wanted = workbench::with_reach(workbench::displaced_further(drag.before, by), radius_s,
                                               workbench::falloff_of(drag.before));
  const bool changed = workbench::displacement_of(wanted) != workbench::displacement_of(drag.now) ||
                       radius_s != workbench::radius_of(drag.now);
  if (!changed) return;
  drag.now = std::move(wanted);
  requests.emplace_back(Command{workbench::preview_of(drag.now)});
}

void GizmoOverlay::end(const WorkbenchState& state, bool commit, Requests& requests) {
  const bool moved = workbench::displacement_of(drag_->now) != workbench::displacement_of(drag_->before) ||
                     workbench::radius_of(drag_->now) != workbench::radius_of(drag_->before);
  if (commit && moved) requests.emplace_back(Command{workbench::commit_of(state.demonstration, drag_->now)});
  requests.emplace_back(Command{workbench::EndPreview{}});
  drag_.reset();
}

bool GizmoOverlay::click_waypoint(Ui& ui, const WorkbenchState& state, const ViewPort& view, const Vector2f& mouse,
                                  Requests& requests) const {
  const auto shown = selected_demonstration(state);
  for (const Waypoint& known : demonstration::waypoints_of(*shown)) {
    workbench::GizmoSettings settings = state.gizmo;
    settings.arms = known.arms;
    const auto pixel = view.pixel(pose_at(*shown, settings, known.at_s).p);
    if (!pixel || (*pixel - mouse).norm() > ui.px(kReach_px)) continue;
    settings.kind = std::holds_alternative<demonstration::RotateTool>(known.edit) ? GizmoKind::kTurn : GizmoKind::kMove;
    requests.emplace_back(Command{workbench::SetPlayhead{known.at_s}});
    requests.emplace_back(Command{workbench::SetGizmo{settings}});
    return true;
  }
  return false;
}

bool GizmoOverlay::take_mouse(Ui& ui, const WorkbenchState& state, const ViewPort& view, bool hovered,
                              Requests& requests) {
  const bool released = !ImGui::IsMouseDown(0);
  if (released) given_up_ = false;
  if (drag_) {
    const bool stale = !gizmo_shown(state) || selected_demonstration(state) != drag_->shown;
    const bool cancelled = stale || ui.input().pressed(Key::kEscape);
    given_up_ = cancelled && !released;
    // A hand that lets go of the button and of Ctrl at once means what it saw before.
    if (!cancelled && !released) follow(ui, mouse_now(), requests);
    if (cancelled || released) end(state, !cancelled, requests);
    return true;
  }
  hovered_.reset();
  if (!gizmo_shown(state)) return given_up_;
  const auto shown = selected_demonstration(state);
  const spatial::Pose X_WG = pose_at(*shown, state.gizmo, state.playhead_s);
  const auto shapes = handle_shapes(state.gizmo, X_WG, view, ui.px(kLength_px));
  if (hovered) hovered_ = handle_at(shapes, mouse_now(), ui.px(kReach_px));
  if (hovered_) {
    ui.set_hint(
        "Drag to displace the tool, its neighbourhood in time with it; Ctrl: whole steps, wheel: how far in time, "
        "Esc: leave it");
  }
  if (!ImGui::IsItemActivated() || !ImGui::IsMouseDown(0)) return given_up_;
  if (hovered_) {
    begin(state, view, *hovered_, mouse_now());
    return true;
  }
  given_up_ = click_waypoint(ui, state, view, mouse_now(), requests);
  return given_up_;
}

void GizmoOverlay::draw_waypoints(Ui& ui, const WorkbenchState& state, const ViewPort& view) const {
  const auto shown = selected_demonstration(state);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  UniqueNames unique;
  for (const Waypoint& known : demonstration::waypoints_of(*shown)) {
    workbench::GizmoSettings settings = state.gizmo;
    settings.arms = known.arms;
    const auto pixel = view.pixel(pose_at(*shown, settings, known.at_s).p);
    if (!pixel || !view.rect.contains(pixel->x(), pixel->y())) continue;
    const float size = ui.px(6);
    const std::array<ImVec2, 4> diamond{{{pixel->x(), pixel->y() - size},
                                         {pixel->x() + size, pixel->y()},
                                         {pixel->x(), pixel->y() + size},
                                         {pixel->x() - size, pixel->y()}}};
    const bool here = std::abs(known.at_s - state.playhead_s) < demonstration::kSameInstant_s;
    list.AddConvexPolyFilled(diamond.data(), 4, to_u32(here ? kTaken : kPlain));
    list.AddPolyline(diamond.data(), 4, to_u32(kOutline), ImDrawFlags_Closed, ui.px(1.5F));
    note_grip(ui, unique(fmt::format("Waypoint {:.2f} s", known.at_s)), here ? "here" : "", *pixel, view.rect);
  }
}

void GizmoOverlay::draw_handles(Ui& ui, const WorkbenchState& state, const ViewPort& view) const {
  const auto shown = selected_demonstration(state);
  spatial::Pose X_WG = drag_ ? drag_->X_WG : pose_at(*shown, state.gizmo, state.playhead_s);
  const WaypointDraft draft = drag_ ? drag_->now : workbench::draft_at(*shown, state.gizmo, state.playhead_s);
  if (drag_ && drag_->handle.kind != HandleKind::kRing) {
    X_WG.p += workbench::displacement_of(drag_->now) - workbench::displacement_of(drag_->before);
  }
  const std::string words = words_of(draft, workbench::displacement_of(draft));
  const std::optional<Handle> taken = drag_ ? std::optional(drag_->handle) : hovered_;
  for (const HandleShape& shape : handle_shapes(state.gizmo, X_WG, view, ui.px(kLength_px))) {
    draw_handle(ui, shape, taken == shape.handle);
    note_grip(ui, name_of(shape.handle), words, shape.grip, view.rect);
  }
  if (!drag_) return;
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  const auto tip = view.pixel(X_WG.p).value_or(mouse_now());
  const float x = std::clamp(tip.x() - 0.5F * size.x, view.rect.x0 + ui.px(8), view.rect.x1 - size.x - ui.px(8));
  const float y = std::min(tip.y() + ui.px(kLength_px) + ui.px(14), view.rect.y1 - size.y - ui.px(10));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({x - ui.px(8), y - ui.px(4)}, {x + size.x + ui.px(8), y + size.y + ui.px(4)},
                     to_u32(ui.theme().panel, 0.92F), ui.px(6));
  list.AddText({x, y}, to_u32(ui.theme().text), words.c_str());
}

void GizmoOverlay::draw(Ui& ui, const WorkbenchState& state, const ViewPort& view) const {
  if (!gizmo_shown(state)) return;
  const Scope scope(ui, "Gizmo");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect({view.rect.x0, view.rect.y0}, {view.rect.x1, view.rect.y1}, true);
  draw_waypoints(ui, state, view);
  draw_handles(ui, state, view);
  list.PopClipRect();
}

}  // namespace trocar::ui
