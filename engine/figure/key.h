/// What the colours and marks of a figure mean: colour bar or classes, then the marks. Private to the module.
#pragma once

#include "engine/figure/slice_panel.h"

namespace trocar::figure {

struct KeyLook {
  double unit = 1.0;      ///< Scales widths.
  double text_px = 14.0;  ///< Of the letters.
  double pen_px = 1.0;    ///< Of thin lines.
  Rgba ink = kInk;        ///< Of letters and frames.
};

struct KeyPlace {
  double x = 0.0;
  double y = 0.0;
  double height = 0.0;  ///< All that there is.
  KeyLook look;
};

void draw_key(canvas::Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options,
              const plot::Colouring& colouring, const KeyPlace& place);
/// How wide the key is, so that nothing is clipped.
double key_width(const canvas::Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options,
                 const plot::Colouring& colouring, const KeyLook& look);

}  // namespace trocar::figure
