/// A run of a demonstration, taken out to be put into one: what copying takes and pasting gives.
#pragma once

#include <vector>

#include "engine/core/result.h"
#include "engine/demonstration/demonstration.h"

namespace trocar::demonstration {

/// Immutable value. Times count from the clip's first sample, whose tick is 0.
struct Clip {
  SampleTrack samples;  ///< At least 1; shared with the demonstration that it was taken from.
  std::vector<SegmentSpan> segments;
  int block = kUnknownPlace;  ///< That the source carries, and to where.
  int goal = kUnknownPlace;
};

/// The samples from `from_s` to `to_s` of the source, both included, gated or not, with their labels.
/// Errors: kInvalidArgument for an end before its begin, or a span without a sample.
Result<Clip> clip_of(const Demonstration& source, double from_s, double to_s);

}  // namespace trocar::demonstration
