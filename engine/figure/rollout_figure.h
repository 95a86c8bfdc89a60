/// Rollouts as figures: boxes of their measures, every measure on an axis of its own, and small pictures of their ways.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/figure/print.h"
#include "engine/learning/model.h"
#include "engine/learning/rollout_spread.h"

namespace trocar::figure {

enum class RolloutPlot {
  kBoxes,      ///< Of each measure: the middle half, the middle one and all, by model and end, with points.
  kAxes,       ///< Each rollout a line across the axes of all measures.
  kMultiples,  ///< Side views of the first in the order of a measure, y to the right and z up.
};

/// The rollouts of one model.
struct DrawnRollouts {
  std::string name;  ///< Of the model.
  std::shared_ptr<const learning::Model> model;
  std::shared_ptr<const std::vector<learning::Rollout>> rollouts;
  std::shared_ptr<const std::vector<double>> clearance_m;  ///< By CellIndex; null: not known.
  std::shared_ptr<const learning::RolloutSpread> spread;   ///< For boxes, which are drawn of it alone.
};

struct RolloutFigure {
  RolloutPlot plot = RolloutPlot::kBoxes;
  std::string subtitle;                            ///< From where they start, say.
  std::vector<DrawnRollouts> models;               ///< At least one.
  std::vector<learning::RolloutMeasure> measures;  ///< Of boxes; none: all that have more and less.
  std::vector<learning::RolloutRange> kept;        ///< Others are grey on axes, and no small pictures.
  learning::RolloutMeasure by = learning::RolloutMeasure::kMaxDeviation;  ///< Small pictures are in its order.
  bool descending = true;
  int pictures = 24;           ///< Of each model, at most.
  int columns = 4;             ///< Of pictures; fewer where they would be too small.
  int width_px = 1000;         ///< At least 480.
  std::optional<Print> print;  ///< For paper: in place of `width_px`.
  Rgba ground = kPaper;        ///< Of drawings, too.
};

/// Precondition (here and below): a model at least, and `learning::has_spread` of each of `measures`.
Image draw_rollouts(const RolloutFigure& figure);
/// As .svg or .pdf, by the ending of `path`. Errors: kInvalidArgument for another, kIo.
Status save_rollouts(const RolloutFigure& figure, const std::filesystem::path& path);

}  // namespace trocar::figure
