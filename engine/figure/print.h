/// Figures for print: a width and letters in lengths of paper, which every resolution keeps.
#pragma once

#include <string_view>

#include "engine/core/image.h"
#include "engine/core/result.h"

namespace trocar::figure {

struct Print {
  double width_mm = 88.0;
  double text_pt = 8.0;  ///< Em size of every letter, in points of 1/72 inch.
  double dpi = 300.0;    ///< Of a picture; drawings have none.
};
/// "column": one of two columns, 88 mm; "page": across both, 180 mm; letters of 8 pt.
/// Errors: kInvalidArgument with the names that there are.
Result<Print> print_from(std::string_view preset);

/// What a figure is drawn on: white, or nothing, so that it can be laid over what there is.
constexpr Rgba kPaper{255, 255, 255, 255};
constexpr Rgba kNoPaper{255, 255, 255, 0};

constexpr double kDrawingDpi = 2540.0;  ///< What a drawing for print is laid out with: hundredths of a millimetre.
constexpr double kScreenDpi = 96.0;     ///< What a pixel is on paper where nothing else is said.
/// How wide a pixel is, in points.
double pt_per_px(double dpi);
double px_per_mm(double dpi);

}  // namespace trocar::figure
