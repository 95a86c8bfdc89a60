#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/commands/demo_commands.h"
#include "app/commands/print_arguments.h"
#include "engine/figure/curve_figure.h"
#include "engine/workbench/curves.h"
#include "engine/workbench/jobs/plot_job.h"

namespace trocar::app {
namespace {

using demonstration::CurveKind;

struct PlotArguments {
  std::string project;
  std::string demonstration;
  std::vector<std::string> curves{"speed", "jerk"};
  std::string arm = "both";
  double from_s = -1.0;
  double to_s = -1.0;
  PrintArguments print;
};

void bind_plot(CLI::App& verb, PlotArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("DEMO", arguments.demonstration, "Its id or name")->required();
  verb.add_option("--curve", arguments.curves,
                  "x, y, z, speed, acceleration, jerk, jaw, clearance: one or more, with commas")
      ->delimiter(',')
      ->capture_default_str();
  verb.add_option("--arm", arguments.arm, "left, right or both")
      ->check(CLI::IsMember({"left", "right", "both"}))
      ->capture_default_str();
  verb.add_option("--from", arguments.from_s, "Begin in seconds (else the begin gate)")->check(CLI::NonNegativeNumber);
  verb.add_option("--to", arguments.to_s, "End in seconds (else the end gate)")->check(CLI::NonNegativeNumber);
  bind_print(verb, arguments.print, "F.png, F.svg, F.pdf, or F.csv for the numbers");
}

Result<figure::CurveFigure> figure_of(const PlotArguments& arguments, const demonstration::Demonstration& shown) {
  figure::CurveFigure made;
  made.title = shown.name;
  made.begin_s = arguments.from_s >= 0.0 ? arguments.from_s : shown.begin_s;
  made.end_s = arguments.to_s >= 0.0 ? arguments.to_s : shown.end_s;
  made.width_px = arguments.print.width;
  TROCAR_ASSIGN_OR_RETURN(made.print, print_of(arguments.print));
  if (arguments.print.transparent) made.ground = figure::kNoPaper;
  if (!(made.begin_s < made.end_s)) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("from {:.3f} to {:.3f} s there is nothing to plot", made.begin_s, made.end_s));
  }
  review::ClearanceMaker clearance;
  for (const std::string& name : arguments.curves) {
    TROCAR_ASSIGN_OR_RETURN(const CurveKind kind, demonstration::curve_kind_from(name));
    const workbench::CurveLook& look = workbench::look_of(kind);
    figure::CurvePlot drawn{
        std::string(look.title), std::string(look.unit), {}, workbench::limits_of(kind), look.from_zero};
    for (int arm = 0; arm < 2; ++arm) {
      if (arguments.arm == (arm == 0 ? "right" : "left")) continue;
      auto curve = kind == CurveKind::kClearance ? workbench::plotted_clearance(shown, arm, clearance)
                                                 : workbench::plotted(shown.samples, shown.first_tick(), kind, arm);
      drawn.lines.push_back({std::string(workbench::arm_title(arm)), std::move(curve)});
    }
    made.plots.push_back(std::move(drawn));
  }
  return made;
}

/// The least and greatest of each line, so that the answer says something that can be checked.
Json ranges_of(const figure::CurveFigure& made) {
  Json ranges = Json::array();
  for (const figure::CurvePlot& each : made.plots) {
    for (const figure::FigureLine& line : each.lines) {
      const std::optional<plot::Extent> extent = line.curve->extent(made.begin_s, made.end_s);
      Json range{{"curve", each.title}, {"unit", each.unit}, {"arm", line.name}, {"low", nullptr}, {"high", nullptr}};
      if (extent) range["low"] = extent->low;
      if (extent) range["high"] = extent->high;
      ranges.push_back(std::move(range));
    }
  }
  return ranges;
}

Result<Answer> run_plot(const PlotArguments& arguments, Console& console) {
  const std::filesystem::path out = arguments.print.out;
  TROCAR_RETURN_IF_ERROR(check_output(out, arguments.project, {".png", ".svg", ".pdf", ".csv"}));
  TROCAR_RETURN_IF_ERROR(check_dpi(arguments.print.dpi, out));
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file,
                          open_to_read(arguments.project, console, Models::kDescribed));
  TROCAR_ASSIGN_OR_RETURN(const auto shown, find_demonstration(*file.project(), arguments.demonstration));
  TROCAR_ASSIGN_OR_RETURN(const figure::CurveFigure made, figure_of(arguments, *shown));
  TROCAR_RETURN_IF_ERROR(console.check_not_cancelled());
  TROCAR_RETURN_IF_ERROR(workbench::write_curves(made, out, arguments.print.said_dpi()));
  std::error_code ignored;
  Answer answer;
  answer.json = {{"id", shown->id.value},     {"out", arguments.print.out},
                 {"begin_s", made.begin_s},   {"end_s", made.end_s},
                 {"curves", ranges_of(made)}, {"size_bytes", std::filesystem::file_size(out, ignored)}};
  answer.summary = fmt::format("{} of {}", counted(made.plots.size(), "plot"), shown->name);
  answer.text = fmt::format("Wrote {}: {}", arguments.print.out, answer.summary);
  return answer;
}

}  // namespace

void add_demo_plot_command(CLI::App& noun, Action& chosen) {
  add_verb<PlotArguments>(noun, chosen, "plot", "Draw position, speed, acceleration, jerk, jaw or clearance over time",
                          bind_plot, run_plot);
}

}  // namespace trocar::app
