/// Where a demonstration begins and ends to move: what "Trim idle" proposes.
#pragma once

#include <optional>

#include "engine/demonstration/edits.h"

namespace trocar::ui {

struct IdleOptions {
  double speed_m_per_s = 0.002;  ///< Slower is idle.
  double longest_s = 0.3;        ///< Idle ends up to this long are left alone.
  double kept_s = 0.1;           ///< Left standing at each end.
};

/// Gates that leave out idle ends of both arms; nothing if there is nothing to trim.
std::optional<demonstration::Trim> idle_trim(const demonstration::Demonstration& demonstration,
                                             const IdleOptions& options = {});

}  // namespace trocar::ui
