/// The axes of a line plot: where they end, their marks, and what is written at them.
#pragma once

#include <string>
#include <vector>

#include "engine/plot/curve.h"

namespace trocar::plot {

/// Between two values; what lies outside of it is shaded. An infinite end is none.
struct Band {
  double low = 0.0;
  double high = 0.0;
  std::string label;  ///< "the learning cube"
};

struct Axis {
  double low = 0.0;
  double high = 1.0;
  std::vector<double> ticks;
  std::vector<std::string> labels;  ///< One for each tick, with as many digits as tell them apart.

  /// 0 at the low end, 1 at the high end; beyond them it goes on.
  double position(double value) const { return (value - low) / (high - low); }
  double value(double position) const { return low + position * (high - low); }
};

/// Ends as given; marks about `tick_px` apart on `length_px` pixels, at least two where there is room for them.
/// Preconditions: low < high, finite.
Axis axis_over(double low, double high, double length_px, double tick_px);

/// Ends that leave a margin of 6 % around `data`, begin at zero where nothing is below it and `from_zero` says so, and
/// take in a limit of `bands` that the data come near to (60 % of the way). Never of no height.
Extent value_range(const Extent& data, bool from_zero, const std::vector<Band>& bands);

}  // namespace trocar::plot
