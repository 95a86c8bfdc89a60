#include "ui/panels/rollout_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/figure/outcome_colours.h"
#include "engine/workbench/rolling.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/rollout_axes.h"
#include "ui/panels/rollout_parts.h"

namespace trocar::ui {
namespace {

using learning::Rollout;
using learning::RolloutMeasure;

std::string listed_words(const workbench::ModelInsight& insight) {
  const std::size_t listed = insight.listed->size();
  const std::string all = count(static_cast<std::int64_t>(insight.starts.size()));
  if (listed == insight.starts.size()) return all + " rollouts";
  return fmt::format("{} of {} rollouts, evenly", count(static_cast<std::int64_t>(listed)), all);
}

/// What stands in the columns after start and end.
std::array<std::string, learning::kRolloutMeasures - 2> cells_of(const Rollout& rollout,
                                                                 const workbench::ModelInsight& insight) {
  const double clearance_m = learning::least_clearance_m(rollout, clearance_of(insight));
  return {count(static_cast<std::int64_t>(rollout.cells.size()) - 1),
          millimetres(rollout.length_m),
          number(rollout.straightness),
          millimetres(rollout.max_deviation_m),
          millimetres(rollout.mean_deviation_m),
          millimetres(rollout.frechet_m),
          millimetres(rollout.hausdorff_m),
          millimetres(rollout.warped_m),
          learning::last_moves(insight.entry->model->grid, rollout.cells),
          rollout.from_above ? "yes" : "no",
          number(rollout.reward_sum),
          rollout.divergence_step < 0 ? "never" : fmt::format("step {}", rollout.divergence_step),
          count(rollout.outside_steps),
          std::isnan(clearance_m) ? "unknown" : millimetres(clearance_m)};
}

void table_row(Ui& ui, const WorkbenchState& state, const Rollout& rollout, Requests& requests) {
  const workbench::ModelInsight& insight = *state.insight;
  const std::string label = start_words(insight.entry->model->grid, rollout.start);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(rollout.start.value);
  const bool selected = state.rollouts.selected == rollout.start;
  if (selectable_row(ui, label, selected, learning::to_string(rollout.end), {.height = ui.px(20)})) {
    select_start(state, rollout.start, requests);
  }
  ImGui::SameLine(0.0F, 0.0F);
  ImGui::TextUnformatted(label.c_str());
  ImGui::PopID();
  ImGui::TableNextColumn();
  end_text(ui, rollout.end);
  for (const std::string& text_of_cell : cells_of(rollout, insight)) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text_of_cell.c_str());
  }
}

/// From the side: y to the right, z up; W, metres.
ImVec2 seen_from_side(const Rect& rect, const spatial::Grid& grid, const Eigen::Vector3d& p_W) {
  const Eigen::Vector3d cells = (p_W - grid.p_WGo) / grid.cell_m;
  const float step = std::min(rect.width(), rect.height()) / static_cast<float>(grid.n);
  return {rect.x0 + static_cast<float>(cells.y()) * step, rect.y1 - static_cast<float>(cells.z()) * step};
}

ImVec2 seen_from_side(const Rect& rect, const spatial::Grid& grid, spatial::CellIndex cell) {
  return seen_from_side(rect, grid, grid.centre(cell));
}

void draw_points(Ui& ui, const std::vector<ImVec2>& points, ImU32 colour, float width) {
  if (points.size() < 2) return;
  ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, ui.px(width));
}

void draw_way(Ui& ui, const Rect& rect, const spatial::Grid& grid, const learning::CellSequence& cells, Rgba colour,
              float alpha, float width) {
  std::vector<ImVec2> points;
  for (const spatial::CellIndex cell : cells) points.push_back(seen_from_side(rect, grid, cell));
  draw_points(ui, points, to_u32(colour, alpha), width);
}

/// As far as it has come, with its head; what is still to come is faint.
void draw_rollout(Ui& ui, const Rect& rect, const spatial::Grid& grid, const Rollout& rollout,
                  const workbench::RolloutSettings& settings, Rgba colour) {
  if (!settings.reach) return draw_way(ui, rect, grid, rollout.cells, colour, 1.0F, 2.0F);
  draw_way(ui, rect, grid, rollout.cells, colour, 0.3F, 1.0F);
  std::vector<ImVec2> points;
  for (const Eigen::Vector3d& p_W : learning::way_until(rollout, grid, workbench::steps_taken(rollout, settings))) {
    points.push_back(seen_from_side(rect, grid, p_W));
  }
  draw_points(ui, points, to_u32(colour), 2.0F);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled(points.back(), ui.px(4.5F), to_u32(ui.theme().text), 16);
  list.AddCircleFilled(points.back(), ui.px(3), to_u32(colour), 16);
}

/// "loops, 12.25 mm", and where it is while all are played.
std::string mini_words(const Rollout& rollout, std::string_view measure, const workbench::RolloutSettings& settings) {
  std::string words = fmt::format("{}, {}", learning::to_string(rollout.end), measure);
  if (!settings.reach) return words;
  const auto steps = static_cast<int>(std::floor(workbench::steps_taken(rollout, settings) + 1e-6));
  return words + fmt::format(", step {} of {}", steps, rollout.cells.size() - 1);
}

bool mini_view(Ui& ui, const WorkbenchState& state, const Rollout& rollout, float side, std::string_view measure) {
  const learning::Model& model = *state.insight->entry->model;
  const Scope scope(ui, start_words(model.grid, rollout.start));
  ImGui::BeginGroup();
  const Rgba colour = figure::outcome_colour(rollout.end);
  chart_area(ui, "Rollout", {side, side}, mini_words(rollout, measure, state.rollouts),
             {.help = "From the side: y to the right, z up; the expert's way is grey"});
  const bool clicked = ImGui::IsItemClicked();
  const Rect rect = item_rect();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(ui.theme().header), ui.px(3));
  const bool selected = state.rollouts.selected == rollout.start;
  const Rgba edge = selected ? ui.theme().accent : ui.theme().line;
  list.AddRect({rect.x0, rect.y0}, {rect.x1, rect.y1}, to_u32(edge), ui.px(3), 0, ui.px(selected ? 2.0F : 1.0F));
  const float inset = ui.px(4);
  const Rect inside{rect.x0 + inset, rect.y0 + inset, rect.x1 - inset, rect.y1 - inset};
  draw_way(ui, inside, model.grid, model.experts.front(), ui.theme().text_disabled, 1.0F, 1.0F);
  draw_rollout(ui, inside, model.grid, rollout, state.rollouts, colour);
  list.AddCircleFilled(seen_from_side(inside, model.grid, model.goal), ui.px(3), IM_COL32(255, 200, 60, 255), 12);
  const ImVec2 start = seen_from_side(inside, model.grid, rollout.start);
  // A ring, where the head is to be seen beside it.
  if (state.rollouts.reach) list.AddCircle(start, ui.px(3), to_u32(ui.theme().text), 12, ui.px(1.5F));
  if (!state.rollouts.reach) list.AddCircleFilled(start, ui.px(3), to_u32(ui.theme().text), 12);
  {
    const FontScope font(ui.fonts().small);
    {
      const ColourScope tint(ImGuiCol_Text, colour);
      ImGui::TextUnformatted(end_sign(rollout.end));
    }
    ImGui::SameLine(0.0F, ui.px(4));
    const float used = ImGui::CalcTextSize(end_sign(rollout.end)).x + ui.px(4);
    ImGui::TextUnformatted(fitted(std::string(measure), side - used).c_str());
  }
  ImGui::EndGroup();
  return clicked;
}

}  // namespace

const std::vector<std::size_t>& RolloutOrder::of(const workbench::ModelInsight& insight, const RolloutBrush& brush,
                                                 RolloutMeasure by, bool descending) {
  if (of_ == insight.listed && by_ == by && descending_ == descending && version_ == brush.version()) return order_;
  of_ = insight.listed;
  by_ = by;
  descending_ = descending;
  version_ = brush.version();
  order_ = learning::sorted_by(*of_, by, descending, insight.entry->model->grid, clearance_of(insight));
  std::erase_if(order_, [&brush](std::size_t place) { return !brush.keeps(place); });
  return order_;
}

void RolloutTable::draw(Ui& ui, const WorkbenchState& state, const RolloutBrush& brush, Requests& requests) {
  const Scope scope(ui, "Table");
  const workbench::ModelInsight& insight = *state.insight;
  small_text(ui, listed_words(insight) + "; a click on a row selects it", ui.theme().text_dim);
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_ScrollY | ImGuiTableFlags_ScrollX |
                                     ImGuiTableFlags_Sortable | ImGuiTableFlags_Resizable |
                                     ImGuiTableFlags_SizingFixedFit;
  const float height = std::max(ImGui::GetContentRegionAvail().y, ui.px(220));
  if (!ImGui::BeginTable("rollouts", learning::kRolloutMeasures, kFlags, {0.0F, height})) return;
  ImGui::TableSetupScrollFreeze(1, 1);
  for (const std::string& name : measure_names()) {
    const bool start = name == measure_names().front();
    ImGui::TableSetupColumn(name.c_str(), ImGuiTableColumnFlags_WidthFixed,
                            start ? ImGui::CalcTextSize("00, 00, 00 ").x : 0.0F);
  }
  ImGui::TableHeadersRow();
  if (const ImGuiTableSortSpecs* sort = ImGui::TableGetSortSpecs(); sort != nullptr && sort->SpecsCount > 0) {
    by_ = static_cast<RolloutMeasure>(sort->Specs[0].ColumnIndex);
    descending_ = sort->Specs[0].SortDirection == ImGuiSortDirection_Descending;
  }
  const std::vector<std::size_t>& order = order_.of(insight, brush, by_, descending_);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(order.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      ImGui::PushID(i);
      table_row(ui, state, (*insight.listed)[order[static_cast<std::size_t>(i)]], requests);
      ImGui::PopID();
    }
  }
  ImGui::EndTable();
}

void RolloutMultiples::draw(Ui& ui, const WorkbenchState& state, RolloutBrush& brush, Requests& requests) {
  const Scope scope(ui, "Small multiples");
  constexpr std::size_t kMost = 24;
  const workbench::ModelInsight& insight = *state.insight;
  form_label(ui, "Sorted by");
  combo(ui, "Sorted by", by_, measure_names(), {.help = "The first 24 in this order are shown"});
  form_label(ui, "Order");
  checkbox(ui, "Largest first", descending_, {.help = "Else the smallest"});
  form_label(ui, "Columns");
  slider_int(ui, "Columns", columns_, 2, 8, "%d side by side", {.help = "How many pictures stand side by side"});
  const std::vector<std::size_t>& order = order_.of(insight, brush, static_cast<RolloutMeasure>(by_), descending_);
  draw_brushed(ui, brush);
  const std::size_t shown = std::min(kMost, order.size());
  small_text(ui, fmt::format("{} of {}", shown, listed_words(insight)), ui.theme().text_dim);
  const float gap = ui.px(6);
  const auto across = static_cast<float>(columns_);
  const float side = std::max((ImGui::GetContentRegionAvail().x - gap * (across - 1.0F)) / across, ui.px(40));
  for (std::size_t i = 0; i < shown; ++i) {
    if (i % static_cast<std::size_t>(columns_) != 0) ImGui::SameLine(0.0F, gap);
    const Rollout& rollout = (*insight.listed)[order[i]];
    const std::string value = by_ == 0   ? start_words(insight.entry->model->grid, rollout.start)
                              : by_ == 1 ? std::string(learning::to_string(rollout.end))
                                         : cells_of(rollout, insight)[static_cast<std::size_t>(by_ - 2)];
    ImGui::PushID(static_cast<int>(i));
    if (mini_view(ui, state, rollout, side, value)) select_start(state, rollout.start, requests);
    ImGui::PopID();
  }
}

workbench::PlotSettings RolloutMultiples::plot() const {
  workbench::PlotSettings settings;
  settings.kind = workbench::PlotKind::kMultiples;
  settings.by = static_cast<RolloutMeasure>(by_);
  settings.descending = descending_;
  settings.columns = columns_;
  return settings;
}

}  // namespace trocar::ui
