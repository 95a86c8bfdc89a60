/// From a value of a field to its colour, the same in the window, the 3-D view and figures.
#pragma once

#include <vector>

#include "engine/plot/colour_map.h"
#include "engine/plot/colour_vision.h"

namespace trocar::plot {

struct Colouring {
  ColourMap map = ColourMap::kViridis;
  Scale scale;                                ///< One for the whole field, so that slices can be compared.
  ColourVision vision = ColourVision::kFull;  ///< The colours as this reader sees them.
  std::vector<Rgba> categories;               ///< Not empty: values are class numbers.

  /// Alpha 0 for a value that is not finite, or a class without a name.
  Rgba colour(double value) const;
  /// Of the map, at `position` from 0 to 1 on the scale.
  Rgba colour_at(double position) const;
};

}  // namespace trocar::plot
