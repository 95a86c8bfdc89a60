/// What is drawn of models and their rollouts in a file: which plot, of what, and how wide.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/figure/rollout_figure.h"
#include "engine/learning/rollout_table.h"

namespace trocar::workbench {

enum class PlotKind : std::uint8_t {
  kArrivals,   ///< Which share of the starts has arrived within so many steps.
  kBand,       ///< How far rollouts are from the expert, step by step.
  kBoxes,      ///< Where the values of each measure lie.
  kAxes,       ///< Every measure on an axis of its own.
  kMultiples,  ///< Small pictures of their ways.
  kMap,        ///< How every start ends, cell by cell.
  kCurve,      ///< How the mismatch of visits fell in training; of no starts.
  kReport,     ///< A page of outcomes, measures and figures.
};
constexpr int kPlotKinds = 8;
std::string_view to_string(PlotKind kind);  ///< "arrivals"
/// A plot of rollouts: all but `kCurve` and `kReport`. Errors: kInvalidArgument with the names that there are.
Result<PlotKind> rollout_plot_from(std::string_view text);

struct PlotSettings {
  PlotKind kind = PlotKind::kArrivals;
  std::vector<learning::RolloutMeasure> measures;                         ///< Of boxes; none: all.
  std::vector<learning::RolloutRange> kept;                               ///< Of axes and small pictures.
  learning::RolloutMeasure by = learning::RolloutMeasure::kMaxDeviation;  ///< Order of small pictures.
  bool descending = true;
  int pictures = 24;  ///< Small ones, of each model.
  int columns = 4;
  std::string slice;          ///< Of the map: "z=11"; empty: all.
  int width_px = 1000;        ///< Without a preset.
  std::string preset;         ///< As `figure::print_from`; empty: for a screen.
  std::optional<double> dpi;  ///< Of a picture: what it says of itself and, with a preset, its pixels.
  bool transparent = false;   ///< Without the white ground.
  bool operator==(const PlotSettings&) const = default;
};

/// "max_deviation:10..25.5": in the unit of the measure.
std::string kept_text(const learning::RolloutRange& range);
/// Errors: kInvalidArgument.
Result<learning::RolloutRange> kept_from(std::string_view text);

}  // namespace trocar::workbench
