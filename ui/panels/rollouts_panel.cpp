#include "ui/panels/rollouts_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using learning::Rollout;
using learning::RolloutEnd;
using learning::RolloutSummary;
using workbench::Command;

// One outcome: its sign, its name, its share as a bar and as numbers.
void outcome_row(Ui& ui, const char* sign, std::string_view name, int part, int whole, Rgba colour) {
  const float left = ImGui::GetCursorPosX();
  const float width = ImGui::GetContentRegionAvail().x;
  const std::string words = percent(part, whole) + "  (" + count(part) + ")";
  {
    const ColourScope tint(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(sign);
  }
  ImGui::SameLine(left + ui.px(24));
  ImGui::TextUnformatted(name.data(), name.data() + name.size());
  const float numbers = ImGui::CalcTextSize(words.c_str()).x;
  const float bar = left + ui.px(116);
  const float bar_width = width - ui.px(116) - std::max(numbers, ui.px(104)) - ui.px(10);
  if (bar_width > ui.px(30)) {
    ImGui::SameLine(bar);
    const float lower = 0.5F * (ImGui::GetTextLineHeight() - ui.px(8));
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + lower);
    share_bar(ui, whole > 0 ? static_cast<double>(part) / whole : 0.0, colour, {bar_width, ui.px(8)});
    ImGui::SameLine(left + width - numbers);
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - lower);
  } else {
    const float used = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + ui.px(8);
    if (used + numbers <= left + width) ImGui::SameLine(left + width - numbers);
  }
  ImGui::TextUnformatted(words.c_str());
  note_item(ui, "text", name, words, {});
}

void summary_block(Ui& ui, std::string_view name, const RolloutSummary& summary) {
  const Scope scope(ui, name);
  heading(ui, name);
  ImGui::SameLine();
  dim_text(ui, count(summary.count) + " starts");
  outcome_row(ui, icon::kVerify, "Arrives", summary.arrived, summary.count, ui.theme().good);
  outcome_row(ui, icon::kRefresh, "Loops", summary.looped, summary.count, ui.theme().warning);
  outcome_row(ui, icon::kCross, "Dead end", summary.dead_end, summary.count, ui.theme().danger);
  outcome_row(ui, icon::kDownload, "From above", summary.from_above, summary.arrived, ui.theme().accent);
}

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

std::pair<std::string, Rgba> end_words(const Theme& theme, RolloutEnd end) {
  switch (end) {
    case RolloutEnd::kArrives:
      return {std::string(icon::kVerify) + "  arrives", theme.good};
    case RolloutEnd::kLoops:
      return {std::string(icon::kRefresh) + "  loops", theme.warning};
    case RolloutEnd::kDeadEnd:
      return {std::string(icon::kCross) + "  dead end", theme.danger};
    case RolloutEnd::kOutsideSafeSet:
      return {std::string(icon::kCross) + "  outside", theme.danger};
  }
  return {"", theme.text};
}

double measure(const Rollout& rollout, int column) {
  switch (column) {
    case 1:
      return static_cast<double>(rollout.end);
    case 2:
      return static_cast<double>(rollout.cells.size());
    case 3:
      return rollout.length_m;
    case 4:
      return rollout.straightness;
    case 5:
      return rollout.max_deviation_m;
    case 6:
      return rollout.frechet_m;
    default:
      return rollout.start.value;
  }
}

void rollout_row(Ui& ui, const Rollout& rollout, const spatial::Grid& grid) {
  const spatial::CellCoordinates start = grid.coordinates(rollout.start);
  const std::string label = fmt::format("{}, {}, {}", start.x, start.y, start.z);
  const auto [words, colour] = end_words(ui.theme(), rollout.end);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(label.c_str());
  note_item(ui, "text", label, std::string(learning::to_string(rollout.end)), {});
  ImGui::TableNextColumn();
  {
    const ColourScope tint(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(words.c_str());
  }
  const std::array<std::string, 5> cells{count(static_cast<std::int64_t>(rollout.cells.size()) - 1),
                                         millimetres(rollout.length_m), number(rollout.straightness),
                                         millimetres(rollout.max_deviation_m), millimetres(rollout.frechet_m)};
  for (const std::string& text_of_cell : cells) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text_of_cell.c_str());
  }
}

void ghost_table(Ui& ui, const std::vector<Rollout>& ghosts, const spatial::Grid& grid, int& column, bool& descending) {
  const Scope scope(ui, "Some rollouts");
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_ScrollY | ImGuiTableFlags_ScrollX |
                                     ImGuiTableFlags_Sortable | ImGuiTableFlags_Resizable |
                                     ImGuiTableFlags_SizingFixedFit;
  if (!ImGui::BeginTable("ghosts", 7, kFlags, {0.0F, std::max(ImGui::GetContentRegionAvail().y, ui.px(140))})) return;
  ImGui::TableSetupScrollFreeze(1, 1);
  for (const char* name : {"Start", "End", "Steps", "Length", "Straight", "Deviation", "Fréchet"}) {
    ImGui::TableSetupColumn(name);
  }
  ImGui::TableHeadersRow();
  if (const ImGuiTableSortSpecs* sort = ImGui::TableGetSortSpecs(); sort != nullptr && sort->SpecsCount > 0) {
    column = sort->Specs[0].ColumnIndex;
    descending = sort->Specs[0].SortDirection == ImGuiSortDirection_Descending;
  }
  std::vector<const Rollout*> order;
  for (const Rollout& rollout : ghosts) order.push_back(&rollout);
  std::stable_sort(order.begin(), order.end(), [column, descending](const Rollout* a, const Rollout* b) {
    return descending ? measure(*b, column) < measure(*a, column) : measure(*a, column) < measure(*b, column);
  });
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(order.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      rollout_row(ui, *order[static_cast<std::size_t>(i)], grid);
    }
  }
  ImGui::EndTable();
}

/// K of "around:K", 3 for other starts.
int around_of(const workbench::RolloutSettings& settings) {
  const bool near = settings.starts.starts_with("around:") && settings.starts.size() == 8;
  return near ? std::clamp(settings.starts[7] - '0', 1, 5) : 3;
}

}  // namespace

void RolloutsPanel::draw_controls(Ui& ui, const WorkbenchState& state, Requests& requests) {
  workbench::RolloutSettings settings = state.rollouts;
  bool changed = false;
  form_label(ui, "Start within");
  int around = around_of(settings);
  if (slider_int(ui, "Start distance", around, 1, 5, "± %d cells",
                 {.help = "How far from the expert's start the agent is put, in cells of the lattice"})) {
    settings.starts = fmt::format("around:{}", around);
    changed = true;
  }
  form_label(ui, "Ghosts");
  changed |= checkbox(ui, "Show", settings.ghosts, {.help = "Draw the paths in the 3-D view"});
  flow(ui.px(44) + ImGui::CalcTextSize("300 paths").x, ui.px(14));
  changed |= slider_int(ui, "Ghost count", settings.ghost_count, 1, 300, "%d paths",
                        {.help = "How many of the rollouts are drawn and listed"});
  if (changed && settings != state.rollouts) requests.emplace_back(Command{workbench::SetRollouts{settings}});
}

Requests RolloutsPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  if (!state.insight || state.insight->entry == nullptr) {
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
  draw_controls(ui, state, requests);
  const int k = around_of(state.rollouts);
  summary_block(ui, fmt::format("Within ±{} cells", k), state.insight->around[static_cast<std::size_t>(k - 1)]);
  ImGui::Dummy({0.0F, ui.px(3)});
  around_table(ui, state.insight->around, k, requests, state.rollouts);
  ImGui::Dummy({0.0F, ui.px(3)});
  summary_block(ui, "All cells", state.insight->all);
  ImGui::Dummy({0.0F, ui.px(3)});
  heading(ui, "Some rollouts");
  ghost_table(ui, state.insight->ghosts, state.insight->entry->model->grid, sort_column_, descending_);
  return requests;
}

}  // namespace trocar::ui
