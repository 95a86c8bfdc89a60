#include "ui/panels/colour_legend.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace trocar::ui {
namespace {

void draw_classes(Ui& ui, const FieldShading& shading) {
  const std::vector<std::string>& names = shading.field().categories;
  const FontScope font(ui.fonts().small);
  const float side = ui.px(12);
  const float right = ImGui::GetWindowContentRegionMax().x;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const float needed = side + ui.px(20) + ImGui::CalcTextSize(names[i].c_str()).x;
    if (i > 0) {
      ImGui::SameLine(0.0F, ui.px(14));
      if (ImGui::GetCursorPosX() + needed > right) ImGui::NewLine();
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + ui.px(2)}, {at.x + side, at.y + ui.px(2) + side},
                                              to_u32(shading.colouring().colour(static_cast<double>(i))), ui.px(2));
    ImGui::Dummy({side, side});
    ImGui::SameLine(0.0F, ui.px(6));
    text(ui, names[i]);
  }
}

void draw_ticks(Ui& ui, const FieldShading& shading, const Rect& bar) {
  const FontScope font(ui.fonts().small);
  const plot::Scale& scale = shading.colouring().scale;
  const int wanted = std::max(2, static_cast<int>(bar.width() / ui.px(62)));
  const std::vector<double> values = plot::ticks(scale, wanted);
  const std::vector<std::string> words = plot::format_ticks(scale, values);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float free_from = bar.x0 - 1.0F;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float x = bar.x0 + static_cast<float>(scale.position(values[i])) * bar.width();
    const float width = ImGui::CalcTextSize(words[i].c_str()).x;
    const float left = std::clamp(x - 0.5F * width, bar.x0, bar.x1 - width);
    list.AddRectFilled({x, bar.y1}, {x + 1.0F, bar.y1 + ui.px(4)}, to_u32(ui.theme().text_dim));
    if (left < free_from) continue;
    list.AddText({std::round(left), bar.y1 + ui.px(4)}, to_u32(ui.theme().text_dim), words[i].c_str());
    free_from = left + width + ui.px(8);
  }
}

}  // namespace

void draw_hatch(Ui& ui, const Rect& rect) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImDrawListFlags flags = list.Flags;
  list.Flags &= ~ImDrawListFlags_AntiAliasedLines;
  list.AddRectFilled({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(ui.theme().header));
  list.PushClipRect({rect.x0, rect.y0}, {rect.x1, rect.y1}, true);
  const float step = ui.px(7);
  const int lines = static_cast<int>(std::ceil((rect.width() + rect.height()) / step));
  for (int i = 0; i < lines; ++i) {
    const float x = rect.x0 - rect.height() + static_cast<float>(i) * step;
    list.AddLine({x, rect.y1}, {x + rect.height(), rect.y0}, to_u32(ui.theme().line), 1.0F);
  }
  list.PopClipRect();
  list.Flags = flags;
}

void colour_legend(Ui& ui, const FieldShading& shading, double marked) {
  if (shading.field().categorical) {
    draw_classes(ui, shading);
    return;
  }
  const std::string& unit = shading.field().unit;
  small_text(ui, shading.field().title + (unit.empty() ? "" : ", " + unit), ui.theme().text_dim);
  ImGui::Dummy({0.0F, ui.px(2)});
  const float height = ui.px(12);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect bar{at.x, at.y, at.x + ImGui::GetContentRegionAvail().x, at.y + height};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  constexpr int kSteps = 48;
  for (int i = 0; i < kSteps; ++i) {
    const float x0 = std::round(bar.x0 + bar.width() * static_cast<float>(i) / kSteps);
    const float x1 = std::round(bar.x0 + bar.width() * static_cast<float>(i + 1) / kSteps);
    const Rgba colour = shading.colouring().colour_at((i + 0.5) / kSteps);
    list.AddRectFilled({x0, bar.y0}, {x1, bar.y1}, to_u32(colour));
  }
  draw_ticks(ui, shading, bar);
  if (std::isfinite(marked)) {
    const float x = std::round(bar.x0 + static_cast<float>(shading.colouring().scale.position(marked)) * bar.width());
    const float half = ui.px(4);
    list.AddTriangleFilled({x - half, bar.y0 - ui.px(6)}, {x + half, bar.y0 - ui.px(6)}, {x, bar.y0},
                           to_u32(ui.theme().text));
  }
  ImGui::Dummy({bar.width(), height + ui.px(4) + ui.fonts().small->FontSize});
}

}  // namespace trocar::ui
