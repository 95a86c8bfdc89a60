// Samples taken out or brought back: DeleteSpan, Revert.
#include <fmt/format.h>

#include <utility>

#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"

namespace trocar::demonstration {

Result<Demonstration> made_by(const Demonstration& document, const DeleteSpan& edit) {
  TROCAR_RETURN_IF_ERROR(check_range(edit.from_s, edit.to_s));
  const SampleTrack& track = document.samples;
  const std::size_t first = track.lower_bound(document.tick_from(edit.from_s));
  const std::size_t after = track.lower_bound(document.tick_from(edit.to_s));
  if (after <= first) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("there is no sample from {} to {} s", edit.from_s, edit.to_s));
  }
  const bool to_the_end = after == track.size();
  const std::int64_t shift = edit.ripple && !to_the_end ? track.tick(first) - track.tick(after) : 0;
  if (edit.ripple) return with_other_length(document, first, after - first, {}, shift);
  Demonstration edited = document;
  edited.samples = SampleTrack::joined({track.slice(0, first), track.slice(after, track.size())});
  if (edited.gated().size() >= 2) return edited;
  return fail(ErrorCode::kInvalidArgument, "fewer than 2 samples would stay between the gates");
}

Result<Demonstration> made_by(const Demonstration& document, const Revert& edit) {
  TROCAR_RETURN_IF_ERROR(check_range(edit.from_s, edit.to_s));
  const auto part = [&](const SampleTrack& track) {
    const std::size_t first = track.lower_bound(document.tick_from(edit.from_s));
    return std::pair{first, track.lower_bound(document.tick_after(edit.to_s))};
  };
  const auto [first, last] = part(document.samples);
  const auto [recorded_first, recorded_last] = part(document.recorded);
  if (recorded_last <= recorded_first) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("nothing was recorded from {} to {} s", edit.from_s, edit.to_s));
  }
  Demonstration edited = document;
  edited.samples = SampleTrack::joined({document.samples.slice(0, first),
                                        document.recorded.slice(recorded_first, recorded_last - recorded_first),
                                        document.samples.slice(last, document.samples.size())});
  return edited;
}

}  // namespace trocar::demonstration
