#include "ui/panels/field_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/format.h"
#include "ui/panels/colour_legend.h"
#include "ui/panels/rollout_parts.h"

namespace trocar::ui {
namespace {

constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};

double value_at(const learning::Field& field, spatial::CellCoordinates at, int axis, int index) {
  (axis == 0 ? at.x : axis == 1 ? at.y : at.z) = index;
  return field.values[static_cast<std::size_t>(field.grid.index(at).value)];
}

std::string words_of(const learning::Field& field, double value) {
  if (!std::isfinite(value)) return "unknown";
  const auto i = static_cast<std::size_t>(std::max(0L, std::lround(value)));
  return field.categorical && i < field.categories.size() ? field.categories[i] : number(value);
}

void draw_line(Ui& ui, const FieldShading& shading, const spatial::CellCoordinates& at, int axis) {
  const learning::Field& field = shading.field();
  const int n = field.grid.n;
  const int here = axis == 0 ? at.x : axis == 1 ? at.y : at.z;
  const float name_width = ui.px(14);
  const float height = ui.px(30);
  const float value_width = ui.px(64);
  const Rect mouse_area = {ImGui::GetCursorScreenPos().x + name_width, ImGui::GetCursorScreenPos().y,
                           ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x - value_width,
                           ImGui::GetCursorScreenPos().y + height};
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  int told = here;
  if (mouse_area.contains(mouse.x, mouse.y)) {
    told =
        std::clamp(static_cast<int>((mouse.x - mouse_area.x0) / mouse_area.width() * static_cast<float>(n)), 0, n - 1);
  }
  const std::string_view name = kNames[static_cast<std::size_t>(axis)];
  const std::string value = fmt::format("{} = {}: {}", name, told, words_of(field, value_at(field, at, axis, told)));
  chart_area(ui, name, {ImGui::GetContentRegionAvail().x, height}, value, {.help = value});
  const Rect rect = item_rect();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText({rect.x0, rect.centre_y() - 0.5F * ImGui::GetFontSize()}, to_u32(ui.theme().text_dim), name.data(),
               name.data() + name.size());
  const Rect area{rect.x0 + name_width, rect.y0, rect.x1 - value_width, rect.y1};
  const std::string shown = fitted(words_of(field, value_at(field, at, axis, told)), value_width - ui.px(6));
  list.AddText({rect.x1 - ImGui::CalcTextSize(shown.c_str()).x, rect.centre_y() - 0.5F * ImGui::GetFontSize()},
               to_u32(ui.theme().text), shown.c_str());
  draw_hatch(ui, area);  // what is not known stays so
  const float step = area.width() / static_cast<float>(n);
  const float gap = step > ui.px(4) ? ui.px(1) : 0.0F;
  for (int i = 0; i < n; ++i) {
    const float x = area.x0 + static_cast<float>(i) * step;
    const double of_cell = value_at(field, at, axis, i);
    const Rgba colour = shading.colouring().colour(of_cell);
    if (colour.a > 0) list.AddRectFilled({x, area.y0}, {x + step, area.y1}, to_u32(ui.theme().header));
    if (i == here) list.AddRectFilled({x, area.y0}, {x + step, area.y1}, to_u32(ui.theme().text, 0.22F));
    if (colour.a == 0) continue;
    const double place = field.categorical ? 1.0 : shading.axis().position(of_cell);
    const float top = area.y1 - std::max(static_cast<float>(place) * (area.height() - ui.px(2)), ui.px(2));
    list.AddRectFilled({x, top}, {x + step - gap, area.y1}, to_u32(colour));
  }
}

}  // namespace

void draw_field_lines(Ui& ui, const FieldShading& shading, const spatial::CellCoordinates& at) {
  const Scope scope(ui, "Through the cell");
  const FontScope font(ui.fonts().small);
  dim_text(ui, "Along x, y and z through the cell");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(3)});
  for (int axis = 0; axis < 3; ++axis) draw_line(ui, shading, at, axis);
  ImGui::PopStyleVar();
}

}  // namespace trocar::ui
