#include "ui/panels/rollout_arrivals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ui/format.h"
#include "ui/panels/rollout_parts.h"
#include "ui/widgets/stroke.h"

namespace trocar::ui {
namespace {

/// Dashes and gaps run on round the corners. Pixels of the screen.
void stroke_dashed(ImDrawList& list, const std::vector<ImVec2>& points, ImU32 colour, float width, float dash,
                   float gap) {
  float at = 0.0F;  // Along the line, since a dash began.
  for (std::size_t i = 1; i < points.size(); ++i) {
    const ImVec2 a = points[i - 1];
    const ImVec2 b = points[i];
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    for (float from = 0.0F; from < length;) {
      const bool drawn = at < dash;
      const float to = std::min(length, from + (drawn ? dash : dash + gap) - at);
      const auto point = [&](float s) {
        return ImVec2{a.x + s / length * (b.x - a.x), a.y + s / length * (b.y - a.y)};
      };
      if (drawn) list.AddLine(point(from), point(to), colour, width);
      at += to - from;
      if (at >= dash + gap - 1e-3F) at = 0.0F;
      from = std::max(to, from + 1e-3F);
    }
  }
}

}  // namespace

void RolloutArrivals::update(const std::shared_ptr<const workbench::ModelInsight>& insight) {
  if (of_ == insight) return;
  of_ = insight;
  starts_ = static_cast<int>(insight->starts.size());
  arrived_[0] = learning::arrivals_by_step(*insight->basin, insight->starts);
  arrived_[1].clear();
  if (insight->second) {
    arrived_[1] = learning::arrivals_by_step(insight->second->comparison->basin_b, insight->starts);
    const std::size_t longest = std::max(arrived_[0].size(), arrived_[1].size());
    for (std::vector<int>& curve : arrived_) curve.resize(longest, curve.back());
  }
}

std::string RolloutArrivals::words_at(std::size_t step) const {
  const auto share = [&](std::size_t model) {
    const int arrived = arrived_[model][step];
    return fmt::format("{} ({})", percent(arrived, starts_), count(arrived));
  };
  if (arrived_[1].empty()) return fmt::format("within {} steps: {}", step, share(0));
  return fmt::format("within {} steps: A {}, B {}", step, share(0), share(1));
}

void RolloutArrivals::draw_curves(Ui& ui, const Rect& area) const {
  const Theme& theme = ui.theme();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto last = static_cast<float>(std::max<std::size_t>(arrived_[0].size() - 1, 1));
  for (std::size_t model = 0; model < arrived_.size(); ++model) {
    std::vector<ImVec2> points;
    for (std::size_t step = 0; step < arrived_[model].size(); ++step) {
      const float x = area.x0 + static_cast<float>(step) / last * area.width();
      const float share = static_cast<float>(arrived_[model][step]) / static_cast<float>(std::max(starts_, 1));
      const float y = area.y1 - share * area.height();
      if (!points.empty()) points.push_back({x, points.back().y});
      points.push_back({x, y});
    }
    const ImU32 colour = to_u32(model == 0 ? theme.accent : theme.warning);
    if (model == 0) stroke(list, points, colour, ui.px(2));
    // The second differs in more than its colour.
    if (model == 1) stroke_dashed(list, points, colour, ui.px(2), ui.px(6), ui.px(4));
  }
}

void RolloutArrivals::draw(Ui& ui, const std::shared_ptr<const workbench::ModelInsight>& insight) {
  const Scope scope(ui, "Arrivals");
  update(insight);
  heading(ui, "Arrived by step");
  if (starts_ == 0 || (arrived_[0].size() < 2 && arrived_[1].size() < 2)) {
    wrapped_text(ui, "No start arrives", ui.theme().text_dim);
    return;
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float small = ui.fonts().small->FontSize;
  const ImVec2 size{ImGui::GetContentRegionAvail().x, ui.px(110)};
  const float left = ui.px(44);
  const Rect area{at.x + left, at.y + ui.px(6), at.x + size.x - ui.px(6), at.y + size.y - small - ui.px(4)};
  const std::size_t last = arrived_[0].size() - 1;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool inside = Rect{at.x, at.y, at.x + size.x, at.y + size.y}.contains(mouse.x, mouse.y);
  const float along = std::clamp((mouse.x - area.x0) / std::max(area.width(), 1.0F), 0.0F, 1.0F);
  const std::size_t step = inside ? static_cast<std::size_t>(std::lround(along * static_cast<float>(last))) : last;
  const std::string words = words_at(step);
  chart_area(ui, "Curve", size, words, {.help = "Share of the chosen starts that has arrived within so many steps"});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 dim = to_u32(ui.theme().text_dim);
  list.AddRectFilled({area.x0, area.y0}, {area.x1, area.y1}, to_u32(ui.theme().header));
  const float half = std::round(area.centre_y());
  list.AddRectFilled({area.x0, half}, {area.x1, half + 1.0F}, to_u32(ui.theme().line));
  draw_curves(ui, area);
  if (inside) {
    const float x = area.x0 + static_cast<float>(step) / static_cast<float>(last) * area.width();
    list.AddLine({x, area.y0}, {x, area.y1}, dim);
  }
  {
    const FontScope font(ui.fonts().small);
    list.AddText({at.x, area.y0 - ui.px(2)}, dim, "100 %");
    list.AddText({at.x, half - 0.5F * small}, dim, "50 %");
    list.AddText({at.x, area.y1 - small}, dim, "0 %");
    list.AddText({area.x0, area.y1 + ui.px(2)}, dim, "step 0");
    const std::string end = fmt::format("step {}", last);
    list.AddText({area.x1 - ImGui::CalcTextSize(end.c_str()).x, area.y1 + ui.px(2)}, dim, end.c_str());
  }
  wrapped_text(ui, words, ui.theme().text_dim);
  if (!insight->second) return;
  small_text(ui, fmt::format("A, solid: {}", insight->entry->name), ui.theme().accent);
  small_text(ui, fmt::format("B, dashed: {}", insight->second->entry->name), ui.theme().warning);
}

}  // namespace trocar::ui
