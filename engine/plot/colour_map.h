/// Colour maps for fields: perceptually even and safe for colour-blind readers; no rainbow but turbo.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/image.h"
#include "engine/core/result.h"

namespace trocar::plot {

/// All but turbo are even and safe; it is there for who must match another figure, and is never chosen by itself.
enum class ColourMap { kViridis, kCividis, kMagma, kTurbo, kGrey, kDiverging, kCategorical };
std::string_view to_string(ColourMap map);
/// Errors: kInvalidArgument with the names that there are.
Result<ColourMap> colour_map_from(std::string_view text);

/// `t` from 0 to 1, clamped; NaN gives the colour of 0. For kCategorical use `category()`.
Rgba colour(ColourMap map, double t);
/// Okabe–Ito, by number, repeating.
Rgba category(int number);
constexpr int kCategoryCount = 8;

/// From a value to 0 … 1. Log is of the size, where all values have one sign; symlog is linear within ± `linear`,
/// logarithmic beyond; percentile is linear between the 2nd and the 98th; rank spends the colours evenly on the values.
enum class ScaleKind { kLinear, kLog, kSymlog, kPercentile, kRank };
std::string_view to_string(ScaleKind kind);
/// Errors: kInvalidArgument with the names that there are.
Result<ScaleKind> scale_kind_from(std::string_view text);
/// In the order of the menus.
const std::vector<ScaleKind>& all_scale_kinds();

/// Precondition: low < high, linear > 0, all finite; of log, 0 < low or high < 0; of rank, `sorted` is not empty.
struct Scale {
  ScaleKind kind = ScaleKind::kLinear;
  double low = 0.0;
  double high = 1.0;
  double linear = 1.0;                                          ///< Of symlog.
  std::shared_ptr<const std::vector<double>> sorted = nullptr;  ///< Of rank: the finite values.

  double position(double value) const;  ///< Clamped to 0 … 1; NaN gives 0.
  double value(double position) const;
};

/// Limits from the finite values; percentile clips to the 2nd and 98th. All equal or none finite gives [v, v + 1].
/// Centred at zero, the limits are ± the larger of the two, or ± 1. Symlog's `linear` is the 5th percentile of the
/// sizes that are not zero, and at least 1/10,000 of the largest. Log leaves zeros out of the limits (they lie at the
/// end nearest to zero); where there are values of both signs, or the scale is centred, it becomes symlog, and rank
/// becomes percentile where it is centred.
Scale fit_scale(ScaleKind kind, const std::vector<double>& values, bool centred_at_zero);

/// About `count` round numbers (1, 2 or 5 times a power of ten apart) inside [low, high].
std::vector<double> ticks(double low, double high, int count);
/// The same for a scale: of log, powers of ten; of symlog, zero and signed powers of ten; of rank, quantiles.
std::vector<double> ticks(const Scale& scale, int count);
/// U+2212.
std::string_view unicode_minus();
/// Shortest text that tells ticks `step` apart, with a true minus sign; "2e6" style from a million up and below 10⁻⁴.
std::string format_tick(double value, double step);
/// One text for each of `values`, with as many digits as their smallest gap needs; of symlog, each with its own.
std::vector<std::string> format_ticks(const Scale& scale, const std::vector<double>& values);

}  // namespace trocar::plot
