#include "ui/panels/rollout_pair.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "engine/figure/outcome_colours.h"
#include "engine/statistics/proportion.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/rollout_parts.h"

namespace trocar::ui {
namespace {

using learning::RolloutSummary;

std::string p_words(double p) {
  return p < 0.001 ? "p < 0.001" : fmt::format("p = {:.3f}", p);
}

double arrival_share(int part, int whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / whole;
}

std::string change_words(double change) {
  return statistics::points_text(change, 1);
}

void draw_pairs(Ui& ui, std::string_view name, const learning::PairedComparison& paired) {
  const Scope scope(ui, name);
  const int all = paired.wins_a + paired.wins_b + paired.ties;
  heading(ui, name);
  ImGui::SameLine();
  dim_text(ui, count(all) + " starts");
  outcome_row(ui, "A", "Only A arrives", paired.wins_a, all, ui.theme().accent);
  outcome_row(ui, "B", "Only B", paired.wins_b, all, ui.theme().warning);
  outcome_row(ui, "=", "Ties", paired.ties, all, ui.theme().text_dim);
  if (all > 0) {
    const auto interval = statistics::paired_difference_interval(paired.wins_a, paired.wins_b, all);
    fact(ui, "B − A",
         fmt::format("{} points, 95 %: {} … {}", change_words(arrival_share(paired.wins_b - paired.wins_a, all)),
                     change_words(interval.low), change_words(interval.high)));
  }
  const std::string p = p_words(paired.mcnemar_p);
  fact(ui, "McNemar, exact", p);
  note_item(ui, "text", "McNemar", p, {});
}

/// How the chosen starts end with A, downwards, and with B, to the right; only ends that there are.
void draw_ends(Ui& ui, const learning::OutcomeTable& ends) {
  const Scope scope(ui, "Ends");
  std::vector<std::size_t> rows;
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    int of_a = 0;
    int of_b = 0;
    for (std::size_t j = 0; j < ends.size(); ++j) {
      of_a += ends[i][j];
      of_b += ends[j][i];
    }
    if (of_a > 0) rows.push_back(i);
    if (of_b > 0) columns.push_back(i);
  }
  if (rows.empty()) return;
  heading(ui, "How the chosen starts end");
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp;
  if (!ImGui::BeginTable("ends", static_cast<int>(columns.size()) + 1, kFlags)) return;
  const auto word = [](std::string_view letter, std::size_t end) {
    return fmt::format("{} {}", letter, figure::outcome_word(static_cast<learning::RolloutEnd>(end)));
  };
  ImGui::TableSetupColumn("A \\ B");
  for (const std::size_t column : columns) ImGui::TableSetupColumn(word("B", column).c_str());
  ImGui::TableHeadersRow();
  for (const std::size_t row : rows) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(word("A", row).c_str());
    for (const std::size_t column : columns) {
      ImGui::TableNextColumn();
      const std::string number = count(ends[row][column]);
      ImGui::TextUnformatted(number.c_str());
      note_item(ui, "text", word("A", row) + ", " + word("B", column), number, {});
    }
  }
  ImGui::EndTable();
}

void draw_differences(Ui& ui, const learning::ModelComparison& comparison) {
  const Scope scope(ui, "Differences");
  heading(ui, "Share that arrives");
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchSame;
  if (!ImGui::BeginTable("differences", 4, kFlags)) return;
  for (const char* name : {"Start", "A", "B", "B − A, points"}) ImGui::TableSetupColumn(name);
  ImGui::TableHeadersRow();
  const auto row = [](const std::string& name, const RolloutSummary& a, const RolloutSummary& b) {
    ImGui::TableNextRow();
    for (const std::string& words :
         {name, percent(a.arrived, a.count), percent(b.arrived, b.count),
          change_words(arrival_share(b.arrived, b.count) - arrival_share(a.arrived, a.count))}) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(words.c_str());
    }
  };
  for (std::size_t k = 0; k < comparison.a.around.size(); ++k) {
    row(fmt::format("±{}", k + 1), comparison.a.around[k], comparison.b.around[k]);
  }
  row("all", comparison.a.all, comparison.b.all);
  ImGui::EndTable();
  fact(ui, "Policy changed in", count(comparison.policy_changed) + " cells");
}

}  // namespace

void draw_second_model(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "Two models");
  std::vector<std::string> names{"None"};
  std::vector<workbench::ModelId> ids{{}};
  UniqueNames unique;
  int chosen = 0;
  for (const auto& [id, entry] : state.project->models) {
    if (id == state.model) continue;
    if (id == state.learning.second) chosen = static_cast<int>(ids.size());
    ids.push_back(id);
    names.push_back(unique(entry->name));
  }
  fact(ui, "A", state.insight->entry->name);
  form_label(ui, "B");
  const std::string_view reason = ids.size() < 2 ? "The project has no other model" : "";
  if (combo(ui, "Second model", chosen, names,
            {.help = "Beside the selected one, over the same starts", .reason = reason})) {
    workbench::LearningSettings settings = state.learning;
    settings.second = ids[static_cast<std::size_t>(chosen)];
    requests.emplace_back(workbench::Command{workbench::SetLearning{settings}});
  }
  if (!state.insight->second_error.empty()) {
    wrapped_text(ui, state.insight->second_error, ui.theme().danger);
    return;
  }
  if (!state.insight->second) {
    wrapped_text(ui, "Choose a second model to see from which starts only one of them arrives", ui.theme().text_dim);
    return;
  }
  const workbench::SecondModel& second = *state.insight->second;
  draw_pairs(ui, "Chosen starts", second.paired);
  draw_ends(ui, second.ends);
  ImGui::Dummy({0.0F, ui.px(3)});
  draw_pairs(ui, "All starts", second.comparison->paired);
  ImGui::Dummy({0.0F, ui.px(3)});
  draw_differences(ui, *second.comparison);
  wrapped_text(ui, "Their map is on the page Outcomes", ui.theme().text_dim);
}

}  // namespace trocar::ui
