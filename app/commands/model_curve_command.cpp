#include <fmt/format.h>

#include <algorithm>

#include "app/commands/curve_file.h"
#include "app/commands/model_study_commands.h"
#include "app/commands/print_arguments.h"
#include "app/lookup.h"
#include "app/options.h"

namespace trocar::app {
namespace {

struct CurveArguments {
  std::string project;
  std::vector<std::string> models;
  int width = 1000;
  std::string preset;
  double dpi = 0.0;
  std::string out;
};

void bind_curve(CLI::App& verb, CurveArguments& arguments) {
  verb.add_option("PROJECT", arguments.project, "The project file")->required();
  verb.add_option("MODEL", arguments.models, "One or two, by id or name")->required()->expected(1, 2);
  verb.add_option("--width", arguments.width, "Of the figure, in pixels")
      ->check(CLI::Range(480, 8000))
      ->capture_default_str();
  verb.add_option("--preset", arguments.preset, kPresetHelp)->excludes("--width");
  verb.add_option("--dpi", arguments.dpi, kDpiHelp)->check(CLI::Range(kLeastDpi, kMostDpi));
  verb.add_option("--out", arguments.out, "F.png, F.svg, F.pdf, or F.csv for the numbers")->required();
}

Result<figure::CurveFigure> figure_of(const CurveArguments& arguments, const workbench::Project& project) {
  figure::CurveFigure made;
  made.width_px = arguments.width;
  made.axis = "epoch";
  made.axis_column = "epoch";
  made.begin_s = 1.0;
  made.end_s = 1.0;
  if (!arguments.preset.empty()) {
    TROCAR_ASSIGN_OR_RETURN(made.print, figure::print_from(arguments.preset));
    if (arguments.dpi > 0.0) made.print->dpi = arguments.dpi;
  }
  figure::CurvePlot plot{"Mismatch of visits", "", {}, {}, true};
  for (const std::string& name : arguments.models) {
    TROCAR_ASSIGN_OR_RETURN(const auto entry, find_model(project, name));
    const std::vector<double>& curve = entry->model->curve;
    if (curve.size() < 2) return fail(ErrorCode::kInvalidArgument, entry->name + " has no learning curve");
    std::vector<double> epochs(curve.size());
    for (std::size_t i = 0; i < epochs.size(); ++i) epochs[i] = static_cast<double>(i + 1);
    made.end_s = std::max(made.end_s, epochs.back());
    plot.lines.push_back({entry->name, std::make_shared<const plot::Curve>(std::move(epochs), curve)});
    made.title += (made.title.empty() ? "" : ", ") + entry->name;
  }
  made.plots.push_back(std::move(plot));
  return made;
}

Result<Answer> run_curve(const CurveArguments& arguments, Console& console) {
  TROCAR_RETURN_IF_ERROR(check_output(arguments.out, arguments.project, {".png", ".svg", ".pdf", ".csv"}));
  TROCAR_RETURN_IF_ERROR(check_dpi(arguments.dpi, arguments.out));
  TROCAR_ASSIGN_OR_RETURN(const workbench::ProjectFile file, open_to_read(arguments.project, console, Models::kWhole));
  TROCAR_ASSIGN_OR_RETURN(const figure::CurveFigure made, figure_of(arguments, *file.project()));
  TROCAR_RETURN_IF_ERROR(write_curves(made, arguments.out, arguments.dpi));
  Answer answer;
  answer.json = {{"out", arguments.out}, {"epochs", made.end_s}};
  answer.summary = fmt::format("learning curve of {} over {:.0f} epochs", made.title, made.end_s);
  answer.text = fmt::format("Wrote {}: {}", arguments.out, answer.summary);
  return answer;
}

}  // namespace

void add_model_curve_command(CLI::App& noun, Action& chosen) {
  add_verb<CurveArguments>(noun, chosen, "curve", "Draw how the mismatch of visits fell in training", bind_curve,
                           run_curve);
}

}  // namespace trocar::app
