/// How large letters and lines of a figure are, on a screen or on paper. Private to the module.
#pragma once

#include <optional>

#include "engine/canvas/canvas.h"
#include "engine/figure/print.h"

namespace trocar::figure {

/// Lengths in pixels of the canvas.
struct Sheet {
  double width = 1000.0;
  double em = 13.0;  ///< Size of all letters.
  double pen = 1.0;  ///< Of thin lines.
  double pt_per_px = 0.75;

  canvas::TextStyle letters(canvas::Align align = canvas::Align::kLeft,
                            canvas::Weight weight = canvas::Weight::kRegular) const;
};

constexpr int kLeastSheet_px = 480;
/// For paper `dpi` says how many pixels there are; else `width_px`, at least `kLeastSheet_px`.
Sheet sheet_of(const std::optional<Print>& print, int width_px, double dpi);

}  // namespace trocar::figure
