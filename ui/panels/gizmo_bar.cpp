#include "ui/panels/gizmo_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "engine/demonstration/motion.h"
#include "engine/spatial/grid.h"
#include "ui/command_table.h"
#include "ui/format.h"
#include "ui/panels/gizmo_overlay.h"

namespace trocar::ui {
namespace {

using demonstration::Arms;
using demonstration::Falloff;
using demonstration::TurnFrame;
using Eigen::Vector3d;
using workbench::Command;
using workbench::GizmoKind;
using workbench::GizmoSettings;
using workbench::WaypointDraft;

constexpr std::size_t kRadiusField = 3;

std::optional<double> number_in(const std::string& text) {
  double value = 0.0;
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

float labelled_width(const Ui& ui, std::string_view label, float field) {
  return ImGui::CalcTextSize(label.data(), label.data() + label.size()).x + ui.px(5) + field;
}

/// No item of its own: the field behind it has the name.
void dim_words(Ui& ui, std::string_view words) {
  const ColourScope colour(ImGuiCol_Text, ui.theme().text_dim);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(words.data(), words.data() + words.size());
}

void label_before(Ui& ui, std::string_view words) {
  dim_words(ui, words);
  ImGui::SameLine(0.0F, ui.px(5));
}

float choices_width(const Ui& ui, const std::vector<std::string>& names) {
  float widest = 0.0F;
  for (const std::string& name : names) widest = std::max(widest, ImGui::CalcTextSize(name.c_str()).x);
  return static_cast<float>(names.size()) * (widest + ui.px(20));
}

bool choice(Ui& ui, std::string_view label, int& chosen, const std::vector<std::string>& names, std::string_view help) {
  return segmented(ui, label, chosen, names, {.help = help, .width = choices_width(ui, names)});
}

/// The faster of the arms that the draft displaces, where it does.
double peak_speed_m_s(const demonstration::Demonstration& shown, Arms arms, double at_s, double radius_s) {
  constexpr std::size_t kApart = 4;  // 20 ms at 200 Hz, so that rounding does not show.
  const auto samples =
      shown.samples_within(std::max(at_s - radius_s, shown.begin_s), std::min(at_s + radius_s, shown.end_s))
          .to_vector();
  double peak = 0.0;
  for (std::size_t arm = arms == Arms::kRight ? 1 : 0; arm <= (arms == Arms::kLeft ? 0U : 1U); ++arm) {
    for (std::size_t i = kApart; i < samples.size(); ++i) {
      const double dt_s = samples[i].t_s() - samples[i - kApart].t_s();
      const Vector3d by_m =
          demonstration::measured_tip(samples[i], arm) - demonstration::measured_tip(samples[i - kApart], arm);
      if (dt_s > 0.0) peak = std::max(peak, by_m.norm() / dt_s);
    }
  }
  return peak;
}

}  // namespace

bool GizmoBar::number(Ui& ui, std::string_view label, std::size_t field, double shown, double& typed,
                      std::string_view help, bool focus) {
  const float width = ui.px(62);
  flow(labelled_width(ui, label, width), ui.px(10));
  label_before(ui, label);
  if (!typing_[field]) texts_[field] = fmt::format("{:.2f}", shown + 0.0);
  if (focus) ImGui::SetKeyboardFocusHere();
  const bool finished = text_field(ui, label, texts_[field], "", {.help = help, .width = width});
  typing_[field] = ImGui::IsItemActive();
  const auto value = number_in(texts_[field]);
  if (!finished || !value) return false;
  typed = *value;
  return true;
}

void GizmoBar::draw_choices(Ui& ui, const WorkbenchState& state, Requests& requests) {
  static const std::vector<std::string> kKinds{"Move", "Turn"};
  static const std::vector<std::string> kArms{"Left", "Right", "Both"};
  static const std::vector<std::string> kFrames{"Tool axes", "Board axes"};
  GizmoSettings settings = state.gizmo;
  int kind = settings.kind == GizmoKind::kTurn ? 1 : 0;
  if (choice(ui, "What", kind, kKinds, "Move the tool, or turn it about its tip")) {
    settings.kind = kind == 1 ? GizmoKind::kTurn : GizmoKind::kMove;
  }
  flow(choices_width(ui, kArms), ui.px(10));
  int arms = static_cast<int>(settings.arms);
  if (choice(ui, "Arm", arms, kArms, "Which tool")) settings.arms = static_cast<Arms>(arms);
  if (settings.kind == GizmoKind::kTurn) {
    flow(choices_width(ui, kFrames), ui.px(10));
    int frame = static_cast<int>(settings.frame);
    if (choice(ui, "Axes", frame, kFrames, "About which axes it turns")) settings.frame = static_cast<TurnFrame>(frame);
  }
  if (!(settings == state.gizmo)) requests.emplace_back(Command{workbench::SetGizmo{settings}});
}

void GizmoBar::draw_displacement(Ui& ui, const WorkbenchState& state, const WaypointDraft& draft, Requests& requests) {
  static constexpr std::array<std::string_view, 3> kMoves{"dx, mm", "dy, mm", "dz, mm"};
  static constexpr std::array<std::string_view, 3> kTurns{"rx, °", "ry, °", "rz, °"};
  const bool turn = state.gizmo.kind == GizmoKind::kTurn;
  const double unit = turn ? std::numbers::pi / 180.0 : 1e-3;
  const Vector3d by = workbench::displacement_of(draft);
  if (state.gizmo.axis != axis_) {
    axis_ = state.gizmo.axis;
    frames_to_go_ = axis_ >= 0 ? 2 : 0;
  }
  const bool reach = frames_to_go_ > 0 && --frames_to_go_ == 0;
  if (frames_to_go_ > 0) ui.animate();
  for (int axis = 0; axis < 3; ++axis) {
    double typed = 0.0;
    const auto field = static_cast<std::size_t>(axis);
    const bool done = number(ui, turn ? kTurns[field] : kMoves[field], field, by[axis] / unit, typed,
                             "How far in all; Enter makes it so", reach && axis == axis_);
    if (!done) continue;
    Vector3d wanted = by;
    wanted[axis] = typed * unit;
    GizmoSettings settings = state.gizmo;
    settings.axis = -1;
    requests.emplace_back(
        Command{workbench::commit_of(state.demonstration, workbench::with_displacement(draft, wanted))});
    requests.emplace_back(Command{workbench::SetGizmo{settings}});
  }
}

void GizmoBar::draw_reach(Ui& ui, const WorkbenchState& state, const WaypointDraft& draft, Requests& requests) {
  static const std::vector<std::string> kFalloffs{"smooth", "sphere", "linear", "sharp"};
  double radius_s = workbench::radius_of(draft);
  Falloff falloff = workbench::falloff_of(draft);
  const bool typed = number(ui, "within, s", kRadiusField, radius_s, radius_s,
                            "How far in time the neighbourhood moves along; in a drag the wheel changes it", false) &&
                     radius_s > 0.0;
  flow(ui.px(96), ui.px(10));
  int chosen = static_cast<int>(falloff);
  const bool other = combo(ui, "Falloff", chosen, kFalloffs, {.help = "How it fades with time", .width = ui.px(96)});
  if (!typed && !other) return;
  if (other) falloff = static_cast<Falloff>(chosen);
  GizmoSettings settings = state.gizmo;
  settings.radius_s = radius_s;
  settings.falloff = falloff;
  requests.emplace_back(Command{workbench::SetGizmo{settings}});
  if (draft.entry == 0) return;
  requests.emplace_back(
      Command{workbench::commit_of(state.demonstration, workbench::with_reach(draft, radius_s, falloff))});
}

void GizmoBar::draw_facts(Ui& ui, const WorkbenchState& state, const WaypointDraft& draft) {
  const bool previewed = state.preview && state.preview->after;
  const auto shown = previewed ? state.preview->after : selected_demonstration(state);
  const std::size_t arm = state.gizmo.arms == Arms::kRight ? 1 : 0;
  const spatial::Grid grid;
  const auto cell = grid.cell_at(demonstration::measured_tip(shown->sample_at(state.playhead_s), arm));
  std::string words = "outside of the lattice";
  if (cell) {
    const spatial::CellCoordinates at = grid.coordinates(*cell);
    words = fmt::format("cell {}, {}, {}", at.x, at.y, at.z);
  }
  const double radius_s = workbench::radius_of(draft);
  words +=
      fmt::format("   peak {:.0f} mm/s", 1e3 * peak_speed_m_s(*shown, state.gizmo.arms, state.playhead_s, radius_s));
  if (state.preview && !state.preview->error.empty()) words = state.preview->error;
  flow(ImGui::CalcTextSize(words.c_str()).x, ui.px(14));
  dim_words(ui, words);
  note_item(ui, "text", "Facts", words, {});
}

void GizmoBar::draw(Ui& ui, const WorkbenchState& state, Requests& requests) {
  if (!gizmo_shown(state)) {
    axis_ = state.gizmo.axis;
    return;
  }
  const Scope scope(ui, "Tool");
  const float most = 0.5F * ImGui::GetContentRegionAvail().y;
  const float height = std::min(std::max(height_, ImGui::GetFrameHeight() + ui.px(12)), most);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(10), ui.px(6)});
  ImGui::BeginChild("Tool", {0.0F, height}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  const WaypointDraft draft = workbench::draft_at(*selected_demonstration(state), state.gizmo, state.playhead_s);
  draw_choices(ui, state, requests);
  draw_displacement(ui, state, draft, requests);
  draw_reach(ui, state, draft, requests);
  draw_facts(ui, state, draft);
  flow(button_width(ui, "Done", nullptr), ui.px(14));
  if (button(ui, "Done", {.help = "Put the tool down", .shortcut = "Esc", .style = ButtonStyle::kQuiet})) {
    requests.emplace_back(Command{workbench::SetGizmo{}});
  }
  const float needed = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y + ui.px(6) + ImGui::GetScrollY();
  if (std::abs(needed - height_) > 0.5F) ui.animate();
  height_ = needed;
  ImGui::EndChild();
}

}  // namespace trocar::ui
