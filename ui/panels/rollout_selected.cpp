#include "ui/panels/rollout_selected.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/workbench/take_plan.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"
#include "ui/panels/rollout_parts.h"

namespace trocar::ui {
namespace {

std::string cells_list(const spatial::Grid& grid, const std::vector<spatial::CellIndex>& cells) {
  constexpr std::size_t kMost = 6;
  std::string words;
  for (std::size_t i = 0; i < std::min(kMost, cells.size()); ++i) {
    words += (i == 0 ? "" : "; ") + start_words(grid, cells[i]);
  }
  if (cells.size() > kMost) words += fmt::format("; and {} more", cells.size() - kMost);
  return words.empty() ? "none" : words;
}

void draw_why(Ui& ui, const workbench::ModelInsight& insight) {
  const Scope scope(ui, "Why");
  const learning::Explanation& why = *insight.why;
  const spatial::Grid& grid = insight.entry->model->grid;
  fact(ui, "Lost in", fmt::format("{}, after {} steps", start_words(grid, why.where), why.steps));
  note_item(ui, "text", "Lost in", start_words(grid, why.where), {});
  if (!why.cycle.empty()) {
    fact(ui, "Goes round", fmt::format("{} cells: {}", why.cycle.size(), cells_list(grid, why.cycle)));
  }
  fact(ui, "Margin there", number(why.margin));
  fact(ui, "Never tried", why.unexplored.empty() ? "no neighbour" : cells_list(grid, why.unexplored));
}

void draw_parting(Ui& ui, const workbench::ModelInsight& insight) {
  const Scope scope(ui, "Second model");
  const workbench::SecondModel& second = *insight.second;
  fact(ui, second.entry->name, std::string(learning::to_string(second.selected->end)));
  if (!second.parts_at) {
    const bool same_length = insight.selected->cells.size() == second.selected->cells.size();
    fact(ui, "They part", same_length ? "never" : "one ends where the other goes on");
    return;
  }
  const learning::Model& a = *insight.entry->model;
  const learning::Model& b = *second.entry->model;
  const spatial::CellIndex where = insight.selected->cells[static_cast<std::size_t>(*second.parts_at)];
  fact(ui, "They part", fmt::format("after {} steps in {}", *second.parts_at, start_words(a.grid, where)));
  for (int action = 0; action < spatial::kActionCount; ++action) {
    const auto which = static_cast<spatial::Action>(action);
    fact(ui, fmt::format("Q {}, A and B", direction_words(which)),
         number(a.q_at(where, which)) + "  and  " + number(b.q_at(where, which)));
  }
}

/// Why no demonstration can begin there; "" if one can.
std::string cannot_begin(const WorkbenchState& state) {
  return std::string(being_recorded(state));
}

}  // namespace

void draw_selected_rollout(Ui& ui, const WorkbenchState& state, Requests& requests) {
  if (!state.rollouts.selected || !state.insight->selected) return;
  const Scope scope(ui, "Selected");
  const workbench::ModelInsight& insight = *state.insight;
  const spatial::Grid& grid = insight.entry->model->grid;
  const learning::Rollout& rollout = *insight.selected;
  heading(ui, "From " + start_words(grid, rollout.start));
  end_text(ui, rollout.end);
  note_item(ui, "text", "End", learning::to_string(rollout.end), {});
  ImGui::SameLine(0.0F, ui.px(10));
  dim_text(ui, fmt::format("{} steps, {}", rollout.cells.size() - 1, millimetres(rollout.length_m)));
  {
    const FontScope font(ui.fonts().small);
    if (insight.why) draw_why(ui, insight);
    if (insight.second && insight.second->selected) draw_parting(ui, insight);
  }
  const std::string reason = cannot_begin(state);
  constexpr std::string_view kLabel = "Record a corrective demonstration from here";
  if (button(ui, kLabel,
             {.icon = icon::kRecord,
              .help = "Arms a take in the workspace Author: the left tool is led to this cell before it begins",
              .reason = reason,
              .width = std::min(ImGui::GetContentRegionAvail().x, button_width(ui, kLabel, icon::kRecord))})) {
    workbench::RecordByHand take = workbench::another_take(state.last_take);
    take.from = workbench::FromCell{grid.coordinates(rollout.start), grid.n, insight.entry->segment};
    const trial::PhysicsOptions whose = workbench::physics_options_of(*state.project, *insight.entry, {});
    take.options.block = whose.block;
    take.options.goal = whose.goal;
    requests.emplace_back(ShowWorkspace{Workspace::kAuthor});
    requests.emplace_back(ShowPanel{PanelId::kView});
    requests.emplace_back(workbench::Command{take});
  }
  constexpr std::string_view kTrial = "Begin a trial from here";
  const bool of_a = insight.entry->segment == demonstration::Segment::kA;
  if (button(ui, kTrial,
             {.icon = icon::kTasks,
              .help = "The workspace Trials: the left tool of the next trials begins in this cell",
              .reason = of_a ? "" : "A trial begins with segment A, and this model is of another",
              .width = std::min(ImGui::GetContentRegionAvail().x, button_width(ui, kTrial, icon::kTasks))})) {
    const workbench::FromCell from{grid.coordinates(rollout.start), grid.n, insight.entry->segment};
    requests.emplace_back(workbench::Command{workbench::SetTrialStart{from}});
    requests.emplace_back(ShowWorkspace{Workspace::kTrials});
  }
  if (button(ui, "Film it",
             {.icon = icon::kFilm,
              .help = "The workspace Export: the simulator's rollout from this cell, seed 1 and without errors, is a "
                      "source of the film",
              .reason = state.film.film.sources.size() >= 9 ? "A film has room for nine sources" : ""})) {
    const spatial::CellCoordinates start = grid.coordinates(rollout.start);
    film::Source source = film::recording_of(fmt::format("{}", insight.entry->id.value));
    source.kind = film::SourceKind::kRollout;
    source.start = {start.x, start.y, start.z};
    workbench::FilmDraft draft = workbench::with_source(state.film, std::move(source));
    if (draft.film.path.empty()) draft.film.path = (state.path.parent_path() / "film.mp4").string();
    requests.emplace_back(workbench::Command{workbench::SetFilm{std::move(draft)}});
    requests.emplace_back(ShowWorkspace{Workspace::kExport});
  }
  flow(button_width(ui, "Deselect", icon::kCross), ui.px(6));
  if (button(ui, "Deselect", {.icon = icon::kCross, .help = "No rollout stands out", .style = ButtonStyle::kQuiet})) {
    select_start(state, std::nullopt, requests);
  }
  ImGui::Dummy({0.0F, ui.px(4)});
}

}  // namespace trocar::ui
