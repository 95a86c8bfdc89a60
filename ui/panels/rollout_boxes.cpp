#include "ui/panels/rollout_boxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ui/format.h"
#include "ui/panels/rollout_parts.h"

namespace trocar::ui {
namespace {

using learning::RolloutEnd;

constexpr std::size_t kMostDots = 120;
constexpr std::array<RolloutEnd, 4> kEnds{RolloutEnd::kArrives, RolloutEnd::kLoops, RolloutEnd::kDeadEnd,
                                          RolloutEnd::kOutsideSafeSet};
constexpr std::array<std::string_view, 4> kEndNames{"arrives", "loops", "dead end", "outside"};

std::string spread_words(const learning::Spread& spread) {
  return fmt::format("{}: {} to {}, middle {}, half in {} to {}", count(spread.count), millimetres(spread.least),
                     millimetres(spread.most), millimetres(spread.median), millimetres(spread.low),
                     millimetres(spread.high));
}

}  // namespace

void RolloutBoxes::add_rows(const std::vector<learning::Rollout>& rollouts, const std::string& before) {
  for (std::size_t i = 0; i < kEnds.size(); ++i) {
    Row row;
    row.end = kEnds[i];
    row.spread = learning::worst_deviations_m(rollouts, row.end);
    if (row.spread.count == 0) continue;
    row.name = before + std::string(kEndNames[i]);
    if (before.empty()) row.name[0] = static_cast<char>(row.name[0] - 'a' + 'A');
    const std::size_t all = static_cast<std::size_t>(row.spread.count);
    const std::size_t dots = std::min(all, kMostDots);
    std::size_t seen = 0;
    for (const learning::Rollout& rollout : rollouts) {
      if (rollout.end != row.end) continue;
      // Every all/dots-th of them.
      if (seen * dots / all != (seen + 1) * dots / all) row.points.push_back(rollout.max_deviation_m);
      ++seen;
    }
    rows_.push_back(std::move(row));
  }
}

void RolloutBoxes::update(const workbench::ModelInsight& insight) {
  const Rollouts second = insight.second ? insight.second->listed : nullptr;
  if (of_ == insight.listed && second_of_ == second) return;
  of_ = insight.listed;
  second_of_ = second;
  rows_.clear();
  add_rows(*of_, second ? "A " : "");
  if (second) add_rows(*second, "B ");
}

void RolloutBoxes::draw_row(Ui& ui, const Row& row, double most_m) const {
  const auto [words, colour] = end_words(ui.theme(), row.end);
  const std::string value = spread_words(row.spread);
  const float height = std::max(ui.px(24), ImGui::GetTextLineHeight());
  chart_area(ui, row.name, {ImGui::GetContentRegionAvail().x, height}, value, {.help = value});
  const Rect rect = item_rect();
  const std::string middle = fmt::format("{:.1f}", 1e3 * row.spread.median);
  const float name_width = ui.px(116);
  const float numbers = ImGui::CalcTextSize("00.0").x;
  const Rect area{rect.x0 + name_width, rect.y0 + ui.px(3), rect.x1 - numbers - ui.px(10), rect.y1 - ui.px(3)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float text_y = rect.centre_y() - 0.5F * ImGui::GetFontSize();
  const std::string sign = words.substr(0, words.find(' '));
  list.AddText({rect.x0, text_y}, to_u32(colour), sign.c_str());
  list.AddText({rect.x0 + ui.px(24), text_y}, to_u32(ui.theme().text), row.name.c_str());
  list.AddText({rect.x1 - ImGui::CalcTextSize(middle.c_str()).x, text_y}, to_u32(ui.theme().text), middle.c_str());
  if (area.width() < ui.px(24)) return;
  list.AddRectFilled({area.x0, area.y0}, {area.x1, area.y1}, to_u32(ui.theme().header));
  const auto x_of = [&](double value_m) { return area.x0 + static_cast<float>(value_m / most_m) * area.width(); };
  const float y = area.centre_y();
  for (std::size_t i = 0; i < row.points.size(); ++i) {
    // Spread over the height by their place, so that equal ones are seen.
    const float lower = (static_cast<float>(i * 7 % 11) / 10.0F - 0.5F) * 0.8F * area.height();
    list.AddCircleFilled({x_of(row.points[i]), y + lower}, ui.px(1.5F), to_u32(colour, 0.55F), 8);
  }
  const ImU32 edge = to_u32(ui.theme().text);
  const float width = std::max(ui.px(1.5F), 1.0F);
  const float half = 0.32F * area.height();
  list.AddLine({x_of(row.spread.least), y}, {x_of(row.spread.low), y}, edge, width);
  list.AddLine({x_of(row.spread.high), y}, {x_of(row.spread.most), y}, edge, width);
  list.AddRect({x_of(row.spread.low), y - half}, {x_of(row.spread.high), y + half}, edge, 0.0F, 0, width);
  list.AddLine({x_of(row.spread.median), y - half}, {x_of(row.spread.median), y + half}, edge, 2.0F * width);
}

void RolloutBoxes::draw(Ui& ui, const workbench::ModelInsight& insight) {
  const Scope scope(ui, "Worst deviation");
  update(insight);
  heading(ui, "Worst deviation from the expert");
  if (rows_.empty()) {
    wrapped_text(ui, "There are no rollouts", ui.theme().text_dim);
    return;
  }
  double most_m = 1e-4;
  for (const Row& row : rows_) most_m = std::max(most_m, row.spread.most);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, ui.px(2)});
  for (const Row& row : rows_) draw_row(ui, row, most_m);
  ImGui::PopStyleVar();
  small_text(ui, fmt::format("0 to {:.1f} mm; box: the middle half, bar and number: the middle one", 1e3 * most_m),
             ui.theme().text_dim);
}

}  // namespace trocar::ui
