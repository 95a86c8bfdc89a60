#include "ui/panels/take_overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/spatial/grid.h"
#include "ui/command_table.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"
#include "ui/panels/gizmo_overlay.h"
#include "ui/take_keys.h"

namespace trocar::ui {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3d;
using kinematics::ArmSide;
using trial::Phase;
using workbench::Command;
using workbench::LiveView;

constexpr double kWheel_m = 0.001;

const char* arm_name(ArmSide side) {
  return side == ArmSide::kLeft ? "Left" : "Right";
}

/// The tools are a person's here, in a take or in a trial.
bool driven_here(const WorkbenchState& state) {
  return take_goes_on(state) || trial_goes_on(state);
}

trial::HandMode mode_of(const WorkbenchState& state) {
  return trial_goes_on(state) ? trial::HandMode::kContinuous : state.take->request.options.mode;
}

bool driven(const WorkbenchState& state, ArmSide side) {
  if (trial_goes_on(state)) {
    const workbench::StartTrials& request = state.trials->request;
    return side == ArmSide::kLeft ? request.person : request.person_assists;
  }
  return state.take->request.options.sources[kinematics::index_of(side)] == trial::ArmSource::kHand;
}

/// Where the operator's tool is, or will go.
spatial::Pose place_of(const WorkbenchState& state, ArmSide side) {
  return state.live->status.arms[kinematics::index_of(side)].waypoint.value_or(state.live->world.arm(side).X_WT);
}

bool sets_waypoints(const WorkbenchState& state) {
  return mode_of(state) == trial::HandMode::kWaypoint;
}

/// Arrows along the axes of W.
std::vector<HandleShape> waypoint_handles(Ui& ui, const WorkbenchState& state, const ViewPort& view, ArmSide side) {
  workbench::GizmoSettings settings;
  settings.kind = workbench::GizmoKind::kMove;
  return handle_shapes(settings, spatial::Pose::translation(place_of(state, side).p), view, ui.px(64));
}

/// The driven arm whose tip is nearest to the pointer.
std::optional<ArmSide> nearest_arm(const WorkbenchState& state, const ViewPort& view) {
  std::optional<ArmSide> nearest;
  float least = 0.0F;
  for (const ArmSide side : kinematics::kArmSides) {
    if (!driven(state, side)) continue;
    const auto pixel = view.pixel(place_of(state, side).p);
    const float distance = pixel ? (*pixel - mouse_now()).norm() : 1e6F;
    if (!nearest || distance < least) {
      nearest = side;
      least = distance;
    }
  }
  return nearest;
}

/// Words on a filled ground, centred over `bottom`; returns the top of the ground.
float draw_pill(Ui& ui, std::string_view name, const std::string& words, const Rect& rect, float bottom, Rgba fill,
                Rgba ink) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string shown = fitted(words, rect.width() - ui.px(44));
  const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
  const ImVec2 at{std::round(rect.centre_x() - 0.5F * size.x), std::round(bottom - size.y - ui.px(7))};
  const float top = at.y - ui.px(7);
  list.AddRectFilled({at.x - ui.px(14), top}, {at.x + size.x + ui.px(14), bottom}, to_u32(fill), ui.px(16));
  list.AddText(at, to_u32(ink), shown.c_str());
  note_rect(ui, "text", name, words, {at.x, at.y, at.x + size.x, at.y + size.y});
  return top;
}

/// "00:12.4": of a width that does not change while it runs.
std::string record_time(double s) {
  const auto tenths = static_cast<std::int64_t>(std::llround(std::max(s, 0.0) * 10.0));
  return fmt::format("{:02}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

/// By a millimetre for each notch of the wheel, or a cell.
void push_away(const WorkbenchState& state, const ViewPort& view, ArmSide arm, float notches, Requests& requests) {
  if (mode_of(state) == trial::HandMode::kStep) {
    const Vector3d way = std::copysign(1.0, static_cast<double>(notches)) * -Vector3d::UnitX();
    requests.emplace_back(Command{workbench::HandInput{{trial::StepTool{arm, way}}}});
    return;
  }
  const Vector3d way = kWheel_m * static_cast<double>(notches) * view.camera.X_WC.rotation().col(2);
  requests.emplace_back(Command{workbench::HandInput{{trial::ShiftTool{arm, way}}}});
}

/// "  |  disk 41 GB"; nothing where that is unknown.
std::string disk_words(std::int64_t free_bytes) {
  if (free_bytes < 0) return {};
  const double gigabytes = static_cast<double>(free_bytes) / 1e9;
  return gigabytes < 10.0 ? fmt::format("  |  disk {:.1f} GB", gigabytes)
                          : fmt::format("  |  disk {:.0f} GB", gigabytes);
}

/// As measured; the first second tells nothing yet.
std::string rate_words(const LiveView& live) {
  return live.rate_hz > 0.0 ? fmt::format("{:.1f} Hz", live.rate_hz) : "… Hz";
}

std::string recorded_words(const LiveView& live, bool by_hand) {
  const char* word = live.status.phase == Phase::kPaused ? "PAUSED" : "REC";
  std::string words =
      fmt::format("{}  {}  {}  |  {} samples", icon::kRecord, word, record_time(live.elapsed_s), count(live.samples));
  words += "  |  " + rate_words(live);
  if (by_hand) {
    return words + fmt::format("  |  {} drops", count(live.status.dropped_input));
  }
  return words + fmt::format("  |  segment {}  |  {:.2f}× real time", demonstration::letter(live.segment),
                             live.realtime_factor);
}

void draw_frame(Ui& ui, const Rect& rect) {
  const float thick = ui.px(3);
  ImGui::GetWindowDrawList()->AddRect({rect.x0 + 0.5F * thick, rect.y0 + 0.5F * thick},
                                      {rect.x1 - 0.5F * thick, rect.y1 - 0.5F * thick}, to_u32(ui.theme().danger_fill),
                                      0.0F, ImDrawFlags_None, thick);
}

/// What an arm cannot do is never silent.
float draw_arm_words(Ui& ui, const WorkbenchState& state, const Rect& rect, float bottom) {
  for (const ArmSide side : kinematics::kArmSides) {
    const trial::ArmReport& arm = state.live->status.arms[kinematics::index_of(side)];
    if (arm.refusal.empty() && !arm.limited) continue;
    const std::string what = arm.refusal.empty() ? "at a limit" : "holds: " + arm.refusal;
    const std::string words = fmt::format("{}  {} arm {}", icon::kWarning, arm_name(side), what);
    bottom = draw_pill(ui, fmt::format("{} arm", arm_name(side)), words, rect, bottom, ui.theme().panel,
                       ui.theme().warning) -
             ui.px(6);
  }
  if (!state.live->status.clutch) return bottom;
  return draw_pill(ui, "Clutch", "Clutch: the tools hold", rect, bottom, ui.theme().panel, ui.theme().text) - ui.px(6);
}

/// The second that is running, as a ring that closes, over `bottom`.
void draw_dial(Ui& ui, double left_s, const Rect& rect, float bottom) {
  const float radius = ui.px(24);
  // The words below say the number too; arms and blocks are not to be covered by it.
  if (2.0F * radius > 0.16F * rect.height()) return;
  const ImVec2 centre{std::round(rect.centre_x()), std::round(bottom - radius - ui.px(12))};
  if (centre.y - radius < rect.y0 + ui.px(8)) return;
  constexpr float kTop_rad = -0.5F * std::numbers::pi_v<float>;
  const auto share = static_cast<float>(std::ceil(left_s) - left_s);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(centre, radius + ui.px(4), to_u32(ui.theme().panel, 0.92F), 40);
  list.PathArcTo(centre, radius - ui.px(2), kTop_rad, kTop_rad + share * 2.0F * std::numbers::pi_v<float>, 40);
  list.PathStroke(to_u32(ui.theme().danger_fill), ImDrawFlags_None, ui.px(4));
  const std::string number = fmt::format("{:.0f}", std::ceil(left_s));
  const ImVec2 size = ImGui::CalcTextSize(number.c_str());
  list.AddText({std::round(centre.x - 0.5F * size.x), std::round(centre.y - 0.5F * size.y)}, to_u32(ui.theme().text),
               number.c_str());
}

void draw_countdown(Ui& ui, const LiveView& live, const Rect& rect, float bottom) {
  const bool leading = live.status.phase == Phase::kLeadIn;
  const int left = static_cast<int>(std::ceil(live.status.countdown_s));
  std::string words = leading    ? "Going to where the take begins"
                      : left > 0 ? fmt::format("Recording begins in {}", left)
                                 : "The arms go to where the take begins";
  if (live.status.pre_roll_s > 0.0) words += fmt::format("  |  the last {:.0f} s are kept", live.status.pre_roll_s);
  const float top = draw_pill(ui, "Countdown", words, rect, bottom, ui.theme().panel, ui.theme().text);
  if (!leading && left > 0) draw_dial(ui, live.status.countdown_s, rect, top);
}

void draw_waypoints(Ui& ui, const WorkbenchState& state, const ViewPort& view) {
  constexpr Rgba kPlace{255, 208, 84, 255};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const ArmSide side : kinematics::kArmSides) {
    const auto& waypoint = state.live->status.arms[kinematics::index_of(side)].waypoint;
    if (!waypoint) continue;
    const auto to = view.pixel(waypoint->p);
    const auto from = view.pixel(state.live->world.arm(side).X_WT.p);
    if (!to || !from) continue;
    list.AddLine({from->x(), from->y()}, {to->x(), to->y()}, to_u32(kPlace), ui.px(2));
    list.AddCircleFilled({to->x(), to->y()}, ui.px(6), to_u32(kPlace), 20);
    const float half = ui.px(12);
    note_rect(ui, "mark", fmt::format("{} waypoint", arm_name(side)), "",
              {to->x() - half, to->y() - half, to->x() + half, to->y() + half});
  }
}

}  // namespace

void TakeOverlay::begin(const WorkbenchState& state, ArmSide arm) {
  drag_ = Drag{arm, mouse_now(), Vector3d::Zero(), hovered_, mouse_now(), place_of(state, arm)};
}

void TakeOverlay::draw_handles(Ui& ui, const WorkbenchState& state, const ViewPort& view) const {
  const auto arm = drag_ ? std::optional(drag_->arm) : nearest_arm(state, view);
  if (!sets_waypoints(state) || !arm) return;
  const Scope scope(ui, "Waypoint");
  const std::optional<Handle> taken = drag_ ? drag_->handle : hovered_;
  for (const HandleShape& shape : waypoint_handles(ui, state, view, *arm)) {
    draw_handle(ui, shape, taken == shape.handle);
    note_grip(ui, name_of(shape.handle), "", shape.grip, view.rect);
  }
}

void TakeOverlay::follow(const WorkbenchState& state, const ViewPort& view, float wheel, Requests& requests) {
  Drag& drag = *drag_;
  const Vector2f mouse = mouse_now();
  const Vector2f by = mouse - drag.last;
  drag.last = mouse;
  if (drag.handle) {
    if (by.squaredNorm() == 0.0F) return;
    const spatial::Pose X_WG = spatial::Pose::translation(drag.X_WT.p);
    const spatial::Pose X_WT{drag.X_WT.p + dragged_by(*drag.handle, X_WG, view, drag.from, mouse), drag.X_WT.q};
    requests.emplace_back(Command{workbench::HandInput{{trial::PlaceTool{drag.arm, X_WT}}}});
    return;
  }
  const Eigen::Matrix3d R_WC = view.camera.X_WC.rotation();
  const double pixel_m = view.pixel_m(place_of(state, drag.arm).p);
  drag.left_W += pixel_m * (R_WC.col(0) * static_cast<double>(by.x()) + R_WC.col(1) * static_cast<double>(by.y())) +
                 kWheel_m * static_cast<double>(wheel) * R_WC.col(2);
  if (mode_of(state) != trial::HandMode::kStep) {
    if (drag.left_W.squaredNorm() == 0.0) return;
    requests.emplace_back(Command{workbench::HandInput{{trial::ShiftTool{drag.arm, drag.left_W}}}});
    drag.left_W.setZero();
    return;
  }
  // A cell at a time, along the axis on which the hand went farthest.
  const double cell_m = spatial::Grid{}.cell_m;
  Eigen::Index axis = 0;
  while (drag.left_W.cwiseAbs().maxCoeff(&axis) >= cell_m) {
    const Vector3d way = std::copysign(1.0, drag.left_W[axis]) * Vector3d::Unit(axis);
    requests.emplace_back(Command{workbench::HandInput{{trial::StepTool{drag.arm, way}}}});
    drag.left_W -= cell_m * way;
  }
}

bool TakeOverlay::take_mouse(Ui& ui, const WorkbenchState& state, const ViewPort& view, bool hovered,
                             Requests& requests) {
  if (!driven_here(state)) {
    drag_.reset();
    return false;
  }
  const float wheel = hovered ? ImGui::GetIO().MouseWheel : 0.0F;
  if (hovered) {
    ui.set_hint("Drag a tool; wheel: nearer or farther, right button: jaws, middle button: turn and shift the view");
    ui.take_wheel();
  }
  const std::optional<ArmSide> near = nearest_arm(state, view);
  if (hovered && near && ImGui::IsMouseClicked(1)) {
    requests.emplace_back(Command{workbench::HandInput{{trial::ToggleJaw{*near}}}});
  }
  if (!drag_) hovered_.reset();
  if (!drag_ && hovered && near && sets_waypoints(state)) {
    hovered_ = handle_at(waypoint_handles(ui, state, view, *near), mouse_now(), ui.px(9));
  }
  if (ImGui::IsItemActivated() && ImGui::IsMouseDown(0) && near) begin(state, *near);
  if (drag_ && !ImGui::IsMouseDown(0)) drag_.reset();
  if (drag_) {
    follow(state, view, wheel, requests);
    return true;
  }
  if (wheel != 0.0F && near) push_away(state, view, *near, wheel, requests);
  return ImGui::IsMouseDown(1) || wheel != 0.0F;
}

void TakeOverlay::draw_marks(Ui& ui, const WorkbenchState& state, const ViewPort& view) const {
  if (!driven_here(state)) return;
  draw_waypoints(ui, state, view);
  draw_handles(ui, state, view);
}

void TakeOverlay::draw(Ui& ui, const WorkbenchState& state, const ViewPort& view, float bottom) const {
  if (!state.live) return;
  const FontScope font(ui.fonts().strong);
  const LiveView& live = *state.live;
  bottom -= ui.px(17);
  if (state.take && state.take->reviewing) return;
  if (live.status.phase == Phase::kLeadIn || live.status.phase == Phase::kCountdown) {
    return draw_countdown(ui, live, view.rect, bottom);
  }
  draw_frame(ui, view.rect);
  const std::string words = recorded_words(live, state.take.has_value()) + disk_words(state.disk_free_bytes);
  // The time is what matters most.
  const std::string time = fmt::format("{}  REC  {}", icon::kRecord, record_time(live.elapsed_s));
  const std::string rated = time + "  |  " + rate_words(live);
  const auto fits = [&](const std::string& each) {
    return ImGui::CalcTextSize(each.c_str()).x <= view.rect.width() - ui.px(44);
  };
  bottom = draw_pill(ui, "REC",
                     fits(words)   ? words
                     : fits(rated) ? rated
                                   : time,
                     view.rect, bottom, ui.theme().danger_fill, ui.theme().on_accent) -
           ui.px(6);
  draw_arm_words(ui, state, view.rect, bottom);
}

}  // namespace trocar::ui
