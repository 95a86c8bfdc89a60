/// Strokes of a line plot: whole and dashed lines through many points, and marks on them. Private to the widgets.
#pragma once

#include <imgui.h>

#include <vector>

#include "ui/widgets/plot.h"

namespace trocar::ui {

/// Where a plot's values and times are on the screen.
struct PlotArea {
  Rect rect;
  double begin_s = 0.0;
  double end_s = 1.0;
  plot::Extent values;

  float x_of(double t_s) const {
    return rect.x0 + static_cast<float>((t_s - begin_s) / (end_s - begin_s)) * rect.width();
  }
  float y_of(double value) const {
    return rect.y1 - static_cast<float>((value - values.low) / (values.high - values.low)) * rect.height();
  }
  double time_at(float x) const {
    return begin_s + (end_s - begin_s) * static_cast<double>((x - rect.x0) / rect.width());
  }
};

void draw_line(const Ui& ui, const PlotArea& area, const PlotLine& line);
/// A short piece of the line, from (x0, y) to (x1, y): for the legend.
void draw_sample(const Ui& ui, const PlotLine& line, float x0, float x1, float y);
/// The line's mark at a point.
void draw_mark(const Ui& ui, const PlotLine& line, ImVec2 at);
/// Dashes between two points.
void draw_dashes(const Ui& ui, ImVec2 from, ImVec2 to, ImU32 colour, float width);

}  // namespace trocar::ui
