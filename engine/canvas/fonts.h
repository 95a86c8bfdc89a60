/// The faces that text is drawn with: Inter, and DejaVu Sans for what Inter has not. Private to the module.
#pragma once

#include <cairo.h>

#include <string>
#include <string_view>
#include <vector>

#include "engine/canvas/canvas.h"

namespace trocar::canvas {

/// Part of a text that one face can show.
struct FontRun {
  cairo_font_face_t* face = nullptr;  ///< Lives as long as the program.
  std::string utf8;
};

/// Bytes that are no UTF-8 become U+FFFD. Threads: any.
std::vector<FontRun> font_runs(std::string_view utf8, Weight weight);

}  // namespace trocar::canvas
