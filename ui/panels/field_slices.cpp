#include "ui/panels/field_slices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ui/icons.h"
#include "ui/panels/colour_legend.h"
#include "ui/panels/slice_marks.h"

namespace trocar::ui {
namespace {

using workbench::Command;
using workbench::SetField;

constexpr float kLeastSlice = 160.0F;  // Pixels at 100 %.
constexpr float kLeastTile = 56.0F;    // Likewise.
constexpr std::array<const char*, 3> kAxisNames{"x", "y", "z"};

int& coordinate(spatial::CellCoordinates& cell, int axis) {
  return axis == 0 ? cell.x : axis == 1 ? cell.y : cell.z;
}

int coordinate(const spatial::CellCoordinates& cell, int axis) {
  return axis == 0 ? cell.x : axis == 1 ? cell.y : cell.z;
}

// What stands above and below the picture of a slice: its axes and its slider.
float below_slice(const Ui& ui) {
  return ImGui::GetFrameHeightWithSpacing() + ui.fonts().small->FontSize + ImGui::GetStyle().ItemSpacing.y;
}

constexpr int kMostOutlined = 44;

// Columns that give the largest square tiles in the room, and their side.
std::pair<int, float> tiles_for(int count, ImVec2 room, float gap) {
  std::pair<int, float> best{1, 0.0F};
  for (int columns = 1; columns <= count; ++columns) {
    const int rows = (count + columns - 1) / columns;
    const float across = (room.x - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    const float down = (room.y - gap * static_cast<float>(rows - 1)) / static_cast<float>(rows);
    const float side = std::floor(std::min(across, down));
    if (side > best.second) best = {columns, side};
  }
  return best;
}

}  // namespace

void FieldSlices::update(const WorkbenchState& state) {
  const spatial::Grid& grid = state.insight->field->grid;
  n_ = grid.n;
  pinned_.reset();
  // The insight may be another model's for a moment after a change.
  const workbench::ModelId shown = state.insight->entry->id;
  if (placed_for_ != shown) {
    placed_for_ = shown;
    const spatial::CellCoordinates goal = grid.coordinates(state.insight->entry->model->goal);
    index_ = {goal.x, goal.y, goal.z};
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (state.field.slices[i] >= 0) index_[i] = state.field.slices[i];
    index_[i] = std::clamp(index_[i], 0, n_ - 1);
  }
}

std::string FieldSlices::focused() const {
  if (n_ == 0) return "";
  const auto axis = static_cast<std::size_t>(focus_ < 0 ? 2 : focus_);
  return fmt::format("{}={}", kAxisNames[axis], index_[axis]);
}

void FieldSlices::move_to(const spatial::CellCoordinates& cell, const WorkbenchState& state, Requests& requests) {
  workbench::FieldSettings settings = state.field;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    index_[i] = coordinate(cell, axis);
    if (settings.slices[i] >= 0) settings.slices[i] = index_[i];
  }
  if (settings != state.field) requests.emplace_back(Command{SetField{settings}});
}

void FieldSlices::take_wheel(int axis, const WorkbenchState& state, Requests& requests) {
  // With Shift some systems turn the wheel's axis.
  const ImGuiIO& io = ImGui::GetIO();
  const float turned = io.MouseWheel != 0.0F ? io.MouseWheel : io.KeyShift ? io.MouseWheelH : 0.0F;
  if (turned == 0.0F) return;
  const int step = turned > 0.0F ? 1 : -1;
  const auto i = static_cast<std::size_t>(axis);
  if (io.KeyShift) {
    workbench::FieldSettings settings = state.field;
    settings.slabs[i] = std::clamp(settings.slabs[i] + step, 1, n_);
    if (settings != state.field) requests.emplace_back(Command{SetField{settings}});
    return;
  }
  spatial::CellCoordinates cell = at();
  coordinate(cell, axis) = std::clamp(index_[i] + step, 0, n_ - 1);
  move_to(cell, state, requests);
}

void FieldSlices::take_mouse(int axis, const Rect& rect, bool hovered, const WorkbenchState& state,
                             Requests& requests) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool dragged = ImGui::IsItemActive() && io.MouseDown[0];
  if (!hovered && !dragged) return;
  const SliceAxes axes = slice_axes(axis);
  const float u = (io.MousePos.x - rect.x0) / rect.width();
  const float v = (rect.y1 - io.MousePos.y) / rect.height();
  spatial::CellCoordinates cell;
  coordinate(cell, axis) = index_[static_cast<std::size_t>(axis)];
  coordinate(cell, axes.right) = std::clamp(static_cast<int>(u * static_cast<float>(n_)), 0, n_ - 1);
  coordinate(cell, axes.up) = std::clamp(static_cast<int>(v * static_cast<float>(n_)), 0, n_ - 1);
  hovered_ = cell;
  if (ImGui::IsItemClicked(0) && io.KeyShift) pinned_ = cell;
  if (dragged) move_to(cell, state, requests);
  if (hovered) take_wheel(axis, state, requests);
}

void FieldSlices::draw_marks(Ui& ui, const WorkbenchState& state, int axis, const Rect& rect) const {
  const spatial::Grid& grid = state.insight->field->grid;
  const SliceAxes axes = slice_axes(axis);
  const float cell_px = rect.width() / static_cast<float>(grid.n);
  const auto middle = [&](int right, int up) {
    return ImVec2{rect.x0 + (static_cast<float>(right) + 0.5F) * cell_px,
                  rect.y1 - (static_cast<float>(up) + 0.5F) * cell_px};
  };
  draw_slice_outline(ui, *state.insight->entry->model, {axis, index_[static_cast<std::size_t>(axis)], rect});
  const ImVec2 cross = middle(index_[static_cast<std::size_t>(axes.right)], index_[static_cast<std::size_t>(axes.up)]);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 line = IM_COL32(255, 255, 255, 110);
  list.AddRectFilled({std::round(cross.x), rect.y0}, {std::round(cross.x) + 1.0F, rect.y1}, line);
  list.AddRectFilled({rect.x0, std::round(cross.y)}, {rect.x1, std::round(cross.y) + 1.0F}, line);
  draw_slice_ends(ui, *state.insight->entry->model, {axis, index_[static_cast<std::size_t>(axis)], rect});
}

void FieldSlices::draw_below(Ui& ui, const WorkbenchState& state, int axis, float right, Requests& requests) {
  const auto i = static_cast<std::size_t>(axis);
  workbench::FieldSettings settings = state.field;
  const bool in_view = settings.slices[i] >= 0;
  if (toggle(ui, "3-D", in_view, {.icon = icon::kEye, .help = "Show this slice in the 3-D view"})) {
    settings.slices[i] = in_view ? -1 : index_[i];
    requests.emplace_back(Command{SetField{settings}});
  }
  ImGui::SameLine(0.0F, ui.px(4));
  const std::string format = std::string(kAxisNames[i]) + " = %d";
  int index = index_[i];
  if (slider_int(ui, "Index", index, 0, n_ - 1, format.c_str(),
                 {.width = std::max(right - ImGui::GetCursorScreenPos().x, ui.px(40))})) {
    spatial::CellCoordinates cell = at();
    coordinate(cell, axis) = index;
    move_to(cell, state, requests);
  }
}

void FieldSlices::draw_slice(Ui& ui, const WorkbenchState& state, FieldShading& shading, int axis, ImVec2 size,
                             Requests& requests) {
  const auto i = static_cast<std::size_t>(axis);
  const Scope scope(ui, kAxisNames[i]);
  const SliceAxes axes = slice_axes(axis);
  const int slab = std::clamp(state.field.slabs[i], 1, n_);
  ImGui::BeginGroup();
  {
    // Not as an item: beside another slice it would be set on that one's baseline.
    const FontScope font(ui.fonts().small);
    std::string names = fmt::format("{} →  {} ↑", kAxisNames[static_cast<std::size_t>(axes.right)],
                                    kAxisNames[static_cast<std::size_t>(axes.up)]);
    if (slab > 1) names += fmt::format("   {} of {}", learning::to_string(state.field.through), slab);
    ImGui::GetWindowDrawList()->AddText(ImGui::GetCursorScreenPos(), to_u32(ui.theme().text_dim), names.c_str());
    ImGui::Dummy({size.x, ImGui::GetFontSize()});
  }
  const float side = std::min(size.x, size.y - below_slice(ui));
  const std::string value = std::to_string(index_[i]) + (slab > 1 ? fmt::format(" of {}", slab) : "");
  const bool hovered = canvas(ui, "Slice", {side, side}, value,
                              {.help = "Click to cut there, Shift+click to pin the cell, wheel to step, Shift+wheel "
                                       "for a thicker slice, X, Y and Z for one alone"});
  const Rect rect = item_rect();
  take_mouse(axis, rect, hovered, state, requests);
  draw_hatch(ui, rect);
  const Image& picture = shading.slice(axis, index_[i], {slab, state.field.through});
  const ImTextureID texture =
      ui.textures().texture(fmt::format("slice {}", axis), picture, shading.version(axis), Sampling::kNearest);
  ImGui::GetWindowDrawList()->AddImage(texture, {rect.x0, rect.y0}, {rect.x1, rect.y1});
  draw_marks(ui, state, axis, rect);
  draw_below(ui, state, axis, rect.x1, requests);
  ImGui::EndGroup();
}

void FieldSlices::draw(Ui& ui, const WorkbenchState& state, FieldShading& shading, Requests& requests) {
  hovered_.reset();
  beside_ = false;
  const float gap = ui.px(10);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float frame = below_slice(ui);
  const float half = 0.5F * (room.x - gap);
  const bool narrow = half < ui.px(kLeastSlice);
  if (focus_ >= 0) {
    // As large as there is room for, the probe beside it.
    const float most = narrow ? room.x : std::max(room.x - ui.px(220) - gap, ui.px(kLeastSlice));
    const float side = std::max(std::min(most, room.y - frame), std::min(room.x, ui.px(kLeastSlice)));
    draw_slice(ui, state, shading, focus_, {side, side + frame}, requests);
    beside_ = !narrow;
    if (beside_) ImGui::SameLine(0.0F, gap);
    return;
  }
  if (narrow) {
    // One below the other, the panel scrolls.
    const float side = std::min(room.x, ui.px(280));
    for (const int axis : {2, 0, 1}) draw_slice(ui, state, shading, axis, {side, side + frame}, requests);
    return;
  }
  // Two by two: three slices and the probe; where the room is low, the slices shrink.
  const float side = std::max(std::min(half, 0.5F * (room.y - gap) - frame), ui.px(kLeastSlice));
  const ImVec2 size{side, side + frame};
  draw_slice(ui, state, shading, 2, size, requests);
  ImGui::SameLine(0.0F, gap);
  draw_slice(ui, state, shading, 0, size, requests);
  draw_slice(ui, state, shading, 1, size, requests);
  ImGui::SameLine(0.0F, gap);
  beside_ = true;
}

bool FieldSlices::draw_montage(Ui& ui, const WorkbenchState& state, FieldShading& shading, Requests& requests) {
  const Scope scope(ui, "Montage");
  hovered_.reset();
  const float gap = ui.px(3);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  auto [columns, side] = tiles_for(n_, room, gap);
  if (side < ui.px(kLeastTile)) {
    // The panel scrolls.
    columns = std::max(1, static_cast<int>((room.x + gap) / (ui.px(kLeastTile) + gap)));
    side = std::floor((room.x - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
  }
  const Image& picture = shading.montage({std::clamp(state.field.slabs[2], 1, n_), state.field.through});
  const ImTextureID texture = ui.textures().texture("montage", picture, shading.montage_version(), Sampling::kNearest);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  const FontScope font(ui.fonts().small);
  bool chosen = false;
  for (int z = 0; z < n_; ++z) {
    if (z % columns != 0) ImGui::SameLine(0.0F, gap);
    const std::string name = fmt::format("z = {}", z);
    const bool hovered = canvas(ui, name, {side, side}, "", {.help = "Click to look at this slice"});
    const bool clicked = ImGui::IsItemClicked(0);
    const Rect rect = item_rect();
    draw_hatch(ui, rect);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto from = static_cast<float>(z) / static_cast<float>(n_);
    const auto to = static_cast<float>(z + 1) / static_cast<float>(n_);
    list.AddImage(texture, {rect.x0, rect.y0}, {rect.x1, rect.y1}, {0.0F, from}, {1.0F, to});
    // The outline of very many small cells would cost more than the field itself.
    if (n_ <= kMostOutlined) draw_slice_outline(ui, *state.insight->entry->model, {2, z, rect});
    const ImVec2 words = ImGui::CalcTextSize(name.c_str());
    list.AddRectFilled({rect.x0, rect.y0}, {rect.x0 + words.x + ui.px(6), rect.y0 + words.y + ui.px(2)},
                       IM_COL32(16, 18, 21, 190));
    list.AddText({rect.x0 + ui.px(3), rect.y0 + ui.px(1)}, IM_COL32(240, 243, 247, 255), name.c_str());
    const bool here = z == index_[2];
    if (here || hovered) {
      list.AddRect({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(here ? ui.theme().accent : ui.theme().text), 0.0F, 0,
                   ui.px(2));
    }
    if (clicked) {
      spatial::CellCoordinates cell = at();
      cell.z = z;
      move_to(cell, state, requests);
      chosen = true;
    }
  }
  ImGui::PopStyleVar();
  return chosen;
}

}  // namespace trocar::ui
