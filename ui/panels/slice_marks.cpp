#include "ui/panels/slice_marks.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "ui/panels/field_shading.h"

namespace trocar::ui {
namespace {

constexpr ImU32 kDark = IM_COL32(16, 18, 21, 170);
constexpr ImU32 kPale = IM_COL32(240, 243, 247, 230);

int along(const spatial::CellCoordinates& cell, int axis) {
  return axis == 0 ? cell.x : axis == 1 ? cell.y : cell.z;
}

/// Cells of a slice as places on its picture.
struct Plane {
  const learning::Model& model;
  const SlicePlace& place;
  SliceAxes axes = slice_axes(place.axis);
  float cell_px = place.rect.width() / static_cast<float>(model.grid.n);

  float x(int right) const { return place.rect.x0 + cell_px * static_cast<float>(right); }
  float y(int up) const { return place.rect.y1 - cell_px * static_cast<float>(up); }
  ImVec2 middle(const spatial::CellCoordinates& cell) const {
    return {x(along(cell, axes.right)) + 0.5F * cell_px, y(along(cell, axes.up)) - 0.5F * cell_px};
  }
  bool cuts(const spatial::CellCoordinates& cell) const { return along(cell, place.axis) == place.index; }
  bool safe(int right, int up) const {
    const int n = model.grid.n;
    if (right < 0 || up < 0 || right >= n || up >= n) return false;
    spatial::CellCoordinates cell;
    for (int axis = 0; axis < 3; ++axis) {
      int& value = axis == 0 ? cell.x : axis == 1 ? cell.y : cell.z;
      value = axis == axes.right ? right : axis == axes.up ? up : place.index;
    }
    return model.safe.contains(model.grid.index(cell));
  }
};

void dot(ImVec2 at, float radius, Rgba colour, Rgba ring) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(at, radius + 1.5F, to_u32(ring), 16);
  list.AddCircleFilled(at, radius, to_u32(colour), 16);
}

void line(const Ui& ui, ImVec2 from, ImVec2 to) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine(from, to, kDark, ui.px(2.5F));
  list.AddLine(from, to, kPale, ui.px(1));
}

}  // namespace

void draw_slice_outline(const Ui& ui, const learning::Model& model, const SlicePlace& place) {
  const Plane plane{model, place};
  const int n = model.grid.n;
  for (int right = 0; right <= n; ++right) {
    for (int up = 0; up <= n; ++up) {
      const bool here = plane.safe(right, up);
      if (here != plane.safe(right - 1, up)) {
        line(ui, {plane.x(right), plane.y(up)}, {plane.x(right), plane.y(up + 1)});
      }
      if (here != plane.safe(right, up - 1)) {
        line(ui, {plane.x(right), plane.y(up)}, {plane.x(right + 1), plane.y(up)});
      }
    }
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float radius = std::max(0.2F * plane.cell_px, 1.0F);
  for (const learning::CellSequence& expert : model.experts) {
    for (const spatial::CellIndex cell : expert) {
      const spatial::CellCoordinates at = model.grid.coordinates(cell);
      if (!plane.cuts(at)) continue;
      list.AddCircleFilled(plane.middle(at), radius + 1.0F, kDark, 10);
      list.AddCircleFilled(plane.middle(at), radius, kPale, 10);
    }
  }
}

void draw_slice_ends(Ui& ui, const learning::Model& model, const SlicePlace& place) {
  const Plane plane{model, place};
  const auto mark = [&](spatial::CellIndex index, std::string_view letter, Rgba colour) {
    const spatial::CellCoordinates cell = model.grid.coordinates(index);
    if (!plane.cuts(cell)) return;
    const ImVec2 at = plane.middle(cell);
    dot(at, ui.px(6), colour, {16, 18, 21, 255});
    const FontScope font(ui.fonts().small);
    const ImVec2 size = ImGui::CalcTextSize(letter.data(), letter.data() + letter.size());
    ImGui::GetWindowDrawList()->AddText({std::round(at.x - 0.5F * size.x), std::round(at.y - 0.5F * size.y)},
                                        IM_COL32(16, 18, 21, 255), letter.data(), letter.data() + letter.size());
  };
  mark(model.start, "S", {240, 240, 240, 255});
  mark(model.goal, "G", {255, 200, 60, 255});
}

}  // namespace trocar::ui
