#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/commands/rollout_commands.h"
#include "app/lookup.h"
#include "app/options.h"
#include "engine/core/file.h"
#include "engine/exchange/rollout_file.h"
#include "engine/learning/rollout.h"
#include "engine/learning/rollout_spread.h"
#include "engine/learning/start_file.h"
#include "engine/learning/start_set.h"
#include "engine/statistics/proportion.h"
#include "engine/workbench/rolling.h"

namespace trocar::app {
namespace {

struct RunArguments {
  std::string project;
  std::string model;
  std::string starts;
  std::string out;
  std::string band;
  bool spread = false;
  double epsilon = -1.0;  ///< < 0: the agent does not err.
  learning::MonteCarloOptions erring;
};

std::string starts_of(const RunArguments& arguments) {
  return arguments.starts.empty() ? "around:3" : arguments.starts;
}

void bind_rollout_run(CLI::App& verb, RunArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("MODEL", arguments.model, "Id or name")->required();
  verb.add_option("--starts", arguments.starts, starts_help() + "; else around:3, and ±1 … ±5 beside it");
  verb.add_option("--out", arguments.out, "F.csv, F.json or F.h5 (HDF5): also write one row for each rollout");
  verb.add_option("--band", arguments.band,
                  "F.csv: also write how far the rollouts are from the expert, step by step: how many still go on, and "
                  "5, 25, 50, 75 and 95 % of these");
  verb.add_flag("--spread", arguments.spread,
                "Also say how many have arrived by which step, and how far rollouts stray, by their end");
  verb.add_option("--epsilon", arguments.epsilon,
                  "Let the agent err: this share of its actions is drawn evenly from those allowed, 0 … 1")
      ->check(CLI::Range(0.0, 1.0));
  verb.add_option("--runs", arguments.erring.runs, "Random rollouts for each start; with --epsilon")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  add_seed(verb, arguments.erring.seed, "Seed of the random rollouts");
  verb.add_option("--threads", arguments.erring.threads, "For random rollouts; the result does not depend on it")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
}

Json summary_json(const learning::RolloutSummary& summary) {
  return {{"count", summary.count},       {"arrived", summary.arrived}, {"looped", summary.looped},
          {"dead_end", summary.dead_end}, {"outside", summary.outside}, {"from_above", summary.from_above}};
}

/// Only A ends on a block that is to be taken from above; C ends sideways, at the hand-off.
std::string rollouts_line(const learning::RolloutSummary& summary, demonstration::Segment segment) {
  std::string line = fmt::format("{} of {} arrive ({})", summary.arrived, summary.count,
                                 statistics::percent_text(summary.arrived, summary.count, 1));
  if (segment == demonstration::Segment::kA) {
    line += fmt::format(", {} of them from above", statistics::percent_text(summary.from_above, summary.arrived, 1));
  }
  return line;
}

/// After how many steps so many have arrived: a tenth, a quarter, half, three quarters, nine tenths of the starts, as
/// far as it comes to that, and all that arrive.
std::string arrivals_text(const std::vector<int>& arrivals, std::size_t starts) {
  std::string text = "\n  arrived by step:";
  if (arrivals.back() == 0) return text + " none";
  const auto add = [&text, &arrivals, starts](std::size_t step) {
    text += fmt::format(" {} ({}) within {},", arrivals[step],
                        statistics::percent_text(arrivals[step], static_cast<std::int64_t>(starts), 1), step);
  };
  std::size_t told = arrivals.size();
  for (const double share : {0.1, 0.25, 0.5, 0.75, 0.9}) {
    const auto reached = std::find_if(arrivals.begin(), arrivals.end(), [share, starts](int arrived) {
      return static_cast<double>(arrived) >= share * static_cast<double>(starts);
    });
    const auto step = static_cast<std::size_t>(reached - arrivals.begin());
    if (step + 1 >= arrivals.size() || step == told) continue;
    told = step;
    add(step);
  }
  add(arrivals.size() - 1);
  text.back() = ' ';
  return text + "steps";
}

/// By when the starts have arrived, and where the worst deviations lie, by end; millimetres.
Status tell_spread(const learning::Model& model, const std::vector<std::uint8_t>& policy, const learning::Basin& basin,
                   const std::vector<spatial::CellIndex>& starts, Progress& progress, Answer& answer) {
  const std::vector<int> arrivals = learning::arrivals_by_step(basin, starts);
  answer.json["arrivals_by_step"] = arrivals;
  answer.text += arrivals_text(arrivals, starts.size());
  TROCAR_ASSIGN_OR_RETURN(const learning::RolloutSpread all,
                          learning::spread_from(model, policy, starts, {}, progress));
  answer.json["worst_deviation_mm"] = Json::object();
  for (int i = 0; i <= static_cast<int>(learning::RolloutEnd::kOutsideSafeSet); ++i) {
    const auto end = static_cast<learning::RolloutEnd>(i);
    const learning::Spread& spread = all.of(learning::RolloutMeasure::kMaxDeviation, end).spread;
    if (spread.count == 0) continue;
    answer.json["worst_deviation_mm"][std::string(learning::to_string(end))] = {
        {"count", spread.count},         {"least", 1e3 * spread.least}, {"low", 1e3 * spread.low},
        {"median", 1e3 * spread.median}, {"high", 1e3 * spread.high},   {"most", 1e3 * spread.most}};
    answer.text +=
        fmt::format("\n  {}: worst deviation {:.1f} to {:.1f} mm, middle {:.1f}, half in {:.1f} to {:.1f} mm",
                    learning::to_string(end), 1e3 * spread.least, 1e3 * spread.most, 1e3 * spread.median,
                    1e3 * spread.low, 1e3 * spread.high);
  }
  return {};
}

/// What erring at random does, for people and programs.
void tell_erring(const workbench::MonteCarloView& found, Answer& answer) {
  const double share = found.runs == 0 ? 0.0 : static_cast<double>(found.arrived) / static_cast<double>(found.runs);
  answer.json["monte_carlo"] = {{"runs", found.runs}, {"starts", found.result.finished}, {"arrived", found.arrived},
                                {"share", share},     {"low", found.interval.low},       {"high", found.interval.high}};
  answer.text +=
      fmt::format("\n  with ε = {:g}: {} of {} arrive ({}, 95 % interval {} to {})", found.result.options.epsilon,
                  found.arrived, found.runs, statistics::share_text(share, 2),
                  statistics::share_text(found.interval.low, 2), statistics::share_text(found.interval.high, 2));
}

Result<std::optional<learning::MonteCarlo>> err_at_random(const RunArguments& arguments, const learning::Model& model,
                                                          const std::vector<spatial::CellIndex>& starts,
                                                          Progress& progress) {
  if (arguments.epsilon < 0.0) return std::optional<learning::MonteCarlo>();
  learning::MonteCarloOptions options = arguments.erring;
  options.epsilon = arguments.epsilon;
  TROCAR_ASSIGN_OR_RETURN(learning::MonteCarlo result, learning::monte_carlo(model, starts, options, progress));
  if (progress.cancelled()) return fail(ErrorCode::kCancelled, "stopped before all random rollouts were done");
  return std::optional(std::move(result));
}

Result<Answer> run_run(const RunArguments& arguments, Console& console) {
  if (!arguments.out.empty()) TROCAR_RETURN_IF_ERROR(check_output(arguments.out, arguments.project, kRowEndings));
  if (!arguments.band.empty()) TROCAR_RETURN_IF_ERROR(check_output(arguments.band, arguments.project, {".csv"}));
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file, open_to_read(arguments.project, console, Models::kWhole));
  TROCAR_ASSIGN_OR_RETURN(const auto entry, find_model(*file.project(), arguments.model));
  const learning::Model& model = *entry->model;
  TROCAR_ASSIGN_OR_RETURN(const std::vector<spatial::CellIndex> starts,
                          learning::read_starts(starts_of(arguments), model));
  warn_if_stale(*file.project(), *entry, console);

  const double begin_s = console.clock->now_s();
  const std::vector<std::uint8_t> policy = learning::greedy_policy(model);
  const learning::Basin basin = learning::basin(model, policy);
  const learning::RolloutSummary summary = learning::summarise(basin, starts);
  const double seconds = console.clock->now_s() - begin_s;
  TROCAR_ASSIGN_OR_RETURN(const std::optional<learning::MonteCarlo> erring,
                          err_at_random(arguments, model, starts, console.progress()));
  if (!arguments.out.empty()) {
    TROCAR_ASSIGN_OR_RETURN(const std::string csv,
                            workbench::rollout_rows(model, starts, erring ? &*erring : nullptr, console.progress()));
    TROCAR_RETURN_IF_ERROR(
        exchange::write_rollout_rows(csv, workbench::about_rollouts(*entry, starts_of(arguments)), arguments.out));
  }
  if (!arguments.band.empty()) {
    TROCAR_ASSIGN_OR_RETURN(const std::string csv, workbench::band_rows(model, starts, console.progress()));
    TROCAR_RETURN_IF_ERROR(write_file(arguments.band, csv));
  }

  Answer answer;
  answer.json = summary_json(summary);
  answer.json["seconds"] = seconds;
  answer.json["around"] = Json::array();
  answer.summary = rollouts_line(summary, entry->segment);
  answer.text = answer.summary;
  // A list of starts from a file has nothing to do with the model's own.
  const int rows = arguments.starts.starts_with("file:") ? 0 : 5;
  for (int k = 1; k <= rows; ++k) {
    const learning::RolloutSummary near = learning::summarise(basin, learning::starts_around(model, k));
    Json row = summary_json(near);
    row["k"] = k;
    answer.json["around"].push_back(std::move(row));
    if (arguments.starts.empty())
      answer.text += fmt::format("\n  within ±{}: {}", k, rollouts_line(near, entry->segment));
  }
  if (arguments.spread) {
    TROCAR_RETURN_IF_ERROR(tell_spread(model, policy, basin, starts, console.progress(), answer));
  }
  if (erring) tell_erring(workbench::monte_carlo_view(entry, arguments.starts, *erring), answer);
  return answer;
}

struct CompareRolloutsArguments {
  std::string project;
  std::string model_a;
  std::string model_b;
  std::string starts = "all";
};

void bind_compare(CLI::App& verb, CompareRolloutsArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("MODEL_A", arguments.model_a, "Id or name")->required();
  verb.add_option("MODEL_B", arguments.model_b, "Id or name")->required();
  verb.add_option("--starts", arguments.starts, "As for `rollout run`; around A's start")->capture_default_str();
}

/// How the starts end with both: every pair of ends that there is.
void tell_ends(const learning::OutcomeTable& ends, Answer& answer) {
  answer.json["ends"] = Json::array();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = 0; j < ends.size(); ++j) {
      if (ends[i][j] == 0) continue;
      const std::string_view of_a = learning::to_string(static_cast<learning::RolloutEnd>(i));
      const std::string_view of_b = learning::to_string(static_cast<learning::RolloutEnd>(j));
      answer.json["ends"].push_back({{"a", of_a}, {"b", of_b}, {"starts", ends[i][j]}});
      answer.text += fmt::format("\n  A {}, B {}: {}", of_a, of_b, ends[i][j]);
    }
  }
}

Result<Answer> run_compare_rollouts(const CompareRolloutsArguments& arguments, Console& console) {
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file, open_to_read(arguments.project, console, Models::kWhole));
  TROCAR_ASSIGN_OR_RETURN(const auto a, find_model(*file.project(), arguments.model_a));
  TROCAR_ASSIGN_OR_RETURN(const auto b, find_model(*file.project(), arguments.model_b));
  if (a->model->grid != b->model->grid) {
    return fail(ErrorCode::kInvalidArgument, "the models have different lattices");
  }
  TROCAR_ASSIGN_OR_RETURN(const std::vector<spatial::CellIndex> starts,
                          learning::read_starts(arguments.starts, *a->model));
  warn_if_stale(*file.project(), *a, console);
  if (a != b) warn_if_stale(*file.project(), *b, console);
  warn_if_unlike(*a, *b, console);
  const learning::Basin basin_a = learning::basin(*a->model, learning::greedy_policy(*a->model));
  const learning::Basin basin_b = learning::basin(*b->model, learning::greedy_policy(*b->model));
  const learning::PairedComparison paired = learning::compare(basin_a, basin_b, starts);

  Answer answer;
  answer.json = {{"starts", starts.size()}, {"wins_a", paired.wins_a},       {"wins_b", paired.wins_b},
                 {"ties", paired.ties},     {"mcnemar_p", paired.mcnemar_p}, {"model_a", a->id.value},
                 {"model_b", b->id.value}};
  const int pairs = paired.wins_a + paired.wins_b + paired.ties;
  const auto interval = statistics::paired_difference_interval(paired.wins_a, paired.wins_b, pairs);
  answer.json["difference"] = static_cast<double>(paired.wins_b - paired.wins_a) / std::max(pairs, 1);
  answer.json["difference_low"] = interval.low;
  answer.json["difference_high"] = interval.high;
  answer.summary =
      fmt::format("only A arrives {}, only B {}, ties {}; B − A {} points, 95 % interval {} … {}; McNemar p {}",
                  paired.wins_a, paired.wins_b, paired.ties,
                  statistics::points_text(static_cast<double>(paired.wins_b - paired.wins_a) / std::max(pairs, 1), 1),
                  statistics::points_text(interval.low, 1), statistics::points_text(interval.high, 1),
                  paired.mcnemar_p < 0.001 ? std::string("< 0.001") : fmt::format("= {:.3g}", paired.mcnemar_p));
  answer.text = fmt::format("A {}, B {}: {}", a->name, b->name, answer.summary);
  tell_ends(learning::outcome_table(basin_a, basin_b, starts), answer);
  return answer;
}

}  // namespace

std::string starts_help() {
  return std::string(learning::start_set_help());
}

void add_rollout_commands(CLI::App& root, Action& chosen) {
  CLI::App& noun = *root.add_subcommand("rollout", "Let the agent run from many starts")->require_subcommand(1);
  add_verb<RunArguments>(noun, chosen, "run", "Roll a model's policy out and count how it ends", bind_rollout_run,
                         run_run);
  add_verb<CompareRolloutsArguments>(noun, chosen, "compare", "Compare two models over the same starts", bind_compare,
                                     run_compare_rollouts);
  add_rollout_look_commands(noun, chosen);
  add_rollout_plot_command(noun, chosen);
  add_rollout_report_command(noun, chosen);
  add_rollout_physics_command(noun, chosen);
}

}  // namespace trocar::app
