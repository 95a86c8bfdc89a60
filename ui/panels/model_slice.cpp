#include "ui/panels/model_slice.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/figure/field_figure.h"
#include "ui/panels/colour_legend.h"
#include "ui/panels/slice_marks.h"

namespace trocar::ui {

int model_slice_index(const WorkbenchState& state, int axis) {
  const spatial::Grid& grid = state.insight->field->grid;
  const int chosen = state.field.slices[static_cast<std::size_t>(axis)];
  const spatial::CellCoordinates goal = grid.coordinates(state.insight->entry->model->goal);
  const int of_goal = axis == 0 ? goal.x : axis == 1 ? goal.y : goal.z;
  return std::clamp(chosen >= 0 ? chosen : of_goal, 0, grid.n - 1);
}

void step_model_slice(const WorkbenchState& state, int axis, Requests& requests) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsItemHovered() || io.MouseWheel == 0.0F) return;
  workbench::FieldSettings settings = state.field;
  const int last = state.insight->field->grid.n - 1;
  settings.slices[static_cast<std::size_t>(axis)] =
      std::clamp(model_slice_index(state, axis) + (io.MouseWheel > 0.0F ? 1 : -1), 0, last);
  requests.emplace_back(workbench::Command{workbench::SetField{settings}});
}

void paint_model_slice(Ui& ui, const WorkbenchState& state, const FieldShading& shading, std::string_view key, int axis,
                       const Rect& rect, float from, float to) {
  const int index = model_slice_index(state, axis);
  const Image picture = figure::slice_pixels(shading.field(), figure::Slice{axis, index}, shading.colouring());
  const std::uint64_t version =
      shading.revision() * 1000 + static_cast<std::uint64_t>(index) * 3 + static_cast<std::uint64_t>(axis);
  const ImTextureID texture = ui.textures().texture("model " + std::string(key), picture, version, Sampling::kNearest);
  const float x0 = rect.x0 + from * rect.width();
  const float x1 = rect.x0 + to * rect.width();
  ImGui::GetWindowDrawList()->AddImage(texture, {x0, rect.y0}, {x1, rect.y1}, {from, 0.0F}, {to, 1.0F});
}

void draw_model_slice(Ui& ui, const WorkbenchState& state, const FieldShading& shading,
                      const ModelSliceOptions& options, Requests& requests) {
  ImGui::BeginGroup();
  const float line = ImGui::GetCursorPosY();
  {
    // A long name ends at the picture's edge.
    const FontScope font(ui.fonts().small);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushClipRect(at, {at.x + options.side, at.y + ImGui::GetFontSize() * 1.5F}, true);
    ImGui::GetWindowDrawList()->AddText(at, to_u32(ui.theme().text_dim), options.title.data(),
                                        options.title.data() + options.title.size());
    ImGui::PopClipRect();
    ImGui::SetCursorPosY(line + ImGui::GetFontSize() + ui.px(4));
  }
  const std::string words = fmt::format("{} = {}", "xyz"[options.axis], model_slice_index(state, options.axis));
  canvas(ui, options.label, {options.side, options.side}, words,
         {.help = "The wheel steps through the slices of both"});
  const Rect rect = item_rect();
  step_model_slice(state, options.axis, requests);
  draw_hatch(ui, rect);
  paint_model_slice(ui, state, shading, options.label, options.axis, rect);
  draw_slice_outline(ui, *state.insight->entry->model, {options.axis, model_slice_index(state, options.axis), rect});
  draw_slice_ends(ui, *state.insight->entry->model, {options.axis, model_slice_index(state, options.axis), rect});
  ImGui::EndGroup();
}

}  // namespace trocar::ui
