/// Colour maps for fields: perceptually even and safe for colour-blind readers; no rainbow.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/image.h"
#include "engine/core/result.h"

namespace trocar::plot {

enum class ColourMap { kViridis, kCividis, kMagma, kGrey, kDiverging, kCategorical };
std::string_view to_string(ColourMap map);
Result<ColourMap> colour_map_from(std::string_view text);

/// `t` from 0 to 1, clamped; for kCategorical use `category()`.
Rgba colour(ColourMap map, double t);
/// Okabe–Ito, by number, repeating.
Rgba category(int number);

/// From a value to 0 … 1. Symlog is linear within ± `linear`, logarithmic beyond.
enum class ScaleKind { kLinear, kSymlog, kPercentile };
struct Scale {
  ScaleKind kind = ScaleKind::kLinear;
  double low = 0.0;
  double high = 1.0;
  double linear = 1.0;  ///< Of symlog.

  double position(double value) const;  ///< Clamped to 0 … 1.
  double value(double position) const;
};

/// Limits from the finite values; percentile clips to the 2nd and 98th. All equal or none finite gives [v, v + 1].
Scale fit_scale(ScaleKind kind, const std::vector<double>& values, bool centred_at_zero);

/// About `count` round numbers inside [low, high].
std::vector<double> ticks(double low, double high, int count);
/// Shortest text that tells neighbouring ticks apart.
std::string_view unicode_minus();
std::string format_tick(double value, double step);

}  // namespace trocar::plot
