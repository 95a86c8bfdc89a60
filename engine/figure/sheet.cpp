#include "engine/figure/sheet.h"

#include <algorithm>
#include <cmath>

#include "engine/figure/slice_panel.h"

namespace trocar::figure {

canvas::TextStyle Sheet::letters(canvas::Align align, canvas::Weight weight) const {
  return {em, weight, kInk, align};
}

Sheet sheet_of(const std::optional<Print>& print, int width_px, double dpi) {
  constexpr double kPen_pt = 0.5;
  Sheet sheet;
  if (!print) {
    sheet.width = std::max(width_px, kLeastSheet_px);
    sheet.em = std::max(11.0, 13.0 * sheet.width / 1000.0);
    sheet.pen = std::max(1.0, sheet.width / 1000.0);
    return sheet;
  }
  sheet.pt_per_px = pt_per_px(dpi);
  sheet.width = std::round(print->width_mm * px_per_mm(dpi));
  sheet.em = print->text_pt / sheet.pt_per_px;
  sheet.pen = kPen_pt / sheet.pt_per_px;
  return sheet;
}

}  // namespace trocar::figure
