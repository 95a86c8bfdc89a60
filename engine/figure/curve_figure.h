/// Curves over time as a figure: plots one above the other, with limits, units and one time axis; or as numbers.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/figure/print.h"
#include "engine/plot/axis.h"
#include "engine/plot/curve.h"

namespace trocar::figure {

/// A band about a curve, at the same x.
struct BandAround {
  std::string low_name;  ///< "p25": behind the name of the line, in numbers.
  std::string high_name;
  std::shared_ptr<const plot::Curve> low;
  std::shared_ptr<const plot::Curve> high;
};

/// The first line of a plot is whole, the second dashed: colour is not all that tells them apart.
struct FigureLine {
  std::string name;  ///< "Left"
  std::shared_ptr<const plot::Curve> curve;
  std::vector<BandAround> bands = {};  ///< The widest first: they lie over each other.
};

struct CurvePlot {
  std::string title;  ///< "Speed"
  std::string unit;   ///< "mm/s"
  std::vector<FigureLine> lines;
  std::vector<plot::Band> limits;
  bool from_zero = false;
};

struct CurveFigure {
  std::string title;
  std::vector<CurvePlot> plots;     ///< Where all have lines of the same names, these may stand above the first alone.
  std::string axis = "time, s";     ///< What runs to the right; with another, `begin_s` and `end_s` are in its unit …
  std::string axis_column = "t_s";  ///< … and so is the column of the CSV.
  double begin_s = 0.0;
  double end_s = 1.0;
  int width_px = 1000;         ///< At least 480.
  std::optional<Print> print;  ///< For paper: in place of `width_px`.
  Rgba ground = kPaper;        ///< Of drawings, too.
};

/// Precondition (here and below): begin_s < end_s.
Image draw_curves(const CurveFigure& figure);
/// As .svg or .pdf, by the extension of `path`. Errors: kInvalidArgument for another, kIo.
Status save_curves(const CurveFigure& figure, const std::filesystem::path& path);
/// Every sample between begin and end as a row "t_s,curve,unit,line,value" (the first: `axis_column`); the shortest
/// text that reads back as the same number, none in a gap; a band as lines "NAME p25" and "NAME p75", say. Errors: kIo.
Status save_curves_csv(const CurveFigure& figure, const std::filesystem::path& path);

}  // namespace trocar::figure
