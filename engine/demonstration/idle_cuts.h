/// What an automatic trim of idle stretches would take out, one by one, so that a person can keep some of them.
#pragma once

#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/edit.h"

namespace trocar::demonstration {

/// An idle stretch that the edit concerns. Times are of the demonstration before the edit.
struct IdleCut {
  double begin_s = 0.0;  ///< Of what is idle.
  double end_s = 0.0;
  double from_s = 0.0;  ///< Of what goes: the stretch without its margins.
  double to_s = 0.0;
  bool at_end = false;  ///< A gate moves; else samples are cut out.
  bool stays = false;   ///< One of the edit's times to stay lies in it.

  double middle_s() const { return 0.5 * (begin_s + end_s); }
};

/// By time, those that stay too. Errors: kInvalidArgument for parameters that make no sense.
Result<std::vector<IdleCut>> idle_cuts(const Demonstration& document, const TrimIdle& edit);

}  // namespace trocar::demonstration
