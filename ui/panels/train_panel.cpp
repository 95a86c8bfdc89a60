#include "ui/panels/train_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "engine/learning/training_input.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"
#include "ui/panels/learning_curve.h"
#include "ui/panels/model_state.h"
#include "ui/panels/rollout_parts.h"

namespace trocar::ui {
namespace {

constexpr std::array<learning::Method, 3> kMethods{learning::Method::kEgMaxent, learning::Method::kEgMaxentPlus,
                                                   learning::Method::kExact};

// The agent's segments (paper, Fig. 1).
constexpr std::array<demonstration::Segment, 2> kSegments{demonstration::Segment::kA, demonstration::Segment::kC};

using workbench::Command;

/// Typed, to six digits; kept within its bounds.
void decimal_field(Ui& ui, std::string_view shown, std::string_view name, double& value, double low, double high,
                   const WidgetOptions& options) {
  form_label(ui, shown);
  std::string text = fmt::format("{:.6g}", value);
  if (!text_field(ui, name, text, "", options)) return;
  double typed = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), typed);
  if (error == std::errc{} && end == text.data() + text.size() && std::isfinite(typed)) {
    value = std::clamp(typed, low, high);
  }
}

void whole_field(Ui& ui, std::string_view name, int& value, int low, int high, const WidgetOptions& options) {
  form_label(ui, name);
  std::int64_t typed = value;
  if (number_field(ui, name, typed, low, high, options)) value = static_cast<int>(typed);
}

std::string_view method_help(int method) {
  if (method == 0) return "The paper's Algorithm 1: exploration by ε-greedy episodes";
  if (method == 1) return "Algorithm 1 with starts spread around the expert's";
  return "Maximum entropy without sampling: the same result each time";
}

}  // namespace

void TrainPanel::draw_choice(Ui& ui, const WorkbenchState& state) {
  const Scope scope(ui, "Demonstrations");
  heading(ui, "Learn from");
  const demonstration::Segment segment = kSegments[static_cast<std::size_t>(segment_)];
  UniqueNames unique;
  for (const auto& [id, shown] : state.project->demonstrations) {
    bool chosen = !left_out_.contains(id);
    const bool has = shown->segment(segment).has_value();
    if (!has) chosen = false;
    ImGui::PushID(static_cast<int>(id.value));
    const std::string why = has ? "" : std::string("It has no segment ") + demonstration::letter(segment);
    if (checkbox(ui, unique(shown->name), chosen, {.reason = why})) {
      if (chosen) {
        left_out_.erase(id);
      } else {
        left_out_.insert(id);
      }
    }
    ImGui::PopID();
  }
}

void TrainPanel::draw_method(Ui& ui) {
  static const std::vector<std::string> kPresetNames{"Paper", "Product", "Exact"};
  static const std::vector<std::string> kMethodNames{"eg-maxent", "eg-maxent+", "exact"};
  static const std::vector<std::string> kSegmentNames{"A  approach", "C  transfer"};
  form_label(ui, "Preset");
  int preset = -1;
  for (int i = 0; i < 3; ++i) {
    learning::TrainOptions of_preset = learning::options_of(static_cast<learning::Preset>(i), static_cast<int>(grid_));
    of_preset.seed = options_.seed;
    if (of_preset == options_) preset = i;
  }
  if (segmented(ui, "Preset", preset, kPresetNames,
                {.help = "Table I of the paper, the product's variant, or maximum entropy without sampling"})) {
    const std::uint64_t seed = options_.seed;
    options_ = learning::options_of(static_cast<learning::Preset>(preset), static_cast<int>(grid_));
    options_.seed = seed;
  }
  form_label(ui, "Method");
  int method = static_cast<int>(options_.method);
  if (combo(ui, "Method", method, kMethodNames, {.help = method_help(method)})) {
    options_.method = kMethods[static_cast<std::size_t>(method)];
  }
  wrapped_text(ui, method_help(method), ui.theme().text_dim);
  form_label(ui, "Segment");
  segmented(ui, "Segment", segment_, kSegmentNames, {.help = "The agent's segments of the transfer"});
}

void TrainPanel::draw_parameters(Ui& ui) {
  const bool exact = options_.method == learning::Method::kExact;
  const std::string_view sampled = exact ? "The exact method does not sample" : "";
  const std::string_view of_exact = exact ? "" : "Of the exact method";
  const std::string_view spread =
      options_.method == learning::Method::kEgMaxent ? "The paper's method has one start" : "";
  decimal_field(ui, "ε", "Epsilon", options_.epsilon, 0.0, 1.0,
                {.help = "Share of random actions while learning; the paper uses 0 to 0.1", .reason = sampled});
  whole_field(ui, "Episodes", options_.episodes, 1, 1'000'000, {.help = "The paper uses 10,000", .reason = sampled});
  auto seed = static_cast<std::int64_t>(options_.seed);
  form_label(ui, "Seed");
  if (number_field(ui, "Seed", seed, 0, 1'000'000'000, {.help = "The same seed gives the same model"})) {
    options_.seed = static_cast<std::uint64_t>(seed);
  }
  form_label(ui, "Cells a side");
  number_field(ui, "Grid", grid_, 8, 88, {.help = "22 is the paper's lattice of 2.5 mm"});
  if (toggle(ui, "All parameters", all_parameters_,
             {.icon = icon::kSliders, .help = "Show every hyperparameter of the method"})) {
    all_parameters_ = !all_parameters_;
  }
  if (all_parameters_) {
    decimal_field(ui, "β, rate of θ", "Theta rate", options_.theta_rate, 1e-6, 10.0,
                  {.help = "Equation (1); Table I: 0.3", .reason = sampled});
    decimal_field(ui, "α, rate of Q", "Q rate", options_.q_rate, 1e-6, 1.0,
                  {.help = "Equation (2); Table I: 0.3", .reason = sampled});
    decimal_field(ui, "γ, discount", "Discount", options_.discount, 0.0, 1.0,
                  {.help = "Equation (2); Table I: 0.99", .reason = sampled});
    whole_field(ui, "Safe radius", options_.safe_radius, 0, 88,
                {.help = "Cells around the demonstration that the agent never leaves"});
    whole_field(ui, "Start spread", options_.start_spread, 0, 88,
                {.help = "Training starts within ± this many cells of the expert's", .reason = spread});
    decimal_field(ui, "θ₀, prior", "Prior", options_.theta_prior, -50.0, learning::exact_reward_limit(),
                  {.help = "Reward of a cell that nothing was shown of", .reason = of_exact});
    decimal_field(ui, "λ, pull to θ₀", "Regularisation", options_.regularisation, 1e-6, 1e6,
                  {.help = "How strongly rewards are held at the prior", .reason = of_exact});
  }
  form_label(ui, "Name");
  text_field(ui, "Name", name_, "From method and segment");
}

void TrainPanel::play(Ui& ui, const WorkbenchState& state, Requests& requests) {
  if (!playing_) return;
  ui.animate();
  const workbench::ModelInsight& insight = *state.insight;
  if (state.insight_pending) return;
  workbench::LearningSettings settings = state.learning;
  // Some four seconds for all of it.
  const int step = std::max(1, insight.epochs / 120);
  const int next = settings.epoch < 0 ? 0 : settings.epoch + step;
  playing_ = next < insight.epochs;
  settings.epoch = playing_ ? next : -1;
  requests.emplace_back(Command{workbench::SetLearning{settings}});
}

void TrainPanel::draw_history(Ui& ui, const WorkbenchState& state, Requests& requests) {
  if (!state.insight || state.insight->entry == nullptr || state.insight->epochs == 0) return;
  const Scope scope(ui, "Learning");
  const std::shared_ptr<const workbench::ModelEntry> stored = selected_model(state);
  if (stored == nullptr || stored->model == nullptr) return;
  const workbench::ModelInsight& insight = *state.insight;
  ImGui::Dummy({0.0F, ui.px(6)});
  heading(ui, "Learning of " + stored->name);
  draw_model_state(ui, state, requests);
  const auto go_to = [&](int epoch) {
    workbench::LearningSettings settings = state.learning;
    settings.epoch = epoch >= insight.epochs ? -1 : epoch;
    requests.emplace_back(Command{workbench::SetLearning{settings}});
  };
  if (const auto epoch = learning_curve(ui, stored->model->curve, insight.epoch, ui.px(120))) {
    playing_ = false;
    go_to(*epoch);
  }
  if (icon_button(ui, playing_ ? "Pause the learning" : "Play the learning",
                  {.icon = playing_ ? icon::kPause : icon::kPlay, .help = "Watch field and policy being learned"})) {
    playing_ = !playing_;
    if (playing_ && insight.epoch >= insight.epochs) go_to(0);
  }
  ImGui::SameLine(0.0F, ui.px(8));
  int epoch = insight.epoch;
  if (slider_int(ui, "Epoch", epoch, 0, insight.epochs, "epoch %d", {.width = -1.0F})) {
    playing_ = false;
    go_to(epoch);
  }
  workbench::PlotSettings plot;
  plot.kind = workbench::PlotKind::kCurve;
  export_plot_button(ui, "Export curve…", plot, requests);
  if (learning::is_sampled(insight.entry->model->options.method)) {
    fact(ui, "Fully explored", count(insight.exploration.fully_explored));
    fact(ui, "Not explored", count(insight.exploration.fully_unexplored));
  }
  fact(ui, "Arrive within ±3", percent(insight.around[2].arrived, insight.around[2].count));
  play(ui, state, requests);
}

void TrainPanel::draw_running(Ui& ui, const WorkbenchState& state, Requests& requests) {
  if (!state.training) return;
  const Scope scope(ui, "Running");
  ImGui::Dummy({0.0F, ui.px(6)});
  heading(ui, "Learning now: " + state.training->name);
  growing_curve(ui, state.training->curve, state.training->epochs, ui.px(120));
  const auto job = std::find_if(state.jobs.begin(), state.jobs.end(),
                                [&](const workbench::JobView& each) { return each.id == state.training->job; });
  if (job != state.jobs.end()) draw_job_under_way(ui, *job, "Leaves no model", requests);
}

workbench::TrainModel TrainPanel::training(const WorkbenchState& state) const {
  workbench::TrainModel train;
  train.segment = kSegments[static_cast<std::size_t>(segment_)];
  for (const auto& [id, shown] : state.project->demonstrations) {
    if (!left_out_.contains(id) && shown->segment(train.segment)) train.demonstrations.push_back(id);
  }
  train.options = options_;
  train.grid = static_cast<int>(grid_);
  train.name = name_;
  return train;
}

std::string TrainPanel::reason(const WorkbenchState& state) const {
  if (state.project->demonstrations.empty()) return "There is no demonstration to learn from";
  const demonstration::Segment segment = kSegments[static_cast<std::size_t>(segment_)];
  for (const auto& [id, shown] : state.project->demonstrations) {
    if (!left_out_.contains(id) && shown->segment(segment)) return "";
  }
  return "No demonstration is chosen";
}

Requests TrainPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  if (state.project->demonstrations.empty()) {
    const std::string reason = command("demo.record").reason_now(state);
    const std::array<EmptyStateAction, 1> actions{{{"Record…", icon::kRecord, reason, "Record a transfer"}}};
    if (empty_state(ui, icon::kTrain, "Nothing to learn from", "A model is learned from demonstrations", actions) ==
        0) {
      requests.emplace_back(UiAction::kShowRecord);
    }
    return requests;
  }
  heading(ui, "Learn by");
  draw_method(ui);
  draw_parameters(ui);
  ImGui::Dummy({0.0F, ui.px(2)});
  draw_choice(ui, state);
  ImGui::Dummy({0.0F, ui.px(6)});
  const std::string why = reason(state);
  if (button(ui, "Train",
             {.icon = icon::kTrain,
              .help = "Start the training; it runs beside your work",
              .reason = why,
              .width = -1.0F,
              .style = ButtonStyle::kPrimary})) {
    requests.emplace_back(Command{training(state)});
  }
  draw_running(ui, state, requests);
  draw_history(ui, state, requests);
  return requests;
}

}  // namespace trocar::ui
