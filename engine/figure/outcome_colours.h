/// The colours of how rollouts end: one set for maps, ghosts, bars, lists and figures, told apart by colour-blind
/// readers and in grey.
#pragma once

#include <string_view>

#include "engine/core/image.h"
#include "engine/learning/rollout.h"
#include "engine/plot/colour_map.h"

namespace trocar::figure {

/// Of Okabe and Ito: blue arrives, orange loops, vermilion is a dead end; grey is outside of the safe set. Each is seen
/// on white and on dark ground.
inline Rgba outcome_colour(learning::RolloutEnd end) {
  switch (end) {
    case learning::RolloutEnd::kArrives:
      return plot::category(4);
    case learning::RolloutEnd::kLoops:
      return plot::category(0);
    case learning::RolloutEnd::kDeadEnd:
      return plot::category(5);
    case learning::RolloutEnd::kOutsideSafeSet:
      break;
  }
  return {140, 145, 153, 255};
}

/// As `learning::to_string`, but "outside" for what starts outside of the safe set.
inline std::string_view outcome_word(learning::RolloutEnd end) {
  return end == learning::RolloutEnd::kOutsideSafeSet ? "outside" : learning::to_string(end);
}

}  // namespace trocar::figure
