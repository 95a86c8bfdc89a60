/// What changed between two versions of a demonstration, in numbers.
#pragma once

#include <string>
#include <vector>

#include "engine/demonstration/demonstration.h"

namespace trocar::demonstration {

struct Difference {
  double duration_change_s = 0.0;  ///< Positive: `after` is longer.
  int removed = 0;                 ///< Samples of `before` that `after` lacks.
  int added = 0;
  int moved = 0;  ///< Samples in both with a tool tip elsewhere.
  /// Between the tool tips of samples in both, over both arms.
  double max_deviation_m = 0.0;
  double rms_deviation_m = 0.0;
};

/// True if samples of both with one tick are the same moment of one recording.
bool of_one_recording(const Demonstration& before, const Demonstration& after);

/// Versions of one recording are matched sample by sample; different recordings by the time since their begin gates,
/// `before` interpolated, so that what one is longer by counts as removed or added.
Difference difference(const Demonstration& before, const Demonstration& after);

/// What else differs, a clause each: "segment C was 8.10–12.40 s, is 10.00–12.00 s". Spans of each segment, gates or
/// not; notes; block and goal.
std::vector<std::string> label_differences(const Demonstration& before, const Demonstration& after);

}  // namespace trocar::demonstration
