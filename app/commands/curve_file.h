/// Curves as the file that a command was asked for.
#pragma once

#include <filesystem>

#include "engine/figure/curve_figure.h"

namespace trocar::app {

/// .png (with `dpi`, or that of its paper, if either is there), .svg, .pdf or .csv. Errors: those of
/// `figure::save_curves`.
Status write_curves(const figure::CurveFigure& made, const std::filesystem::path& out, double dpi);

}  // namespace trocar::app
