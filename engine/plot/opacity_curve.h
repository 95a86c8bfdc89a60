/// How much of what is behind it a value hides, by its place on the scale: what makes a cloud of a field.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/plot/colouring.h"

namespace trocar::plot {

struct OpacityKnot {
  double position = 0.0;  ///< On the scale of the colours, 0 … 1.
  double height = 0.0;    ///< 0 … 1.
  bool operator==(const OpacityKnot&) const = default;
};
constexpr std::size_t kMostOpacityKnots = 16;

/// Straight between its knots, level before the first and after the last. What hides is the square of the height, so
/// that thin values can be told apart.
struct OpacityCurve {
  std::vector<OpacityKnot> knots{{0.0, 0.0}, {1.0, 1.0}};  ///< By position, each above the one before; at least one.

  double at(double position) const;               ///< The height, 0 … 1.
  double highest(double low, double high) const;  ///< Within these positions, both included; low ≤ high.
  bool operator==(const OpacityCurve&) const = default;
};

/// "ramp", "highest", "lowest", "uniform".
enum class OpacityPreset { kRamp, kHighest, kLowest, kUniform };
constexpr std::array<OpacityPreset, 4> kOpacityPresets{OpacityPreset::kRamp, OpacityPreset::kHighest,
                                                       OpacityPreset::kLowest, OpacityPreset::kUniform};
std::string_view to_string(OpacityPreset preset);
OpacityCurve opacity_curve(OpacityPreset preset);
std::optional<OpacityPreset> preset_of(const OpacityCurve& curve);

/// The preset's name, or "0:0/0.5:0.2/1:1": position and height of each knot.
std::string to_string(const OpacityCurve& curve);
/// Reads these. Errors: kInvalidArgument saying what may stand there.
Result<OpacityCurve> opacity_curve_from(std::string_view text);

/// For a cloud that shows structure: clear where most values lie, thick far from there. Where a third of the finite
/// values share one place on the scale (as all that was never learned do), the curve rises to both sides of it; else
/// from the end where least happens, of a diverging map from its middle. The commonest seven tenths stay faint.
OpacityCurve fitted_opacity(const Colouring& colouring, const std::vector<double>& values);

}  // namespace trocar::plot
