#include <array>

#include "engine/workbench/waypoint_draft.h"
#include "ui/command_rows.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

using namespace workbench;
using State = WorkbenchState;
using demonstration::Arms;

constexpr std::string_view kContext = "tool in hand";
/// One cell of the agent's lattice (paper, Table I), and a fine step.
constexpr double kCell_m = 0.0025;
constexpr double kFine_m = 0.0005;

std::string cannot_take(const State& state) {
  if (std::string reason = no_demonstration(state); !reason.empty()) return reason;
  return state.live ? "A transfer is being recorded" : "";
}

std::string no_tool_in_hand(const State& state) {
  if (std::string reason = cannot_take(state); !reason.empty()) return reason;
  return state.gizmo.kind == GizmoKind::kNone ? "Move or turn a tool first" : "";
}

std::string cannot_nudge(const State& state) {
  if (std::string reason = no_tool_in_hand(state); !reason.empty()) return reason;
  return state.gizmo.kind == GizmoKind::kMove ? "" : "The tool is being turned";
}

/// Taken up again it is put down.
template <GizmoKind kind>
Requests take(const State& state) {
  GizmoSettings settings = state.gizmo;
  settings.axis = -1;
  settings.kind = state.gizmo.kind == kind ? GizmoKind::kNone : kind;
  return {Command{SetGizmo{settings}}, ShowPanel{PanelId::kView}};
}

Requests put_down(const State& state) {
  // First what was begun, then the tool.
  if (state.preview) return one(Command{EndPreview{}});
  GizmoSettings settings = state.gizmo;
  if (settings.axis < 0) settings.kind = GizmoKind::kNone;
  settings.axis = -1;
  return one(Command{SetGizmo{settings}});
}

Requests next_arm(const State& state) {
  GizmoSettings settings = state.gizmo;
  settings.arms = static_cast<Arms>((static_cast<int>(settings.arms) + 1) % 3);
  return one(Command{SetGizmo{settings}});
}

template <int axis>
Requests along(const State& state) {
  GizmoSettings settings = state.gizmo;
  settings.axis = settings.axis == axis ? -1 : axis;
  return one(Command{SetGizmo{settings}});
}

/// Of a tool that is moved, if none is in hand.
WaypointDraft draft(const State& state) {
  return draft_at(*selected_demonstration(state), state.gizmo, state.playhead_s);
}

std::string cannot_insert(const State& state) {
  if (std::string reason = cannot_take(state); !reason.empty()) return reason;
  if (state.play_speed != 0.0) return "It plays";
  if (selected_demonstration(state)->gated().empty()) return "It has no samples";
  return draft(state).entry == 0 ? "" : "There is one at the playhead already";
}

Requests insert(const State& state) {
  return one(Command{commit_of(state.demonstration, draft(state))});
}

template <int axis, int sign, bool fine>
Requests nudge(const State& state) {
  const double step_m = sign * (fine ? kFine_m : kCell_m);
  return one(
      Command{commit_of(state.demonstration, displaced_further(draft(state), step_m * Eigen::Vector3d::Unit(axis)))});
}

constexpr RowData nudge_row(std::string_view id, std::string_view title, std::string_view help, std::string_view keys,
                            bool separator, Requests (*run)(const State&)) {
  return {id, "Tool", title, help, nullptr, {keys}, separator, cannot_nudge, run, kContext};
}

constexpr std::string_view kOneCell = "2.5 mm, one cell of the lattice";
constexpr std::string_view kHalfMillimetre = "0.5 mm";

constexpr std::array<RowData, 20> kToolRows{{
    {"tool.move",
     "Tool",
     "Move tool",
     "Drag the tool at the playhead in the view, or type how far; its neighbourhood in time moves along",
     icon::kArrows,
     {"G"},
     false,
     cannot_take,
     take<GizmoKind::kMove>},
    {"tool.turn",
     "Tool",
     "Turn tool",
     "Turn the tool at the playhead about its tip, in the view or by numbers",
     icon::kRefresh,
     {"T"},
     false,
     cannot_take,
     take<GizmoKind::kTurn>},
    {"tool.put_down",
     "Tool",
     "Put the tool down",
     "Leave what was begun; once more: no handles in the view",
     nullptr,
     {"Escape"},
     false,
     no_tool_in_hand,
     put_down,
     kContext},
    {"tool.arm", "Tool", "Other arm", "Left, right, both", nullptr, {"A"}, true, no_tool_in_hand, next_arm, kContext},
    {"tool.x",
     "Tool",
     "Only x",
     "Along or about x; then type how far",
     nullptr,
     {"X"},
     false,
     no_tool_in_hand,
     along<0>,
     kContext},
    {"tool.y",
     "Tool",
     "Only y",
     "Along or about y; then type how far",
     nullptr,
     {"Y"},
     false,
     no_tool_in_hand,
     along<1>,
     kContext},
    {"tool.z",
     "Tool",
     "Only z",
     "Along or about z; then type how far",
     nullptr,
     {"Z"},
     false,
     no_tool_in_hand,
     along<2>,
     kContext},
    {"tool.waypoint",
     "Tool",
     "Insert waypoint",
     "Keep an instant to displace the tool at, where the playhead is",
     icon::kPlus,
     {"Shift+K"},
     false,
     cannot_insert,
     insert},
    nudge_row("tool.nudge_x", "Nudge +x", kOneCell, "Ctrl+Right", true, nudge<0, 1, false>),
    nudge_row("tool.nudge_minus_x", "Nudge −x", kOneCell, "Ctrl+Left", false, nudge<0, -1, false>),
    nudge_row("tool.nudge_y", "Nudge +y", kOneCell, "Ctrl+Up", false, nudge<1, 1, false>),
    nudge_row("tool.nudge_minus_y", "Nudge −y", kOneCell, "Ctrl+Down", false, nudge<1, -1, false>),
    nudge_row("tool.nudge_z", "Nudge +z", kOneCell, "Ctrl+PageUp", false, nudge<2, 1, false>),
    nudge_row("tool.nudge_minus_z", "Nudge −z", kOneCell, "Ctrl+PageDown", false, nudge<2, -1, false>),
    nudge_row("tool.fine_x", "Nudge +x, fine", kHalfMillimetre, "Ctrl+Shift+Right", true, nudge<0, 1, true>),
    nudge_row("tool.fine_minus_x", "Nudge −x, fine", kHalfMillimetre, "Ctrl+Shift+Left", false, nudge<0, -1, true>),
    nudge_row("tool.fine_y", "Nudge +y, fine", kHalfMillimetre, "Ctrl+Shift+Up", false, nudge<1, 1, true>),
    nudge_row("tool.fine_minus_y", "Nudge −y, fine", kHalfMillimetre, "Ctrl+Shift+Down", false, nudge<1, -1, true>),
    nudge_row("tool.fine_z", "Nudge +z, fine", kHalfMillimetre, "Ctrl+Shift+PageUp", false, nudge<2, 1, true>),
    nudge_row("tool.fine_minus_z", "Nudge −z, fine", kHalfMillimetre, "Ctrl+Shift+PageDown", false, nudge<2, -1, true>),
}};

}  // namespace

std::span<const RowData> tool_rows() {
  return kToolRows;
}

}  // namespace trocar::ui
