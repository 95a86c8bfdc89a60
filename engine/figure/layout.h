/// How a figure is laid out on its canvas. Private to the module.
#pragma once

#include "engine/figure/field_figure.h"

namespace trocar::figure {

/// Em sizes in pixels; all the same for print.
struct Letters {
  double title = 24.0;
  double text = 15.0;
  double tick = 14.0;     ///< And of the key.
  double heading = 13.0;  ///< Over the panels of a montage; a little less where that lets the height stand beside it.
  double small_heading = 11.5;
};

struct HeadLine {
  std::string text;
  bool quiet = false;
};

/// Sizes in whole pixels, so that the same cells are equally wide everywhere.
struct Layout {
  double unit = 1.0;    ///< 1 at a width of 1000 pixels, and at letters of 15 pixels for print.
  double pen_px = 1.0;  ///< Of thin lines.
  double pt_per_px = 0.75;
  Letters letters;
  double margin = 0.0;
  std::vector<HeadLine> head;  ///< Below the title.
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

/// Of a picture with the resolution of `options.print`, or of a drawing.
enum class Medium { kPicture, kDrawing };
Layout layout_of(const learning::Field& field, const FieldFigureOptions& options, const plot::Colouring& colouring,
                 Medium medium = Medium::kPicture);
void draw_figure(canvas::Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options,
                 const plot::Colouring& colouring, const Layout& layout);

}  // namespace trocar::figure
