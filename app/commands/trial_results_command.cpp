#include <fmt/format.h>

#include <cmath>

#include "app/commands/print_arguments.h"
#include "app/commands/trial_commands.h"
#include "app/lookup.h"
#include "engine/core/file.h"
#include "engine/workbench/trial_results.h"

namespace trocar::app {
namespace {

struct ResultsArguments {
  std::string project;
  std::string session;
  std::string trials;
  std::string segments;
  std::string participants;
  std::string report;
  std::string figure;
  std::string preset;
};

void bind_results(CLI::App& verb, ResultsArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("--session", arguments.session, "Only what was run in this session");
  verb.add_option("--trials", arguments.trials, "F.csv: one row for each trial");
  verb.add_option("--segments", arguments.segments, "F.csv: one row for each segment of each trial");
  verb.add_option("--participants", arguments.participants, "F.csv: one row for each participant and mode");
  verb.add_option("--report", arguments.report, "F.html: the comparison as a page");
  verb.add_option("--figure", arguments.figure,
                  "F.png, F.svg or F.pdf: bars with their spread, each pair, and each participant");
  verb.add_option("--preset", arguments.preset, kPresetHelp);
}

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json mode_json(const workbench::ModeResults& mode) {
  return {{"trials", mode.trials},
          {"succeeded", mode.succeeded},
          {"dropped", mode.dropped},
          {"placed", mode.placed},
          {"success_share", mode.success_share},
          {"success_low", mode.success.low},
          {"success_high", mode.success.high},
          {"mean_s", mode.mean_s},
          {"deviation_s", mode.deviation_s},
          {"median_s", mode.median_s},
          {"misses", mode.misses},
          {"clutches", mode.clutches},
          {"path_length_m", mode.path_m},
          {"economy", mode.economy},
          {"smoothness", mode.smoothness},
          {"agent_share", mode.agent_share}};
}

Result<Answer> run_results(const ResultsArguments& arguments, Console& console) {
  for (const auto& [file, ending] : {std::pair{arguments.trials, ".csv"}, std::pair{arguments.segments, ".csv"},
                                     std::pair{arguments.participants, ".csv"}, std::pair{arguments.report, ".html"}}) {
    if (!file.empty()) TROCAR_RETURN_IF_ERROR(check_output(file, arguments.project, {ending}));
  }
  if (!arguments.figure.empty()) {
    TROCAR_RETURN_IF_ERROR(check_output(arguments.figure, arguments.project, {".png", ".svg", ".pdf"}));
    if (!arguments.preset.empty()) TROCAR_RETURN_IF_ERROR(figure::print_from(arguments.preset).map([](const auto&) {}));
  }
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.project, console, Models::kDescribed));
  const workbench::Project& project = *file.project();
  const workbench::Trials trials = workbench::counted_trials(project, arguments.session);
  if (trials.empty()) {
    return fail(ErrorCode::kNotFound, arguments.session.empty()
                                          ? "the project has no trial that counts; trocar trial run makes them"
                                          : "no trial that counts is of session " + arguments.session);
  }
  const workbench::TrialResults results = workbench::results_of(trials);
  if (!arguments.trials.empty()) {
    TROCAR_RETURN_IF_ERROR(write_file(arguments.trials, workbench::trials_csv(project, arguments.session)));
  }
  if (!arguments.segments.empty()) {
    TROCAR_RETURN_IF_ERROR(write_file(arguments.segments, workbench::segments_csv(project, arguments.session)));
  }
  if (!arguments.participants.empty()) {
    TROCAR_RETURN_IF_ERROR(write_file(arguments.participants, workbench::participants_csv(results)));
  }
  if (!arguments.report.empty()) {
    const std::string title = arguments.session.empty() ? "Trials" : "Trials of session " + arguments.session;
    TROCAR_RETURN_IF_ERROR(write_file(arguments.report, workbench::results_html(results, title)));
  }
  if (!arguments.figure.empty()) {
    TROCAR_RETURN_IF_ERROR(workbench::write_results_figure(trials, results, arguments.preset, arguments.figure));
  }
  const workbench::PairedResults& paired = results.paired;
  Answer answer;
  answer.json = {{"operators", results.operators},
                 {"scripted", results.scripted},
                 {"MT", mode_json(results.modes[0])},
                 {"SC", mode_json(results.modes[1])},
                 {"paired",
                  {{"pairs", paired.pairs},
                   {"mean_s", paired.mean_s},
                   {"deviation_s", paired.deviation_s},
                   {"shapiro_w", number_or_null(paired.normality.w)},
                   {"shapiro_p", number_or_null(paired.normality.p)},
                   {"t", number_or_null(paired.t.t)},
                   {"t_p", number_or_null(paired.t.p)},
                   {"effect_d", number_or_null(paired.t.effect)},
                   {"wilcoxon_w", paired.signed_rank.w},
                   {"wilcoxon_p", paired.signed_rank.p},
                   {"mcnemar_p", paired.mcnemar_p}}}};
  answer.json["participants"] = Json::array();
  for (const workbench::Participant& each : results.participants) {
    answer.json["participants"].push_back(
        {{"name", each.name}, {"MT", mode_json(each.modes[0])}, {"SC", mode_json(each.modes[1])}});
  }
  const workbench::PairedResults& each = results.by_participant;
  answer.json["by_participant"] = {
      {"pairs", each.pairs},           {"mean_s", each.mean_s},           {"deviation_s", each.deviation_s},
      {"t", number_or_null(each.t.t)}, {"t_p", number_or_null(each.t.p)}, {"wilcoxon_p", each.signed_rank.p}};
  answer.summary = fmt::format("MT {} of {}, SC {} of {} succeed", results.modes[0].succeeded, results.modes[0].trials,
                               results.modes[1].succeeded, results.modes[1].trials);
  answer.text = workbench::results_text(results);
  return answer;
}

}  // namespace

void add_trial_results_command(CLI::App& noun, Action& chosen) {
  add_verb<ResultsArguments>(noun, chosen, "results", "Manual against shared control, as tables and a page",
                             bind_results, run_results);
}

}  // namespace trocar::app
