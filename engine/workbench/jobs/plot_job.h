/// Writes a plot of models and their rollouts as a figure, or the numbers of its curves, by the ending of the file.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/figure/curve_figure.h"
#include "engine/workbench/plot_settings.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

struct PlotExport {
  std::vector<std::shared_ptr<const ModelEntry>> models;  ///< At least one, each with its model.
  std::string starts = "around:3";                        ///< As `learning::read_starts`, around the first model's.
  PlotSettings settings;
  std::filesystem::path path;
};
struct PlotReport {
  std::size_t starts = 0;  ///< 0 for a map, which is of all cells, and for a learning curve.
  std::size_t listed = 0;  ///< As many rollouts of each model are drawn from, evenly over the starts.
  std::size_t epochs = 0;  ///< Of the longest learning curve.
};

/// As many models as a figure may compare.
constexpr std::size_t kMostPlotted = 6;

/// .png, .svg or .pdf; arrivals, band, boxes and learning curve also as .csv, and a map as every file of a field. The
/// same rollouts as in the window: of all starts; ways evenly over the starts if there
/// are more than `kMostListed`.
/// Threads: any. Errors: kInvalidArgument (starts, ending, preset, models without a curve, of other lattices or too
/// many), kCancelled, kIo.
Result<PlotReport> export_plot(const PlotExport& request, Progress& progress);

/// .png (with `dpi`, or that of its paper, if either is there), .svg, .pdf or .csv. Errors: those of
/// `figure::save_curves`.
Status write_curves(const figure::CurveFigure& made, const std::filesystem::path& out, std::optional<double> dpi);

/// Why such a file cannot be written of such a plot or report, in words for the user; "" if it can.
std::string reason_against_plot(PlotKind kind, const std::filesystem::path& path);

}  // namespace trocar::workbench
