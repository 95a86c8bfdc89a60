#include "ui/panels/slice_overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ui/command_table.h"
#include "ui/panels/gizmo_overlay.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::FieldSettings;

constexpr float kReach_px = 11.0F;
constexpr std::array<Rgba, 3> kAxisColours{{{236, 110, 104, 255}, {116, 200, 120, 255}, {96, 164, 240, 255}}};

std::vector<SliceGrip> grips_of(const WorkbenchState& state, const ViewPort& view) {
  if (state.live || !state.insight || !state.insight->field || !state.field.visible) return {};
  return slice_grips(state.insight->field->grid, state.field.slices, view);
}

void move_slice(const WorkbenchState& state, int axis, int index, Requests& requests) {
  FieldSettings settings = state.field;
  settings.slices[static_cast<std::size_t>(axis)] = index;
  if (settings != state.field) requests.emplace_back(Command{workbench::SetField{settings}});
}

}  // namespace

bool SliceOverlay::take_mouse(Ui& ui, const WorkbenchState& state, const ViewPort& view, bool hovered,
                              Requests& requests) {
  const std::vector<SliceGrip> grips = grips_of(state, view);
  if (drag_) {
    if (!ImGui::IsMouseDown(0) || grips.empty()) {
      drag_.reset();
      return true;
    }
    if (ui.input().pressed(Key::kEscape)) {
      move_slice(state, drag_->grip.axis, drag_->grip.index, requests);
      drag_.reset();
      return true;
    }
    const spatial::Grid& grid = state.insight->field->grid;
    move_slice(state, drag_->grip.axis, dragged_to(drag_->grip, grid, view, drag_->from, mouse_now()), requests);
    return true;
  }
  hovered_ = -1;
  if (!hovered) return false;
  const auto reached = std::find_if(grips.begin(), grips.end(), [&](const SliceGrip& grip) {
    return (grip.at - mouse_now()).norm() <= ui.px(kReach_px);
  });
  if (reached == grips.end()) return false;
  hovered_ = reached->axis;
  ui.set_hint("Drag to move the slice, wheel: by one cell, Esc: back to where it was");
  const float wheel = ImGui::GetIO().MouseWheel;
  if (wheel != 0.0F) {
    const int last = state.insight->field->grid.n - 1;
    move_slice(state, hovered_, std::clamp(reached->index + (wheel > 0.0F ? 1 : -1), 0, last), requests);
  }
  if (ImGui::IsItemActivated() && ImGui::IsMouseDown(0)) drag_ = Drag{*reached, mouse_now()};
  return true;
}

void SliceOverlay::draw(Ui& ui, const WorkbenchState& state, const ViewPort& view) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const SliceGrip& grip : grips_of(state, view)) {
    const Rect& rect = view.rect;
    if (!rect.contains(grip.at.x(), grip.at.y())) continue;
    const bool taken = hovered_ == grip.axis || (drag_ && drag_->grip.axis == grip.axis);
    const Rgba colour = kAxisColours[static_cast<std::size_t>(grip.axis)];
    std::vector<ImVec2> outline;
    for (const Eigen::Vector2f& p : grip.outline) outline.push_back({p.x(), p.y()});
    list.AddPolyline(outline.data(), static_cast<int>(outline.size()), to_u32(colour, taken ? 1.0F : 0.55F),
                     ImDrawFlags_Closed, ui.px(taken ? 2.5F : 1.25F));
    const std::string letter(1, "xyz"[grip.axis]);
    const std::string words = taken ? fmt::format("{} = {}", letter, grip.index) : letter;
    const FontScope font(ui.fonts().small);
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    const float half = std::max(0.5F * size.x + ui.px(5), ui.px(9));
    list.AddRectFilled({grip.at.x() - half, grip.at.y() - ui.px(9)}, {grip.at.x() + half, grip.at.y() + ui.px(9)},
                       to_u32(colour), ui.px(4));
    list.AddText({std::round(grip.at.x() - 0.5F * size.x), std::round(grip.at.y() - 0.5F * size.y)},
                 IM_COL32(16, 18, 21, 255), words.c_str());
    note_grip(ui, "Slice " + letter, std::to_string(grip.index), grip.at, rect);
  }
}

}  // namespace trocar::ui
