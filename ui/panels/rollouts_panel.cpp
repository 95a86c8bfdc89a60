#include "ui/panels/rollouts_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"
#include "ui/panels/rollout_band.h"
#include "ui/panels/rollout_pair.h"
#include "ui/panels/rollout_parts.h"
#include "ui/panels/rollout_selected.h"

namespace trocar::ui {
namespace {

using learning::RolloutSummary;
using workbench::Command;

constexpr int kPathsPage = 2;

void around_table(Ui& ui, const std::array<RolloutSummary, 5>& around, int chosen, Requests& requests,
                  const workbench::RolloutSettings& settings) {
  const Scope scope(ui, "Distances");
  const bool narrow = ImGui::GetContentRegionAvail().x < ui.px(330);
  const ImGuiTableFlags flags =
      ImGuiTableFlags_BordersInnerH |
      (narrow ? ImGuiTableFlags_ScrollX | ImGuiTableFlags_SizingFixedFit : ImGuiTableFlags_SizingStretchSame);
  const float row = std::max(ui.px(20), ImGui::GetTextLineHeight()) + ImGui::GetStyle().ItemSpacing.y +
                    2.0F * ImGui::GetStyle().CellPadding.y;
  const float height = narrow ? 6.0F * row + ImGui::GetStyle().ScrollbarSize + ui.px(4) : 0.0F;
  if (!ImGui::BeginTable("around", 5, flags, {0.0F, height})) return;
  for (const char* name : {"Start", "Count", "Arrives", "Loops", "Above"}) ImGui::TableSetupColumn(name);
  ImGui::TableHeadersRow();
  for (int k = 1; k <= 5; ++k) {
    const RolloutSummary& summary = around[static_cast<std::size_t>(k - 1)];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string label = fmt::format("±{}", k);
    if (selectable_row(ui, label, k == chosen, percent(summary.arrived, summary.count), {.height = ui.px(20)}) &&
        k != chosen) {
      workbench::RolloutSettings next = settings;
      next.starts = fmt::format("around:{}", k);
      requests.emplace_back(Command{workbench::SetRollouts{next}});
    }
    ImGui::SameLine(0.0F, 0.0F);
    ImGui::TextUnformatted(label.c_str());
    for (const std::string& words :
         {count(summary.count), percent(summary.arrived, summary.count), percent(summary.looped, summary.count),
          percent(summary.from_above, summary.arrived)}) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(words.c_str());
    }
  }
  ImGui::EndTable();
}

/// K of "around:K"; 0 for other starts.
int around_of(const workbench::RolloutSettings& settings) {
  const bool near = settings.starts.starts_with("around:") && settings.starts.size() == 8;
  return near ? std::clamp(settings.starts[7] - '0', 1, 5) : 0;
}

}  // namespace

void RolloutsPanel::draw_ghosts(Ui& ui, const WorkbenchState& state, Requests& requests) {
  workbench::RolloutSettings settings = state.rollouts;
  bool changed = false;
  form_label(ui, "Ghosts");
  changed |= checkbox(ui, "Show", settings.ghosts, {.help = "Draw the paths in the 3-D view"});
  flow(ui.px(44) + ImGui::CalcTextSize("300 paths").x, ui.px(14));
  changed |= slider_int(ui, "Ghost count", settings.ghost_count, 1, 300, "%d paths",
                        {.help = "How many of the rollouts are drawn"});
  if (changed && settings != state.rollouts) requests.emplace_back(Command{workbench::SetRollouts{settings}});
}

void RolloutsPanel::draw_outcomes(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const workbench::ModelInsight& insight = *state.insight;
  draw_ghosts(ui, state, requests);
  const int k = around_of(state.rollouts);
  summary_block(ui, k > 0 ? fmt::format("Within ±{} cells", k) : std::string("Chosen starts"), insight.chosen);
  ImGui::Dummy({0.0F, ui.px(3)});
  // Above the map, over which the wheel goes through the slices.
  workbench::PlotSettings plot;
  plot.kind = workbench::PlotKind::kMap;
  plot.slice = map_.slice();
  export_plot_button(ui, "Export map…", plot, requests);
  map_.draw(ui, state, requests);
  ImGui::Dummy({0.0F, ui.px(3)});
  around_table(ui, insight.around, k, requests, state.rollouts);
  ImGui::Dummy({0.0F, ui.px(3)});
  summary_block(ui, "All cells", insight.all);
  plot = {};
  plot.kind = workbench::PlotKind::kReport;
  export_plot_button(ui, "Report…", plot, requests);
}

void RolloutsPanel::draw_spread(Ui& ui, const WorkbenchState& state, Requests& requests) {
  workbench::PlotSettings plot;
  arrivals_.draw(ui, state.insight);
  export_plot_button(ui, "Export arrivals…", plot, requests);
  ImGui::Dummy({0.0F, ui.px(6)});
  boxes_.draw(ui, *state.insight);
  plot.kind = workbench::PlotKind::kBoxes;
  plot.measures = {boxes_.measure()};
  export_plot_button(ui, "Export boxes…", plot, requests);
  ImGui::Dummy({0.0F, ui.px(6)});
  draw_deviation_band(ui, *state.insight);
  plot = {};
  plot.kind = workbench::PlotKind::kBand;
  export_plot_button(ui, "Export deviations…", plot, requests);
}

void RolloutsPanel::show_brushed(const WorkbenchState& state, Requests& requests) const {
  std::vector<learning::RolloutRange> ranges = brush_.ranges();
  if (ranges == state.rollouts.brushed) return;
  // What else was asked for in this frame, as by a play that goes on, stays.
  for (Request& request : requests) {
    auto* asked = std::get_if<Command>(&request);
    auto* rollouts = asked != nullptr ? std::get_if<workbench::SetRollouts>(asked) : nullptr;
    if (rollouts != nullptr) rollouts->settings.brushed = ranges;
  }
  workbench::RolloutSettings settings = state.rollouts;
  settings.brushed = std::move(ranges);
  requests.insert(requests.begin(), Command{workbench::SetRollouts{std::move(settings)}});
}

bool RolloutsPanel::claims(const Ui& ui, const Chord& chord, const WorkbenchState& state) const {
  const bool plays = page_ == kPathsPage && state.insight && state.insight->entry != nullptr;
  return plays && RolloutPlay::claims(ui, chord);
}

Requests RolloutsPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  if (!state.insight || state.insight->entry == nullptr || state.insight->listed == nullptr) {
    const std::string reason = command("model.train").reason_now(state);
    const std::array<EmptyStateAction, 1> actions{
        {{"Train a model…", icon::kTrain, reason, "Learn from demonstrations"}}};
    const bool waiting = selected_model(state) != nullptr;
    if (waiting) {
      ui.animate();
      empty_state(ui, icon::kClock, "Rolling the agent out", "This takes a moment", {});
      return requests;
    }
    if (empty_state(ui, icon::kRoad, "No model is selected",
                    "What the agent does from starts around the expert's is shown here", actions) == 0) {
      requests.emplace_back(ShowPanel{PanelId::kTrain});
    }
    return requests;
  }
  if (state.insight->stale) {
    badge(ui, icon::kWarning, "stale: a demonstration was edited since training", ui.theme().warning);
  }
  static const std::vector<std::string> kPages{"Outcomes", "Table", "Paths", "Spread", "Chance", "Two models"};
  starts_.draw(ui, state, requests);
  draw_selected_rollout(ui, state, requests);
  segmented(ui, "Page", page_, kPages, {.help = "What of the rollouts is shown"});
  ImGui::Dummy({0.0F, ui.px(3)});
  if (page_ == 0) draw_outcomes(ui, state, requests);
  brush_.update(*state.insight);
  brush_.take(state.rollouts.brushed);
  if (page_ == 1) {
    axes_.draw(ui, state, brush_, requests);
    workbench::PlotSettings plot;
    plot.kind = workbench::PlotKind::kAxes;
    plot.kept = brush_.ranges();
    export_plot_button(ui, "Export axes…", plot, requests);
    table_.draw(ui, state, brush_, requests);
  }
  if (page_ == kPathsPage) {
    draw_ghosts(ui, state, requests);
    play_.draw(ui, state, requests);
    multiples_.draw(ui, state, brush_, requests);
    workbench::PlotSettings plot = multiples_.plot();
    plot.kept = brush_.ranges();
    export_plot_button(ui, "Export pictures…", plot, requests);
  }
  if (page_ == 3) draw_spread(ui, state, requests);
  if (page_ == 4) runs_.draw(ui, state, requests);
  if (page_ == 5) draw_second_model(ui, state, requests);
  show_brushed(state, requests);
  return requests;
}

}  // namespace trocar::ui
