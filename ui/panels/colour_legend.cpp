#include "ui/panels/colour_legend.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ui/icons.h"

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
  const plot::Scale& scale = shading.axis();
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

void draw_title(Ui& ui, const FieldShading& shading, const LegendOptions& options) {
  const std::string& unit = shading.field().unit;
  small_text(ui, shading.field().title + (unit.empty() ? "" : ", " + unit), ui.theme().text_dim);
  if (options.stale) {
    ImGui::SameLine(0.0F, ui.px(8));
    badge(ui, icon::kWarning, "stale", ui.theme().warning,
          "A demonstration that this was learned from has been edited since");
  }
  ImGui::Dummy({0.0F, ui.px(2)});
}

// The few values that most cells do not have would not be seen: heights are square roots.
void draw_histogram(Ui& ui, const FieldShading& shading, const Rect& rect) {
  const std::vector<float>& bins = shading.histogram();
  const float each = rect.width() / static_cast<float>(bins.size());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (bins[i] <= 0.0F) continue;
    const float x0 = std::round(rect.x0 + each * static_cast<float>(i));
    const float x1 = std::max(std::round(rect.x0 + each * static_cast<float>(i + 1)) - 1.0F, x0 + 1.0F);
    const float height = std::max(std::sqrt(bins[i]) * (rect.height() - ui.px(2)), 1.0F);
    list.AddRectFilled({x0, rect.y1 - height}, {x1, rect.y1}, to_u32(ui.theme().text_dim, 0.55F));
  }
}

void draw_bar(const FieldShading& shading, const Rect& bar) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  constexpr int kSteps = 64;
  for (int i = 0; i < kSteps; ++i) {
    const float x0 = std::round(bar.x0 + bar.width() * static_cast<float>(i) / kSteps);
    const float x1 = std::round(bar.x0 + bar.width() * static_cast<float>(i + 1) / kSteps);
    const Rgba colour = shading.colouring().colour(shading.axis().value((i + 0.5) / kSteps));
    list.AddRectFilled({x0, bar.y0}, {x1, bar.y1}, to_u32(colour));
  }
}

// A handle at one end of what the colours span; `which` 0: the low one.
void take_limit(Ui& ui, const FieldShading& shading, const char* label, std::size_t which, const Rect& rect,
                std::optional<std::array<double, 2>>& limits) {
  const plot::Scale& axis = shading.axis();
  const plot::Scale& shown = shading.colouring().scale;
  const std::array<double, 2> now{shown.low, shown.high};
  const float x = std::round(rect.x0 + static_cast<float>(axis.position(now[which])) * rect.width());
  const float width = ui.px(14);
  // Side by side, so that both can be taken where they meet.
  ImGui::SetCursorScreenPos({which == 0 ? x - width : x, rect.y0});
  if (which == 0 && x - width < rect.x0) ImGui::SetCursorScreenPos({rect.x0, rect.y0});
  if (which == 1 && x + width > rect.x1) ImGui::SetCursorScreenPos({rect.x1 - width, rect.y0});
  const std::vector<std::string> words = plot::format_ticks(shown, {shown.low, shown.high});
  const bool hovered = canvas(ui, label, {width, rect.height()}, words[which],
                              {.help = "Drag to where the colours end; double click: as the values are"});
  const bool active = ImGui::IsItemActive();
  if (hovered || active) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Rgba colour = hovered || active ? ui.theme().accent : limits ? ui.theme().text : ui.theme().text_dim;
  list.AddRectFilled({x - 1.0F, rect.y0}, {x + 1.0F, rect.y1}, to_u32(colour));
  const float grip = ui.px(5);
  const float out = which == 0 ? grip : -grip;
  list.AddTriangleFilled({x, rect.y0}, {x + out, rect.y0}, {x, rect.y0 + grip}, to_u32(colour));
  if (hovered && ImGui::IsMouseDoubleClicked(0)) {
    limits.reset();
    return;
  }
  if (!active || !ImGui::IsMouseDragging(0, 1.0F)) return;
  std::array<double, 2> moved = now;
  moved[which] = axis.value(static_cast<double>((ImGui::GetIO().MousePos.x - rect.x0) / rect.width()));
  // At least a hundredth of the bar apart.
  const double gap = 0.01;
  if (axis.position(moved[1]) - axis.position(moved[0]) < gap) return;
  limits = moved;
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

std::optional<std::array<double, 2>> colour_legend(Ui& ui, const FieldShading& shading, double marked,
                                                   const LegendOptions& options) {
  draw_title(ui, shading, options);
  if (shading.field().categorical) {
    draw_classes(ui, shading);
    return options.limits;
  }
  const std::vector<double>& values = shading.field().values;
  if (std::none_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); })) {
    wrapped_text(ui, "No cell of this layer is known to the model", ui.theme().text_dim);
    return options.limits;
  }
  const Scope scope(ui, "Colour bar");
  const float height = ui.px(12);
  const float above = ui.px(26);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect bar{at.x, at.y + above, at.x + ImGui::GetContentRegionAvail().x, at.y + above + height};
  draw_histogram(ui, shading, {bar.x0, at.y, bar.x1, bar.y0});
  draw_bar(shading, bar);
  draw_ticks(ui, shading, bar);
  if (std::isfinite(marked)) {
    const float x = std::round(bar.x0 + static_cast<float>(shading.axis().position(marked)) * bar.width());
    const float half = ui.px(4);
    ImGui::GetWindowDrawList()->AddTriangleFilled({x - half, bar.y0 - ui.px(6)}, {x + half, bar.y0 - ui.px(6)},
                                                  {x, bar.y0}, to_u32(ui.theme().text));
  }
  std::optional<std::array<double, 2>> limits = options.limits;
  // Of rank, the colours are spent on all values alike.
  if (shading.axis().kind != plot::ScaleKind::kRank) {
    take_limit(ui, shading, "Low limit", 0, {bar.x0, at.y, bar.x1, bar.y1}, limits);
    take_limit(ui, shading, "High limit", 1, {bar.x0, at.y, bar.x1, bar.y1}, limits);
  }
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({bar.width(), above + height + ui.px(4) + ui.fonts().small->FontSize});
  return limits;
}

}  // namespace trocar::ui
