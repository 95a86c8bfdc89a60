/// One slice on a canvas: cells, hatched unknowns, the safe set's outline, the expert's cells. Private to the module.
#pragma once

#include "engine/figure/field_figure.h"
#include "engine/figure/print.h"
#include "engine/figure/slice_geometry.h"

namespace trocar::figure {

// Ink for letters and frames, and the quieter one for what is beside the point.
constexpr Rgba kInk{28, 30, 34, 255};
constexpr Rgba kQuiet{96, 101, 109, 255};
constexpr Rgba kHatchGround{247, 247, 248, 255};
constexpr Rgba kHatchInk{172, 177, 185, 255};

/// Where a panel lies: its top left corner and the width of a cell, in pixels; and how wide thin lines are.
struct PanelPlace {
  double x = 0.0;
  double y = 0.0;
  double cell_px = 1.0;
  double pen_px = 1.0;
};

void draw_panel(canvas::Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options,
                const plot::Colouring& colouring, const Slice& slice, const PanelPlace& place);
/// The marks as `draw_panel` draws them, for the legend.
void draw_path_mark(canvas::Canvas& canvas, canvas::Point centre, double radius, double pen);
void draw_start_mark(canvas::Canvas& canvas, canvas::Point centre, double radius, double pen);
void draw_goal_mark(canvas::Canvas& canvas, canvas::Point centre, double radius, double pen);
void draw_safe_line(canvas::Canvas& canvas, canvas::Point a, canvas::Point b, double width);

}  // namespace trocar::figure
