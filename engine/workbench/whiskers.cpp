#include "engine/workbench/whiskers.h"

#include <algorithm>

#include "engine/plot/colour_map.h"

namespace trocar::workbench {

Rgba whisker_colour(double share) {
  // The map's dark end cannot be told from the ground.
  return plot::colour(plot::ColourMap::kMagma, 0.55 + 0.45 * std::clamp(share, 0.0, 1.0));
}

void add_whiskers(const demonstration::Comparison& comparison, std::vector<stage::PathLayer>& paths) {
  constexpr std::size_t kMost = 60;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    std::vector<const demonstration::Match*> apart;
    for (const demonstration::Match& match : comparison.matches) {
      if (match.deviation_m(arm) > kLeastWhisker_m) apart.push_back(&match);
    }
    const std::size_t count = std::min(apart.size(), kMost);
    for (std::size_t i = 0; i < count; ++i) {
      const demonstration::Match& match = *apart[i * apart.size() / count];
      const double share = match.deviation_m(arm) / comparison.both.max_m;
      stage::PathLayer whisker;
      whisker.points = {match.p_after[arm], match.p_before[arm]};
      whisker.colours = {whisker_colour(share)};
      whisker.radius_m = 0.0002 + 0.0002 * share;
      paths.push_back(std::move(whisker));
    }
  }
}

}  // namespace trocar::workbench
