/// How often a track is sampled, all along and at one place: what counts as a gap depends on it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/demonstration/sample_track.h"

namespace trocar::demonstration {

/// The median of a track's steps, in ticks; 0 for fewer than 2 samples. Of a long track a thousand steps are looked at.
std::int64_t usual_step(const SampleTrack& samples);

/// How many samples a second a track usually has. Whole milliseconds are seen through: 33, 33 and 34 ms are 30 Hz.
/// Precondition: at least 2 samples.
double usual_rate_hz(const SampleTrack& samples);

/// What one expects from one sample to the next between those at `before` and `after`, in ticks: the median of the five
/// steps on either side, and where the two sides have different rates the longer. At least 1; `kTicksPerSample` where
/// there is no step beside. Precondition: `before < after < samples.size()`.
std::int64_t step_between(const SampleTrack& samples, std::size_t before, std::size_t after);

/// A step of more than one and a half of what its neighbours have.
struct SampleGap {
  std::size_t after = 0;   ///< The index of the sample behind it; the one before is the sample before.
  std::int64_t usual = 0;  ///< Ticks from one sample to the next beside it.
};
std::vector<SampleGap> sample_gaps(const SampleTrack& samples);

}  // namespace trocar::demonstration
