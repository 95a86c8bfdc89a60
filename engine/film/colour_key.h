/// What the colours of a field in a film's scene mean. Private to the module but for the value.
#pragma once

#include <string>
#include <vector>

#include "engine/core/image.h"

namespace trocar::film {

/// A bar from the lowest to the highest value, or classes by name.
struct ColourKey {
  std::vector<Rgba> colours;       ///< Of a bar from low to high, at least 2; else one for each class.
  std::vector<std::string> words;  ///< Of a bar what its ends mean, low and high; else the classes' names.
  bool classes = false;
};

/// On dark glass with its upper right corner there, or its upper left one, in pixels; `unit` is the length of what is 1
/// at a height of 720. What does not fit into the frame is cut.
void draw_colour_key(Image& frame, const ColourKey& key, double x, double top, double unit, bool from_right);

}  // namespace trocar::film
