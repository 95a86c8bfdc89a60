#include "ui/panels/comparison_table.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/statistics/proportion.h"
#include "ui/format.h"

namespace trocar::ui {
namespace {

struct Row {
  std::string name;
  std::string a;
  std::string b;
  std::string change;
};

std::string change_of(double a, double b) {
  if (!std::isfinite(a) || !std::isfinite(b) || a == 0.0) return "\u2013";
  const double percent = 100.0 * (b - a) / std::abs(a);
  return fmt::format("{}{:.1f} %", percent < 0.0 ? "\u2212" : "+", std::abs(percent));
}

Row counts(std::string name, double a, double b) {
  const auto words = [](double cells) {
    return std::isfinite(cells) ? count(static_cast<std::int64_t>(cells)) : std::string("\u2013");
  };
  return {std::move(name), words(a), words(b), change_of(a, b)};
}

Row numbers(std::string name, double a, double b) {
  return {std::move(name), number(a), number(b), change_of(a, b)};
}

/// Of what may be negative: a share of it would tell the wrong way.
Row signed_numbers(std::string name, double a, double b) {
  return {std::move(name), number(a), number(b), b > a ? "+" + number(b - a) : number(b - a)};
}

Row shares(std::string name, int a, int of_a, int b, int of_b) {
  const double points = of_a == 0 || of_b == 0 ? NAN : 100.0 * b / of_b - 100.0 * a / of_a;
  const std::string change = std::isfinite(points) ? statistics::points_text(0.01 * points, 1) + " points" : "\u2013";
  return {std::move(name), percent(a, of_a), percent(b, of_b), change};
}

/// A parameter of methods that draw at random.
std::string drawn(const learning::Model& model, double value) {
  return learning::is_sampled(model.options.method) ? fmt::format("{:g}", value) : "\u2013";
}

/// NaN for a method that tries no actions.
double tried(const learning::Model& model, int cells) {
  return learning::is_sampled(model.options.method) ? cells : NAN;
}

std::vector<Row> rows_of(const workbench::ModelInsight& insight) {
  const learning::ModelComparison& c = *insight.second->comparison;
  const learning::Model& model_a = *insight.entry->model;
  const learning::Model& model_b = *insight.second->entry->model;
  std::vector<Row> rows{{"Method", std::string(learning::to_string(model_a.options.method)),
                         std::string(learning::to_string(model_b.options.method)), ""},
                        {"ε", drawn(model_a, model_a.options.epsilon), drawn(model_b, model_b.options.epsilon), ""},
                        {"Seed", drawn(model_a, static_cast<double>(model_a.options.seed)),
                         drawn(model_b, static_cast<double>(model_b.options.seed)), ""},
                        counts("Fully explored", tried(model_a, c.a.exploration.fully_explored),
                               tried(model_b, c.b.exploration.fully_explored)),
                        counts("Partly explored", tried(model_a, c.a.exploration.partly_explored),
                               tried(model_b, c.b.exploration.partly_explored)),
                        counts("Not explored", tried(model_a, c.a.exploration.fully_unexplored),
                               tried(model_b, c.b.exploration.fully_unexplored)),
                        signed_numbers("Mean reward θ", c.a.mean_reward, c.b.mean_reward),
                        signed_numbers("Least reward θ", c.a.least_reward, c.b.least_reward),
                        numbers("Mean margin", c.a.mean_margin, c.b.mean_margin),
                        numbers("Mismatch", c.a.mismatch, c.b.mismatch),
                        shares("Arrive, all cells", c.a.all.arrived, c.a.all.count, c.b.all.arrived, c.b.all.count)};
  for (std::size_t k = 0; k < c.a.around.size(); ++k) {
    rows.push_back(shares(fmt::format("Arrive within ±{}", k + 1), c.a.around[k].arrived, c.a.around[k].count,
                          c.b.around[k].arrived, c.b.around[k].count));
  }
  for (const std::size_t k : {std::size_t{2}, std::size_t{4}}) {
    rows.push_back(shares(fmt::format("From above, ±{}", k + 1), c.a.around[k].from_above, c.a.around[k].arrived,
                          c.b.around[k].from_above, c.b.around[k].arrived));
  }
  return rows;
}

}  // namespace

std::string policy_change_words(const learning::ModelComparison& comparison, int cells) {
  return fmt::format("policy changed in {} cells ({}); of {} that both know, in {}", count(comparison.policy_changed),
                     statistics::percent_text(comparison.policy_changed, cells, 1), count(comparison.policy_compared),
                     count(comparison.policy_differs));
}

void comparison_table(Ui& ui, const workbench::ModelInsight& insight) {
  const Scope scope(ui, "Measures");
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingStretchProp;
  if (!ImGui::BeginTable("measures", 4, kFlags)) return;
  for (const char* name : {"Measure", "A", "B", "Change"}) ImGui::TableSetupColumn(name);
  ImGui::TableHeadersRow();
  for (const Row& row : rows_of(insight)) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    {
      const ColourScope dim(ImGuiCol_Text, ui.theme().text_dim);
      ImGui::TextUnformatted(row.name.c_str());
    }
    note_item(ui, "text", row.name, row.a + " | " + row.b + " | " + row.change, {});
    for (const std::string& words : {row.a, row.b, row.change}) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(words.c_str());
    }
  }
  ImGui::EndTable();
}

}  // namespace trocar::ui
