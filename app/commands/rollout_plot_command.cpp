#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/commands/print_arguments.h"
#include "app/commands/rollout_commands.h"
#include "app/lookup.h"
#include "engine/workbench/jobs/plot_job.h"

namespace trocar::app {
namespace {

using workbench::PlotKind;

struct RolloutPlotArguments {
  std::string project;
  std::vector<std::string> models;
  std::string starts = "around:3";
  std::string kind;
  std::vector<std::string> measures;
  std::vector<std::string> kept;
  std::string by = "max_deviation";
  bool ascending = false;
  int pictures = 24;
  int columns = 0;  ///< 0: what suits the width.
  std::string slice;
  PrintArguments print;
  CLI::Option* starts_option = nullptr;
  /// Each with the kinds that heed it.
  std::vector<std::pair<const CLI::Option*, std::vector<PlotKind>>> of_kinds;
};

void bind_rollout_plot(CLI::App& verb, RolloutPlotArguments& arguments) {
  std::string words;
  for (int i = 0; i < learning::kRolloutMeasures; ++i) {
    const auto measure = static_cast<learning::RolloutMeasure>(i);
    words += (i == 0 ? "" : ", ") + std::string(learning::words_of(measure).word);
  }
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("MODEL", arguments.models, "One or more, by id or name")
      ->required()
      ->expected(1, static_cast<int>(workbench::kMostPlotted));
  verb.add_option(
          "--kind", arguments.kind,
          "arrivals (by step), band (of deviations), boxes (of each measure), axes (every measure on one of its "
          "own), multiples (small pictures) or map (how every cell's rollout ends)")
      ->required();
  arguments.starts_option = verb.add_option("--starts", arguments.starts, starts_help())->capture_default_str();
  const auto of = [&arguments](const CLI::Option* option, std::vector<PlotKind> kinds) {
    arguments.of_kinds.emplace_back(option, std::move(kinds));
  };
  of(arguments.starts_option,
     {PlotKind::kArrivals, PlotKind::kBand, PlotKind::kBoxes, PlotKind::kAxes, PlotKind::kMultiples});
  of(verb.add_option("--measure", arguments.measures, "Of boxes, with commas (else all): of " + words)->delimiter(','),
     {PlotKind::kBoxes});
  of(verb.add_option("--keep", arguments.kept,
                     "MEASURE:LOW..HIGH in its unit: other rollouts are grey on axes, and no small pictures"),
     {PlotKind::kAxes, PlotKind::kMultiples});
  of(verb.add_option("--sort", arguments.by, "Small pictures in the order of this measure")->capture_default_str(),
     {PlotKind::kMultiples});
  of(verb.add_flag("--ascending", arguments.ascending, "The smallest first"), {PlotKind::kMultiples});
  of(verb.add_option("--pictures", arguments.pictures, "Small pictures of each model")
         ->check(CLI::Range(1, 400))
         ->capture_default_str(),
     {PlotKind::kMultiples});
  of(verb.add_option("--columns", arguments.columns, "Small pictures side by side (else 4 in a column, 8 on a page)")
         ->check(CLI::Range(1, 20)),
     {PlotKind::kMultiples});
  of(verb.add_option("--slice", arguments.slice, "Of the map: x=I, y=J or z=K (else all along z)"), {PlotKind::kMap});
  bind_print(verb, arguments.print,
             "F.png, F.svg or F.pdf; arrivals, band and boxes also F.csv, a map every file of `field export`");
}

/// Errors: kInvalidArgument for an option that would be ignored.
Status check_heeded_by(const RolloutPlotArguments& arguments, PlotKind kind) {
  for (const auto& [option, kinds] : arguments.of_kinds) {
    if (option->count() == 0 || std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) continue;
    return fail(
        ErrorCode::kInvalidArgument,
        fmt::format("{} is not for --kind {}{}", option->get_name(), workbench::to_string(kind),
                    kind == PlotKind::kMap && option->get_name() == "--starts" ? ": a map shows all cells" : ""));
  }
  return {};
}

Result<workbench::PlotSettings> plot_settings_of(const RolloutPlotArguments& arguments) {
  workbench::PlotSettings settings;
  TROCAR_ASSIGN_OR_RETURN(settings.kind, workbench::rollout_plot_from(arguments.kind));
  TROCAR_RETURN_IF_ERROR(check_heeded_by(arguments, settings.kind));
  for (const std::string& word : arguments.measures) {
    TROCAR_ASSIGN_OR_RETURN(const learning::RolloutMeasure measure, learning::rollout_measure_from(word));
    settings.measures.push_back(measure);
  }
  for (const std::string& text : arguments.kept) {
    TROCAR_ASSIGN_OR_RETURN(const learning::RolloutRange range, workbench::kept_from(text));
    settings.kept.push_back(range);
  }
  TROCAR_ASSIGN_OR_RETURN(settings.by, learning::rollout_measure_from(arguments.by));
  settings.descending = !arguments.ascending;
  settings.pictures = arguments.pictures;
  settings.columns = arguments.columns;
  settings.slice = arguments.slice;
  settings.width_px = arguments.print.width;
  settings.preset = arguments.print.preset;
  settings.dpi = arguments.print.said_dpi();
  settings.transparent = arguments.print.transparent;
  return settings;
}

Result<Answer> run_rollout_plot(const RolloutPlotArguments& arguments, Console& console) {
  workbench::PlotExport request;
  TROCAR_ASSIGN_OR_RETURN(request.settings, plot_settings_of(arguments));
  const std::string& out = arguments.print.out;
  TROCAR_RETURN_IF_ERROR(check_output(out, arguments.project, {}));
  if (!arguments.print.preset.empty()) TROCAR_RETURN_IF_ERROR(figure::print_from(arguments.print.preset));
  TROCAR_RETURN_IF_ERROR(check_dpi(arguments.print.dpi, out));
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file, open_to_read(arguments.project, console, Models::kWhole));
  Answer answer;
  answer.json["models"] = Json::array();
  std::string names;
  TROCAR_ASSIGN_OR_RETURN(request.models, find_drawn_models(*file.project(), arguments.models, console));
  for (const auto& entry : request.models) {
    answer.json["models"].push_back(entry->id.value);
    names += (names.empty() ? "" : ", ") + entry->name;
  }
  request.starts = arguments.starts;
  request.path = out;
  TROCAR_ASSIGN_OR_RETURN(const workbench::PlotReport report, workbench::export_plot(request, console.progress()));
  std::error_code ignored;
  answer.json["kind"] = workbench::to_string(request.settings.kind);
  answer.json["starts"] = report.starts;
  answer.json["listed"] = report.listed;
  answer.json["out"] = out;
  answer.json["size_bytes"] = std::filesystem::file_size(out, ignored);
  answer.summary = fmt::format("{} of {}", workbench::to_string(request.settings.kind), names);
  if (report.starts > 0) answer.summary += fmt::format(" from {} starts", report.starts);
  if (report.listed < report.starts) answer.summary += fmt::format(", {} of them, evenly", report.listed);
  answer.text = fmt::format("Wrote {}: {}", out, answer.summary);
  return answer;
}

}  // namespace

Result<std::vector<std::shared_ptr<const workbench::ModelEntry>>> find_drawn_models(
    const workbench::Project& project, const std::vector<std::string>& names, Console& console) {
  std::vector<std::shared_ptr<const workbench::ModelEntry>> models;
  for (const std::string& name : names) {
    TROCAR_ASSIGN_OR_RETURN(const auto entry, find_model(project, name));
    warn_if_stale(project, *entry, console);
    if (!models.empty()) warn_if_unlike(*models.front(), *entry, console);
    models.push_back(entry);
  }
  return models;
}

void add_rollout_plot_command(CLI::App& noun, Action& chosen) {
  add_verb<RolloutPlotArguments>(noun, chosen, "plot", "Draw arrivals, deviations, measures, ways or a map of rollouts",
                                 bind_rollout_plot, run_rollout_plot);
}

}  // namespace trocar::app
