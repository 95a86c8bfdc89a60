#include <fmt/format.h>

#include "app/commands/model_study_commands.h"
#include "app/commands/print_arguments.h"
#include "app/lookup.h"
#include "app/options.h"
#include "engine/workbench/jobs/plot_job.h"

namespace trocar::app {
namespace {

struct CurveArguments {
  std::string project;
  std::vector<std::string> models;
  PrintArguments print;
};

void bind_curve(CLI::App& verb, CurveArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("MODEL", arguments.models, "One or two, by id or name")->required()->expected(1, 2);
  bind_print(verb, arguments.print, "F.png, F.svg, F.pdf, or F.csv for the numbers");
}

Result<Answer> run_curve(const CurveArguments& arguments, Console& console) {
  const std::string& out = arguments.print.out;
  TROCAR_RETURN_IF_ERROR(check_output(out, arguments.project, {".png", ".svg", ".pdf", ".csv"}));
  TROCAR_RETURN_IF_ERROR(check_dpi(arguments.print.dpi, out));
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file, open_to_read(arguments.project, console, Models::kWhole));
  workbench::PlotExport request;
  std::string names;
  for (const std::string& name : arguments.models) {
    TROCAR_ASSIGN_OR_RETURN(const auto entry, find_model(*file.project(), name));
    request.models.push_back(entry);
    names += (names.empty() ? "" : ", ") + entry->name;
  }
  request.settings.kind = workbench::PlotKind::kCurve;
  request.settings.width_px = arguments.print.width;
  request.settings.preset = arguments.print.preset;
  request.settings.dpi = arguments.print.said_dpi();
  request.settings.transparent = arguments.print.transparent;
  request.path = out;
  TROCAR_ASSIGN_OR_RETURN(const workbench::PlotReport report, workbench::export_plot(request, console.progress()));
  Answer answer;
  answer.json = {{"out", out}, {"epochs", report.epochs}};
  answer.summary = fmt::format("learning curve of {} over {} epochs", names, report.epochs);
  answer.text = fmt::format("Wrote {}: {}", out, answer.summary);
  return answer;
}

}  // namespace

void add_model_curve_command(CLI::App& noun, Action& chosen) {
  add_verb<CurveArguments>(noun, chosen, "curve", "Draw how the mismatch of visits fell in training", bind_curve,
                           run_curve);
}

}  // namespace trocar::app
