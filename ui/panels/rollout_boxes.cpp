#include "ui/panels/rollout_boxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/figure/outcome_colours.h"
#include "ui/format.h"
#include "ui/panels/rollout_brush.h"
#include "ui/panels/rollout_parts.h"

namespace trocar::ui {
namespace {

using learning::RolloutEnd;
using learning::RolloutMeasure;

/// What boxes are drawn of, in the order of the table.
const std::vector<RolloutMeasure>& boxed() {
  static const std::vector<RolloutMeasure> kBoxed = learning::spread_measures();
  return kBoxed;
}

std::string spread_words(RolloutMeasure measure, const learning::Spread& spread) {
  const auto words = [measure](double value) { return measure_words(measure, value); };
  return fmt::format("{}: {} to {}, middle {}, half in {} to {}", count(spread.count), words(spread.least),
                     words(spread.most), words(spread.median), words(spread.low), words(spread.high));
}

}  // namespace

std::vector<RolloutBoxes::Row> RolloutBoxes::rows_of(const workbench::ModelInsight& insight) const {
  std::vector<Row> rows;
  const auto add = [&](const learning::RolloutSpread& spread, const std::string& before) {
    for (std::size_t i = 0; i < learning::kRolloutEnds; ++i) {
      const auto end = static_cast<RolloutEnd>(i);
      const learning::MeasureSpread& values = spread.of(measure_, end);
      if (values.spread.count == 0) continue;
      std::string name = before + std::string(figure::outcome_word(end));
      if (before.empty()) name[0] = static_cast<char>(name[0] - 'a' + 'A');
      rows.push_back({std::move(name), end, &values});
    }
  };
  add(*insight.spread, insight.second ? "A " : "");
  if (insight.second) add(*insight.second->spread, "B ");
  return rows;
}

void RolloutBoxes::draw_row(Ui& ui, const Row& row, double low, double high) const {
  const Rgba colour = figure::outcome_colour(row.end);
  const std::string value = spread_words(measure_, row.values->spread);
  const float height = std::max(ui.px(24), ImGui::GetTextLineHeight());
  chart_area(ui, row.name, {ImGui::GetContentRegionAvail().x, height}, value, {.help = value});
  const Rect rect = item_rect();
  const std::string middle = measure_words(measure_, row.values->spread.median);
  const float name_width = ui.px(116);
  const float numbers = ImGui::CalcTextSize("−0.000 mm").x;
  const Rect area{rect.x0 + name_width, rect.y0 + ui.px(3), rect.x1 - numbers - ui.px(10), rect.y1 - ui.px(3)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float text_y = rect.centre_y() - 0.5F * ImGui::GetFontSize();
  list.AddText({rect.x0, text_y}, to_u32(colour), end_sign(row.end));
  list.AddText({rect.x0 + ui.px(24), text_y}, to_u32(ui.theme().text), row.name.c_str());
  list.AddText({rect.x1 - ImGui::CalcTextSize(middle.c_str()).x, text_y}, to_u32(ui.theme().text), middle.c_str());
  if (area.width() < ui.px(24)) return;
  list.AddRectFilled({area.x0, area.y0}, {area.x1, area.y1}, to_u32(ui.theme().header));
  const auto x_of = [&](double at) {
    return area.x0 + static_cast<float>((at - low) / std::max(high - low, 1e-12)) * area.width();
  };
  const float y = area.centre_y();
  for (std::size_t i = 0; i < row.values->some.size(); ++i) {
    // Spread over the height by their place, so that equal ones are seen.
    const float lower = (static_cast<float>(i * 7 % 11) / 10.0F - 0.5F) * 0.8F * area.height();
    list.AddCircleFilled({x_of(row.values->some[i]), y + lower}, ui.px(1.5F), to_u32(colour, 0.55F), 8);
  }
  const ImU32 edge = to_u32(ui.theme().text);
  const float width = std::max(ui.px(1.5F), 1.0F);
  const float half = 0.32F * area.height();
  list.AddLine({x_of(row.values->spread.least), y}, {x_of(row.values->spread.low), y}, edge, width);
  list.AddLine({x_of(row.values->spread.high), y}, {x_of(row.values->spread.most), y}, edge, width);
  list.AddRect({x_of(row.values->spread.low), y - half}, {x_of(row.values->spread.high), y + half}, edge, 0.0F, 0,
               width);
  list.AddLine({x_of(row.values->spread.median), y - half}, {x_of(row.values->spread.median), y + half}, edge,
               2.0F * width);
}

void RolloutBoxes::draw(Ui& ui, const workbench::ModelInsight& insight) {
  const Scope scope(ui, "Boxes");
  static const std::vector<std::string> kTitles = [] {
    std::vector<std::string> titles;
    for (const RolloutMeasure measure : boxed()) titles.emplace_back(learning::words_of(measure).title);
    return titles;
  }();
  heading(ui, "Where the measures lie");
  auto chosen = static_cast<int>(std::find(boxed().begin(), boxed().end(), measure_) - boxed().begin());
  form_label(ui, "Measure");
  if (combo(ui, "Measure", chosen, kTitles, {.help = "Of all rollouts, by how they end"})) {
    measure_ = boxed()[static_cast<std::size_t>(chosen)];
  }
  const std::vector<Row> rows = rows_of(insight);
  if (rows.empty()) {
    wrapped_text(ui, "No rollout has such a value", ui.theme().text_dim);
    return;
  }
  // Zero is always there, so that lengths are compared by eye.
  double low = 0.0;
  double high = 0.0;
  for (const Row& row : rows) {
    low = std::min(low, row.values->spread.least);
    high = std::max(high, row.values->spread.most);
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, ui.px(2)});
  for (const Row& row : rows) draw_row(ui, row, low, high);
  ImGui::PopStyleVar();
  const std::string words = fmt::format("{} to {}; box: the middle half, bar and number: the middle one",
                                        measure_words(measure_, low), measure_words(measure_, high));
  wrapped_text(ui, words, ui.theme().text_dim);
}

}  // namespace trocar::ui
