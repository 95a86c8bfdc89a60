#include "ui/panels/learning_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/plot/colour_map.h"
#include "ui/format.h"
#include "ui/widgets/stroke.h"

namespace trocar::ui {
namespace {

/// From 0 up to a round number above the largest.
double top_of(const std::vector<double>& curve) {
  double largest = 0.0;
  for (const double value : curve) largest = std::isfinite(value) ? std::max(largest, value) : largest;
  const std::vector<double> marks = plot::ticks(0.0, std::max(largest, 1e-9), 4);
  const double step = marks.size() > 1 ? marks[1] - marks[0] : 1.0;
  return std::max(step, step * std::ceil(largest / step - 1e-9));
}

void draw_axes(Ui& ui, const Rect& area, double top, int epochs) {
  const FontScope font(ui.fonts().small);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 words = to_u32(ui.theme().text_dim);
  const ImU32 line = to_u32(ui.theme().line);
  const std::vector<double> marks = plot::ticks(0.0, top, 3);
  const double step = marks.size() > 1 ? marks[1] - marks[0] : 1.0;
  for (const double value : marks) {
    const float y = std::round(area.y1 - static_cast<float>(value / top) * area.height());
    const std::string text = plot::format_tick(value, step);
    list.AddRectFilled({area.x0, y}, {area.x1, y + 1.0F}, line);
    list.AddText({area.x0 - ui.px(6) - ImGui::CalcTextSize(text.c_str()).x, y - 0.5F * ImGui::GetFontSize()}, words,
                 text.c_str());
  }
  const std::string last = count(epochs);
  list.AddText({area.x0, area.y1 + ui.px(3)}, words, "0");
  list.AddText({area.x1 - ImGui::CalcTextSize(last.c_str()).x, area.y1 + ui.px(3)}, words, last.c_str());
}

/// Into the item drawn last; returns where the curve lies, whose width stands for `epochs`.
Rect draw_curve(Ui& ui, const std::vector<double>& curve, int epochs) {
  const Rect whole = item_rect();
  const Rect area{whole.x0 + ui.px(40), whole.y0 + ui.px(8), whole.x1 - ui.px(10), whole.y1 - ui.px(20)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({area.x0, area.y0}, {area.x1, area.y1}, to_u32(ui.theme().ground));
  const double top = top_of(curve);
  draw_axes(ui, area, top, epochs);
  std::vector<ImVec2> points;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!std::isfinite(curve[i])) continue;
    const auto across = static_cast<float>((static_cast<double>(i) + 1.0) / std::max(epochs, 1));
    const auto up = static_cast<float>(std::clamp(curve[i] / top, 0.0, 1.0));
    points.push_back({area.x0 + across * area.width(), area.y1 - up * area.height()});
  }
  stroke(list, points, to_u32(ui.theme().accent), ui.px(1.5F));
  return area;
}

}  // namespace

void growing_curve(Ui& ui, const std::vector<double>& curve, int epochs, float height) {
  const int done = static_cast<int>(curve.size());
  const std::string value = epochs > 0 ? fmt::format("epoch {} of {}", done, epochs) : fmt::format("epoch {}", done);
  canvas(ui, "Learning curve", {ImGui::GetContentRegionAvail().x, height}, value,
         {.help = "Mismatch of visits ‖f − D‖ / ‖f‖ by epoch, so far"});
  draw_curve(ui, curve, std::max(epochs, done));
}

std::optional<int> learning_curve(Ui& ui, const std::vector<double>& curve, int epoch, float height) {
  const int epochs = static_cast<int>(curve.size());
  const std::string value = fmt::format("epoch {} of {}", epoch, epochs);
  canvas(ui, "Learning curve", {ImGui::GetContentRegionAvail().x, height}, value,
         {.help = "Mismatch of visits ‖f − D‖ / ‖f‖ by epoch; click or drag to see what was known then"});
  const Rect area = draw_curve(ui, curve, epochs);
  const Theme& theme = ui.theme();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float x =
      std::round(area.x0 + static_cast<float>(epoch) / static_cast<float>(std::max(epochs, 1)) * area.width());
  list.AddRectFilled({x, area.y0}, {x + std::max(ui.px(1.5F), 1.0F), area.y1}, to_u32(theme.text));
  const ImGuiIO& io = ImGui::GetIO();
  std::optional<int> chosen;
  if (ImGui::IsItemActive() && io.MouseDown[0] && area.width() > 0.0F) {
    const double share = std::clamp((io.MousePos.x - area.x0) / area.width(), 0.0F, 1.0F);
    chosen = static_cast<int>(std::lround(share * epochs));
  }
  if (chosen && *chosen == epoch) chosen.reset();
  return chosen;
}

}  // namespace trocar::ui
