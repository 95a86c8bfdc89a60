/// Curves with more samples than pixels: one smallest and one largest value for each pixel column.
#pragma once

#include <span>
#include <vector>

namespace trocar::plot {

/// What a column shows: a vertical stroke from `low` to `high`; `first` and `last` join it to its neighbours.
struct CurveColumn {
  bool filled = false;  ///< False where no finite sample falls into the column.
  double low = 0.0;
  double high = 0.0;
  double first = 0.0;
  double last = 0.0;
};

/// Column c holds the samples with x in [begin + c·w, begin + (c + 1)·w), w = (end − begin) / columns; the last one
/// holds x = end too. Samples that are not finite are left out. Preconditions: x does not decrease, x and y are equally
/// long, begin < end, columns > 0.
std::vector<CurveColumn> decimate(std::span<const double> x, std::span<const double> y, double begin, double end,
                                  int columns);

}  // namespace trocar::plot
