#include "engine/demonstration/clip.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/demonstration/edits/stretch.h"

namespace trocar::demonstration {

Result<Clip> clip_of(const Demonstration& source, double from_s, double to_s) {
  TROCAR_RETURN_IF_ERROR(check_range(from_s, to_s));
  const SampleTrack run = source.samples_within(from_s, to_s);
  if (run.empty()) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("{} has no sample from {} to {} s", source.name, from_s, to_s));
  }
  Clip clip{run.shifted(-run.tick(0)), {}, source.block, source.goal};
  const double zero_s = Tick{run.tick(0) - source.first_tick()}.seconds();
  const double length_s = Tick{clip.samples.tick(clip.samples.size() - 1)}.seconds();
  for (const SegmentSpan& span : source.segments) {
    const double begin_s = std::max(span.begin_s - zero_s, 0.0);
    const double end_s = std::min(span.end_s - zero_s, length_s);
    if (begin_s < end_s) clip.segments.push_back({span.label, begin_s, end_s});
  }
  return clip;
}

}  // namespace trocar::demonstration
