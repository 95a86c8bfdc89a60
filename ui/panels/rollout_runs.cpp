#include "ui/panels/rollout_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/figure/outcome_colours.h"
#include "engine/statistics/proportion.h"
#include "ui/command_text.h"
#include "ui/format.h"
#include "ui/forms/export_parts.h"
#include "ui/icons.h"
#include "ui/panels/rollout_parts.h"

namespace trocar::ui {
namespace {

using workbench::Command;

/// "kept at 37 %" of what was stopped.
std::string kept_words(int finished, std::size_t all) {
  return fmt::format("{} %", 100 * static_cast<std::size_t>(finished) / std::max<std::size_t>(all, 1));
}

std::string share_words(double share) {
  return statistics::share_text(share, 1);
}

std::string no_starts(const WorkbenchState& state) {
  return state.insight->starts.empty() ? "There are no starts" : "";
}

}  // namespace

void RolloutRuns::draw_erring(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "Err at random");
  heading(ui, "Err at random");
  form_label(ui, "ε");
  slider_float(ui, "Epsilon", epsilon_, 0.0F, 0.5F, "%.2f",
               {.help = "Share of the actions that are drawn evenly from those allowed"});
  form_label(ui, "Runs each");
  number_field(ui, "Runs", runs_, 1, 100'000, {.help = "Random rollouts for each start"});
  form_label(ui, "Seed");
  number_field(ui, "Seed", seed_, 0, 1'000'000'000, {.help = "The same seed gives the same runs"});
  if (const workbench::JobView* job = job_under_way(state, "Err at random")) {
    draw_job_under_way(ui, *job, "What is finished is kept", requests);
  } else {
    const std::string reason = no_starts(state);
    if (button(ui, "Run", {.icon = icon::kPlay, .help = "From every start that is chosen", .reason = reason})) {
      learning::MonteCarloOptions options;
      options.epsilon = std::round(1e6 * static_cast<double>(epsilon_)) / 1e6;
      options.runs = static_cast<int>(runs_);
      options.seed = static_cast<std::uint64_t>(seed_);
      requests.emplace_back(Command{workbench::RunMonteCarlo{options}});
    }
  }
  if (!state.monte_carlo) return;
  const workbench::MonteCarloView& found = *state.monte_carlo;
  const double share = found.runs == 0 ? 0.0 : static_cast<double>(found.arrived) / static_cast<double>(found.runs);
  const std::string words = fmt::format("{}, 95 % interval {} to {}", share_words(share),
                                        share_words(found.interval.low), share_words(found.interval.high));
  if (!found.whole()) {
    badge(ui, icon::kStop, kept_words(found.result.finished, found.result.starts.size()), ui.theme().warning,
          "It was stopped; the starts that were finished are told of");
  }
  outcome_row(ui, icon::kVerify, "Arrives", found.arrived, found.runs,
              figure::outcome_colour(learning::RolloutEnd::kArrives));
  wrapped_text(ui, words, ui.theme().text);
  note_item(ui, "text", "Share", words, {});
  small_text(ui,
             fmt::format("ε = {:g}, {} starts ({}), {} runs each, seed {}", found.result.options.epsilon,
                         count(found.result.finished), fitted(found.starts, ui.px(120)), count(found.result.runs()),
                         found.result.options.seed),
             ui.theme().text_dim);
  if (found.entry != state.insight->entry || found.starts != state.rollouts.starts) {
    badge(ui, icon::kWarning, "of another model or other starts", ui.theme().warning);
  }
}

trial::PhysicsOptions RolloutRuns::physics_options() const {
  // A slider's value is written in as many digits as it shows.
  const auto shown = [](float value, double digits) {
    return std::round(static_cast<double>(value) * digits) / digits;
  };
  trial::PhysicsOptions options;
  options.seed = static_cast<std::uint64_t>(world_seed_);
  options.continuous = continuous_;
  options.perturbed.epsilon = shown(errs_, 100.0);
  options.perturbed.delay_s = 1e-3 * static_cast<double>(delay_ms_);
  options.perturbed.noise_m = 1e-3 * shown(noise_mm_, 10.0);
  return options;
}

void RolloutRuns::draw_physics(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "In the simulator");
  heading(ui, "In the simulator");
  form_label(ui, "Seed");
  number_field(ui, "Seed", world_seed_, 0, 1'000'000'000,
               {.help = "How the blocks are turned, and where in its cell a start is"});
  form_label(ui, "Start");
  checkbox(ui, "Anywhere in the cell", continuous_, {.help = "Else in its middle"});
  form_label(ui, "Errs, ε");
  slider_float(ui, "Errs", errs_, 0.0F, 0.5F, "%.2f",
               {.help = "Share of the actions that are drawn evenly from those allowed"});
  form_label(ui, "Delay, ms");
  number_field(ui, "Delay", delay_ms_, 0, 5000, {.help = "The policy is asked for where the tool was so long ago"});
  form_label(ui, "Noise, mm");
  slider_float(ui, "Noise", noise_mm_, 0.0F, 5.0F, "%.1f",
               {.help = "Standard deviation, on each axis, of where the tool is taken to be"});
  const auto& found = state.physics;
  const trial::PhysicsOptions options =
      workbench::physics_options_of(*state.project, *state.insight->entry, physics_options());
  const bool goes_on = found && static_cast<std::size_t>(found->finished) < found->cells.size() &&
                       found->starts == state.rollouts.starts && found->entry == state.insight->entry &&
                       trial::same_runs(found->options, options);
  if (const workbench::JobView* job = job_under_way(state, "Rollouts in the simulator")) {
    draw_job_under_way(ui, *job, "What is finished is kept; Go on takes it up again", requests);
  } else {
    const std::string reason = no_starts(state);
    if (button(ui, goes_on ? "Go on" : "Simulate",
               {.icon = icon::kPlay,
                .help = "Drives the policy through the simulator from every start, on all cores",
                .reason = reason})) {
      requests.emplace_back(Command{workbench::RunPhysics{physics_options()}});
    }
  }
  if (!found) return;
  if (static_cast<std::size_t>(found->finished) < found->cells.size()) {
    badge(ui, icon::kStop, kept_words(found->finished, found->cells.size()), ui.theme().warning,
          "It was stopped; Go on takes it up again");
  }
  outcome_row(ui, icon::kVerify, "Arrives", found->arrived, found->finished,
              figure::outcome_colour(learning::RolloutEnd::kArrives));
  std::array<int, trial::kPhysicsEnds> ends{};
  for (const auto& rollout : found->rollouts) {
    if (rollout) ++ends[static_cast<std::size_t>(rollout->end)];
  }
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (ends[i] == 0) continue;
    const std::string name(trial::to_string(static_cast<trial::PhysicsEnd>(i)));
    outcome_row(ui, icon::kCross, name, ends[i], found->finished, ui.theme().danger);
  }
  fact(ui, "Blocks pushed by", "at most " + millimetres(found->pushed_m));
}

std::string RolloutRuns::no_rows(const WorkbenchState& state) const {
  const auto rows = static_cast<workbench::RolloutRows>(rows_);
  if (rows == workbench::RolloutRows::kBand && !file_.ends_with(".csv")) return "A band's name must end in .csv";
  const auto of_others = [&state](const auto& found) {
    return found->entry != state.insight->entry || found->starts != state.rollouts.starts;
  };
  constexpr std::string_view kOthers = "What was found is of another model or other starts: run it again";
  if (rows == workbench::RolloutRows::kErring) {
    if (!state.monte_carlo) return "Nothing is known yet: let the agent err at random first";
    if (of_others(state.monte_carlo)) return std::string(kOthers);
  }
  if (rows == workbench::RolloutRows::kSimulated) {
    if (!state.physics) return "Nothing is known yet: simulate the rollouts first";
    if (of_others(state.physics)) return std::string(kOthers);
  }
  const auto starts = static_cast<int>(state.insight->starts.size());
  if (rows == workbench::RolloutRows::kBand && starts > 0 && starts < learning::kLeastInBand) {
    return fmt::format("A band needs {} starts", learning::kLeastInBand);
  }
  return no_starts(state);
}

void RolloutRuns::draw_export(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "Export");
  static const std::vector<std::string> kRows{"Exact", "Erring", "Simulator", "Band"};
  heading(ui, "Export");
  form_label(ui, "Rows");
  segmented(
      ui, "Rows", rows_, kRows,
      {.help = "All measures of each start; these with runs, arrivals and Wilson's interval; the simulator's; or the "
               "deviations from the expert, step by step"});
  form_label(ui, "File");
  text_field(ui, "File", file_, "rollouts.csv", {.help = "Its ending says what kind it is: .csv, .json or .h5"});
  static const std::vector<std::string> kFiles{"CSV", "JSON", "HDF5"};
  constexpr std::array<std::string_view, 3> kEndings{".csv", ".json", ".h5"};
  int kind = place_of_ending(file_, kEndings);
  form_label(ui, "Kind of file");
  if (segmented(ui, "Kind of file", kind, kFiles, {.help = "The same table and the same numbers in each"})) {
    file_ = std::filesystem::path(file_).replace_extension(kEndings[static_cast<std::size_t>(kind)]).string();
  }
  std::string reason = no_rows(state);
  if (reason.empty()) reason = reason_against_path(file_, state);
  if (reason.empty() && kind < 0) reason = "Choose a kind of file";
  const Command rows{workbench::ExportRollouts{file_, static_cast<workbench::RolloutRows>(rows_)}};
  if (button(ui, "Export",
             {.icon = icon::kTable,
              .help = rows_ == static_cast<int>(workbench::RolloutRows::kBand)
                          ? "One row for each step; the same bytes as the command line writes"
                          : "One row for each chosen start; the same bytes as the command line writes",
              .reason = reason})) {
    requests.emplace_back(rows);
  }
  const std::string typed = command_text(rows, state);
  flow(button_width(ui, "Copy as command", icon::kCopy), ui.px(6));
  if (button(ui, "Copy as command", {.icon = icon::kCopy, .help = typed, .style = ButtonStyle::kQuiet})) {
    requests.emplace_back(CopyText{typed});
  }
}

void RolloutRuns::draw(Ui& ui, const WorkbenchState& state, Requests& requests) {
  draw_erring(ui, state, requests);
  ImGui::Dummy({0.0F, ui.px(6)});
  draw_physics(ui, state, requests);
  ImGui::Dummy({0.0F, ui.px(6)});
  draw_export(ui, state, requests);
}

}  // namespace trocar::ui
