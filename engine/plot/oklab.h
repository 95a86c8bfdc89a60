/// Colours in Oklab, where equal steps look about equal: what the colour maps are interpolated and checked in.
#pragma once

#include "engine/core/image.h"

namespace trocar::plot {

/// Lightness 0 … 1, and two opponent axes (green–red, blue–yellow) of about ±0.4.
struct Oklab {
  double lightness = 0.0;
  double a = 0.0;
  double b = 0.0;
};

Oklab to_oklab(Rgba colour);
/// Opaque; what sRGB cannot show is clipped for each channel.
Rgba from_oklab(const Oklab& colour);
/// From cylindrical coordinates; the hue in radians.
Oklab oklab_of(double lightness, double chroma, double hue_rad);
/// Euclidean: about 0.02 can just be told apart side by side.
double distance(const Oklab& x, const Oklab& y);

}  // namespace trocar::plot
