#include "engine/workbench/jobs/plot_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "engine/core/ending.h"
#include "engine/core/file.h"
#include "engine/learning/start_file.h"
#include "engine/media/picture_file.h"
#include "engine/peg_board/obstacles.h"
#include "engine/workbench/insight.h"
#include "engine/workbench/jobs/field_job.h"

namespace trocar::workbench {
namespace {

using Cells = std::vector<spatial::CellIndex>;

bool is_curve(PlotKind kind) {
  return kind == PlotKind::kArrivals || kind == PlotKind::kBand || kind == PlotKind::kCurve;
}

std::shared_ptr<const plot::Curve> by_number(std::vector<double> values, int first) {
  std::vector<double> x(values.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(i) + first;
  return std::make_shared<const plot::Curve>(std::move(x), std::move(values));
}

std::vector<double> scaled(std::vector<double> values, double by) {
  for (double& value : values) value *= by;
  return values;
}

Result<std::optional<figure::Print>> print_of(const PlotSettings& settings) {
  if (settings.preset.empty()) return std::optional<figure::Print>();
  TROCAR_ASSIGN_OR_RETURN(figure::Print print, figure::print_from(settings.preset));
  print.dpi = settings.dpi.value_or(print.dpi);
  return std::optional(print);
}

std::string from_words(const PlotExport& request, std::size_t starts) {
  constexpr std::size_t kMostLetters = 40;
  std::string text = request.starts;
  if (text.size() > kMostLetters) text = text.substr(0, kMostLetters) + "…";
  return fmt::format("from {} starts ({})", starts, text);
}

figure::CurveFigure curves_on(const PlotExport& request, std::optional<figure::Print> print, std::string axis) {
  figure::CurveFigure made;
  made.width_px = request.settings.width_px;
  if (request.settings.transparent) made.ground = figure::kNoPaper;
  made.print = print;
  made.axis = axis;
  made.axis_column = std::move(axis);
  return made;
}

figure::CurveFigure arrivals_of(const PlotExport& request, const Cells& starts, std::optional<figure::Print> print) {
  figure::CurveFigure made = curves_on(request, print, "step");
  std::vector<std::vector<int>> counts;
  std::size_t longest = 2;
  for (const auto& entry : request.models) {
    const learning::Model& model = *entry->model;
    counts.push_back(learning::arrivals_by_step(learning::basin(model, learning::greedy_policy(model)), starts));
    longest = std::max(longest, counts.back().size());
  }
  figure::CurvePlot plot{"Arrived", "%", {}, {}, true};
  for (std::size_t i = 0; i < counts.size(); ++i) {
    counts[i].resize(longest, counts[i].back());
    std::vector<double> shares(counts[i].begin(), counts[i].end());
    shares = scaled(std::move(shares), 100.0 / static_cast<double>(starts.size()));
    plot.lines.push_back({request.models[i]->name, by_number(std::move(shares), 0)});
  }
  made.title = "Arrived by step, " + from_words(request, starts.size());
  made.end_s = static_cast<double>(longest - 1);
  made.plots.push_back(std::move(plot));
  return made;
}

Result<learning::RolloutSpread> spread_of(const learning::Model& model, const Cells& starts,
                                          const std::vector<double>& clearance_m, Progress& progress) {
  return learning::spread_from(model, learning::greedy_policy(model), starts, clearance_m, progress);
}

/// With the ways of those that are listed, or, for boxes, with the spread of all.
Result<std::vector<figure::DrawnRollouts>> rollouts_of(const PlotExport& request, const Cells& starts,
                                                       Progress& progress) {
  std::vector<figure::DrawnRollouts> drawn;
  for (const auto& entry : request.models) {
    const learning::Model& model = *entry->model;
    figure::DrawnRollouts of{entry->name, entry->model, nullptr, nullptr, nullptr};
    of.clearance_m = std::make_shared<const std::vector<double>>(peg_board::clearances_m(model.grid));
    if (request.settings.kind == PlotKind::kBoxes) {
      TROCAR_ASSIGN_OR_RETURN(learning::RolloutSpread spread, spread_of(model, starts, *of.clearance_m, progress));
      of.spread = std::make_shared<const learning::RolloutSpread>(std::move(spread));
    } else {
      of.rollouts = std::make_shared<const std::vector<learning::Rollout>>(
          sample_rollouts(model, learning::greedy_policy(model), starts, kMostListed));
    }
    drawn.push_back(std::move(of));
  }
  return drawn;
}

std::vector<learning::RolloutMeasure> measures_of(const PlotSettings& settings) {
  return settings.measures.empty() ? learning::spread_measures() : settings.measures;
}

Result<figure::CurveFigure> band_of(const PlotExport& request, const Cells& starts, std::optional<figure::Print> print,
                                    Progress& progress) {
  figure::CurveFigure made = curves_on(request, print, "step");
  figure::CurvePlot deviation{"Deviation from the expert", "mm", {}, {}, true};
  figure::CurvePlot going_on{"Still going on", "%", {}, {}, true};
  for (const auto& entry : request.models) {
    TROCAR_ASSIGN_OR_RETURN(const learning::RolloutSpread spread, spread_of(*entry->model, starts, {}, progress));
    const learning::DeviationBand& band = spread.band;
    if (band.median.size() < 2) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("a band needs {} rollouts of some steps, and {} has fewer",
                                                           learning::kLeastInBand, entry->name));
    }
    made.end_s = std::max(made.end_s, static_cast<double>(band.median.size() - 1));
    const auto curve = [](const std::vector<double>& values_m) { return by_number(scaled(values_m, 1e3), 0); };
    deviation.lines.push_back(
        {entry->name,
         curve(band.median),
         {{"p05", "p95", curve(band.low), curve(band.high)}, {"p25", "p75", curve(band.lower), curve(band.upper)}}});
    std::vector<double> shares(band.count.begin(), band.count.end());
    going_on.lines.push_back(
        {entry->name, by_number(scaled(std::move(shares), 100.0 / static_cast<double>(band.count.front())), 0)});
  }
  made.title = "Median, middle half and 90 %, " + from_words(request, starts.size());
  made.plots = {std::move(deviation), std::move(going_on)};
  return made;
}

Result<figure::CurveFigure> learning_curves_of(const PlotExport& request, std::optional<figure::Print> print) {
  figure::CurveFigure made = curves_on(request, print, "epoch");
  made.begin_s = 1.0;
  made.end_s = 1.0;
  figure::CurvePlot plot{"Mismatch of visits", "", {}, {}, true};
  for (const auto& entry : request.models) {
    const std::vector<double>& curve = entry->model->curve;
    if (curve.size() < 2) return fail(ErrorCode::kInvalidArgument, entry->name + " has no learning curve");
    made.end_s = std::max(made.end_s, static_cast<double>(curve.size()));
    plot.lines.push_back({entry->name, by_number(curve, 1)});
    made.title += (made.title.empty() ? "" : ", ") + entry->name;
  }
  made.plots.push_back(std::move(plot));
  return made;
}

bool any_kept(const std::vector<figure::DrawnRollouts>& models, const std::vector<learning::RolloutRange>& kept) {
  return std::any_of(models.begin(), models.end(), [&](const figure::DrawnRollouts& of) {
    return std::any_of(of.rollouts->begin(), of.rollouts->end(), [&](const learning::Rollout& rollout) {
      return learning::lies_in(rollout, kept, of.model->grid, *of.clearance_m);
    });
  });
}

std::string boxes_csv(const std::vector<figure::DrawnRollouts>& models, const PlotSettings& settings) {
  std::string csv = learning::spread_csv_header();
  for (const figure::DrawnRollouts& of : models) {
    csv += learning::spread_csv_rows(of.name, *of.spread, measures_of(settings));
  }
  return csv;
}

Status write_rollout_figure(const PlotExport& request, const Cells& starts, std::optional<figure::Print> print,
                            Progress& progress) {
  const PlotSettings& settings = request.settings;
  figure::RolloutFigure made;
  made.plot = settings.kind == PlotKind::kBoxes  ? figure::RolloutPlot::kBoxes
              : settings.kind == PlotKind::kAxes ? figure::RolloutPlot::kAxes
                                                 : figure::RolloutPlot::kMultiples;
  made.subtitle = from_words(request, starts.size());
  TROCAR_ASSIGN_OR_RETURN(made.models, rollouts_of(request, starts, progress));
  if (ending_of(request.path) == ".csv") return write_file(request.path, boxes_csv(made.models, settings));
  made.measures = settings.measures;
  if (settings.kind == PlotKind::kMultiples && !any_kept(made.models, settings.kept)) {
    return fail(ErrorCode::kInvalidArgument, "no rollout lies in what is to be kept, so that there is no picture");
  }
  made.kept = settings.kept;
  made.by = settings.by;
  made.descending = settings.descending;
  made.pictures = settings.pictures;
  made.columns = settings.columns;
  made.width_px = settings.width_px;
  if (settings.transparent) made.ground = figure::kNoPaper;
  made.print = print;
  if (ending_of(request.path) != ".png") return figure::save_rollouts(made, request.path);
  const std::optional<double> dpi = print ? std::optional(print->dpi) : settings.dpi;
  return media::write_png(request.path, figure::draw_rollouts(made), dpi);
}

Status write_map(const PlotExport& request) {
  if (request.models.size() > 2) {
    return fail(ErrorCode::kInvalidArgument, "a map is of one model, or of what two differ in");
  }
  FieldExport field;
  field.model = request.models.front();
  field.layer = learning::Layer::kBasin;
  if (request.models.size() == 2) field.against = request.models.back();
  field.contrast = FieldContrast::kOutcomes;
  field.slice = request.settings.slice;
  field.look.width_px = request.settings.width_px;
  field.look.preset = request.settings.preset;
  field.look.dpi = request.settings.dpi;
  field.look.transparent = request.settings.transparent;
  field.path = request.path;
  TROCAR_ASSIGN_OR_RETURN(const learning::Field ignored, export_field(field));
  return {};
}

Status check_models(const PlotExport& request) {
  if (request.models.size() > kMostPlotted) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("a plot is of at most {} models", kMostPlotted));
  }
  if (request.settings.kind == PlotKind::kCurve) return {};
  for (const auto& entry : request.models) {
    if (entry->model->grid != request.models.front()->model->grid) {
      return fail(ErrorCode::kInvalidArgument,
                  fmt::format("{} and {} have different lattices", request.models.front()->name, entry->name));
    }
  }
  for (const learning::RolloutMeasure measure : request.settings.measures) {
    if (learning::has_spread(measure)) continue;
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("no box is drawn of {}: it has no more and less", learning::words_of(measure).word));
  }
  return {};
}

}  // namespace

std::string reason_against_plot(PlotKind kind, const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  if (kind == PlotKind::kReport) return ending == ".html" ? "" : "A report is written as .html";
  if (ending == ".png" || ending == ".svg" || ending == ".pdf") return "";
  if (kind == PlotKind::kMap) {
    const bool numbers = ending == ".csv" || ending == ".npy" || ending == ".vti" || ending == ".h5";
    return numbers ? "" : "A map is written as .png, .svg, .pdf, .csv, .npy, .vti or .h5";
  }
  if (is_curve(kind)) return ending == ".csv" ? "" : "Such a curve is written as .png, .svg, .pdf or .csv";
  if (kind == PlotKind::kBoxes) return ending == ".csv" ? "" : "Boxes are written as .png, .svg, .pdf or .csv";
  return "Such a figure is drawn as .png, .svg or .pdf; its numbers are in the table of all rollouts";
}

Status write_curves(const figure::CurveFigure& made, const std::filesystem::path& out, std::optional<double> dpi) {
  const std::string ending = ending_of(out);
  if (ending == ".csv") return figure::save_curves_csv(made, out);
  if (ending != ".png") return figure::save_curves(made, out);
  if (!dpi && made.print) dpi = made.print->dpi;
  return media::write_png(out, figure::draw_curves(made), dpi);
}

Result<PlotReport> export_plot(const PlotExport& request, Progress& progress) {
  const PlotKind kind = request.settings.kind;
  if (std::string why = reason_against_plot(kind, request.path); !why.empty()) {
    why.front() = static_cast<char>(why.front() - 'A' + 'a');
    return tl::unexpected<Error>(Error(ErrorCode::kInvalidArgument, std::move(why)).at(request.path.string()));
  }
  TROCAR_RETURN_IF_ERROR(check_models(request));
  TROCAR_ASSIGN_OR_RETURN(const std::optional<figure::Print> print, print_of(request.settings));
  PlotReport report;
  if (kind == PlotKind::kMap) {
    TROCAR_RETURN_IF_ERROR(write_map(request));
    return report;
  }
  if (kind == PlotKind::kCurve) {
    TROCAR_ASSIGN_OR_RETURN(const figure::CurveFigure made, learning_curves_of(request, print));
    TROCAR_RETURN_IF_ERROR(write_curves(made, request.path, request.settings.dpi));
    report.epochs = static_cast<std::size_t>(made.end_s);
    return report;
  }
  TROCAR_ASSIGN_OR_RETURN(const Cells starts, learning::read_starts(request.starts, *request.models.front()->model));
  if (progress.cancelled()) return fail(ErrorCode::kCancelled, "stopped before the plot was drawn");
  report.starts = starts.size();
  const bool ways = kind == PlotKind::kAxes || kind == PlotKind::kMultiples;
  report.listed = ways ? std::min<std::size_t>(starts.size(), kMostListed) : starts.size();
  if (kind == PlotKind::kArrivals) {
    TROCAR_RETURN_IF_ERROR(write_curves(arrivals_of(request, starts, print), request.path, request.settings.dpi));
  } else if (kind == PlotKind::kBand) {
    TROCAR_ASSIGN_OR_RETURN(const figure::CurveFigure made, band_of(request, starts, print, progress));
    TROCAR_RETURN_IF_ERROR(write_curves(made, request.path, request.settings.dpi));
  } else {
    TROCAR_RETURN_IF_ERROR(write_rollout_figure(request, starts, print, progress));
  }
  return report;
}

}  // namespace trocar::workbench
