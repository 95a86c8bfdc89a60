/// How a figure is laid out on its canvas. Private to the module.
#pragma once

#include "engine/figure/field_figure.h"

namespace trocar::figure {

/// Sizes in whole pixels, so that the same cells are equally wide everywhere.
struct Layout {
  double unit = 1.0;  ///< 1 at a width of 1000 pixels.
  int width = 0;
  int height = 0;
  int left = 0;  ///< Of the first panel.
  int top = 0;
  int columns = 1;
  int rows = 1;
  int panels = 1;
  int cell_px = 1;
  int panel_px = 0;
  int gap_x = 0;
  int gap_y = 0;
  int key_x = 0;
};

Layout layout_of(const learning::Field& field, const FieldFigureOptions& options, const plot::Colouring& colouring);
void draw_figure(canvas::Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options,
                 const plot::Colouring& colouring, const Layout& layout);

}  // namespace trocar::figure
