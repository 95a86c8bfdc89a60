#include "engine/plot/colouring.h"

#include <cmath>

namespace trocar::plot {

Rgba Colouring::colour(double value) const {
  constexpr Rgba kUnknown{0, 0, 0, 0};
  if (!std::isfinite(value)) return kUnknown;
  if (categories.empty()) return colour_at(scale.position(value));
  const double number = std::round(value);
  if (number < 0.0 || number >= static_cast<double>(categories.size())) return kUnknown;
  return seen_with(vision, categories[static_cast<std::size_t>(number)]);
}

Rgba Colouring::colour_at(double position) const {
  return seen_with(vision, plot::colour(map, position));
}

}  // namespace trocar::plot
