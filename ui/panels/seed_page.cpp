#include "ui/panels/seed_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/colour_legend.h"
#include "ui/panels/common.h"
#include "ui/panels/model_slice.h"

namespace trocar::ui {
namespace {

using workbench::SeedInsight;

constexpr int kFewest = 2;
constexpr int kMost = 50;

void draw_seed_table(Ui& ui, const SeedInsight& seeds) {
  const Scope scope(ui, "Seeds");
  heading(ui, counted(seeds.seeds.size(), "seed"));
  constexpr ImGuiTableFlags kFlags =
      ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg;
  const FontScope font(ui.fonts().small);
  if (!ImGui::BeginTable("seeds", 5, kFlags)) return;
  for (const char* name : {"Seed", "Fully explored", "Not explored", "Arrive ±3", "Mismatch"}) {
    ImGui::TableSetupColumn(name);
  }
  ImGui::TableHeadersRow();
  for (const learning::SeedResult& one : seeds.seeds) {
    const std::array<std::string, 5> words{fmt::format("{}", one.seed), count(one.exploration.fully_explored),
                                           count(one.exploration.fully_unexplored),
                                           percent(one.near.arrived, one.near.count), number(one.mismatch)};
    ImGui::TableNextRow();
    for (const std::string& cell : words) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(cell.c_str());
    }
    note_item(ui, "text", words[0], words[1] + " | " + words[2] + " | " + words[3] + " | " + words[4], {});
  }
  ImGui::EndTable();
}

}  // namespace

void SeedPage::draw_fields(Ui& ui, const WorkbenchState& state, int axis, Requests& requests) {
  const SeedInsight& seeds = *state.seeds;
  workbench::FieldSettings of_spread = state.field;
  of_spread.limits.reset();
  of_spread.map.reset();
  of_spread.scale = plot::ScaleKind::kLinear;
  shadings_[0].update(seeds.mean, state.field);
  shadings_[1].update(seeds.spread, of_spread);
  const float gap = ui.px(10);
  const float side = std::min(0.5F * (ImGui::GetContentRegionAvail().x - gap), ui.px(340));
  const bool classes = seeds.mean->categorical;
  draw_model_slice(ui, state, shadings_[0], {"Mean", classes ? "Commonest class" : "Mean", axis, side}, requests);
  ImGui::SameLine(0.0F, gap);
  draw_model_slice(ui, state, shadings_[1],
                   {"Spread", classes ? "Share of seeds that differ" : "Standard deviation", axis, side}, requests);
  const auto limits = colour_legend(ui, shadings_[0], NAN, {.stale = false, .limits = state.field.limits});
  if (limits != state.field.limits) {
    workbench::FieldSettings settings = state.field;
    settings.limits = limits;
    requests.emplace_back(workbench::Command{workbench::SetField{settings}});
  }
  const Scope scope(ui, "Spread");
  colour_legend(ui, shadings_[1], NAN, {});
}

void SeedPage::draw(Ui& ui, const WorkbenchState& state, int axis, Requests& requests) {
  form_label(ui, "Seeds");
  int wanted = state.learning.seeds;
  if (slider_int(ui, "How many", wanted, kFewest, kMost, "%d seeds",
                 {.help = "Trainings that differ in their seed alone, from the model's own on"})) {
    workbench::LearningSettings settings = state.learning;
    settings.seeds = std::clamp(wanted, kFewest, kMost);
    requests.emplace_back(workbench::Command{workbench::SetLearning{settings}});
  }
  if (state.seeds == nullptr) {
    empty_state(ui, icon::kRefresh, "Training with other seeds", "A few seconds at most", {});
    return;
  }
  if (!state.seeds->error.empty()) {
    empty_state(ui, icon::kThLarge, "Nothing differs", state.seeds->error, {});
    return;
  }
  draw_fields(ui, state, axis, requests);
  const auto& study = state.seeds->exploration;
  heading(ui, fmt::format("Section V.A: ε = {:g} against ε = 0", study.epsilon));
  for (std::size_t i = 0; i < state.seeds->findings.size(); ++i) {
    const Scope scope(ui, "Findings");
    wrapped_text(ui, state.seeds->findings[i], ui.theme().text);
    note_item(ui, "text", fmt::format("{}", i + 1), state.seeds->findings[i], {});
  }
  draw_seed_table(ui, *state.seeds);
}

}  // namespace trocar::ui
