/// A line plot over time: axes with units, limits, marked spans, the playhead, and every line's value at the cursor.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/plot/axis.h"
#include "engine/plot/curve.h"
#include "ui/widgets/widgets.h"

namespace trocar::ui {

/// Lines differ in more than colour: dashes, and the mark at the cursor.
enum class LineStyle {
  kSolid,   ///< A disc at the cursor.
  kDashed,  ///< A square at the cursor.
  kGhost,   ///< Thin, no mark: what was.
};

struct PlotLine {
  std::string name;                    ///< "Left"
  const plot::Curve* curve = nullptr;  ///< Not null; outlives the frame.
  Rgba colour;
  LineStyle style = LineStyle::kSolid;
};

/// A stretch of time that is marked, as for a problem.
struct PlotSpan {
  double begin_s = 0.0;
  double end_s = 0.0;
  Rgba colour;
  std::string words;  ///< In the status line while the cursor is in it.
};

struct PlotSpec {
  std::string_view label;  ///< "Speed"
  std::string_view unit;   ///< "mm/s"
  std::span<const PlotLine> lines;
  std::span<const plot::Band> limits;  ///< What lies outside of all of them is shaded.
  std::span<const PlotSpan> spans;
  plot::Extent values;  ///< Ends of the value axis.
  double begin_s = 0.0;
  double end_s = 1.0;  ///< The time that is shown.
  double gate_in_s = 0.0;
  double gate_out_s = 1.0;  ///< What is not between the gates is veiled.
  double playhead_s = 0.0;
  std::optional<double> cursor_s;  ///< Where values are read; none: at the playhead.
  bool time_axis = true;           ///< The times are written below.
  float height = 120.0F;           ///< Pixels, of all of it.
};

struct PlotActs {
  std::optional<double> seek_s;    ///< Clicked or dragged to.
  std::optional<double> cursor_s;  ///< Under the pointer.
  double zoom = 1.0;               ///< Wheel or up and down arrows; < 1 shows less.
  double zoom_at_s = 0.0;
  double pan_s = 0.0;
};

/// As wide as what is left of the region. Its item has the role "plot" and the values at the cursor as its value; with
/// the keyboard on it the up and down arrows zoom at the playhead.
PlotActs plot(Ui& ui, const PlotSpec& spec);

/// The least height with which all of it can be read.
float least_plot_height(const Ui& ui, bool time_axis);

/// Of an arm, 0 left, 1 right; on the theme's panel a contrast of at least 4.5:1.
Rgba arm_colour(const Theme& theme, int arm);

}  // namespace trocar::ui
