/// Texts made to fit a width. Private to the module.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/canvas/canvas.h"

namespace trocar::figure {

/// Shortened from the end until it fits.
std::string fitted(const canvas::Canvas& canvas, std::string text, const canvas::TextStyle& letters, double width);
/// Cut at blanks to lines that fit; a word that does not is shortened.
std::vector<std::string> wrapped(const canvas::Canvas& canvas, std::string_view text, const canvas::TextStyle& letters,
                                 double width);

}  // namespace trocar::figure
