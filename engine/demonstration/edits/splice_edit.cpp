// Splice: a clip put in.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/demonstration/clip.h"
#include "engine/demonstration/edits/edit_functions.h"
#include "engine/demonstration/edits/stretch.h"
#include "engine/demonstration/motion.h"
#include "engine/peg_board/peg_board.h"

namespace trocar::demonstration {
namespace {

using Shifts = std::array<Eigen::Vector3d, 2>;  ///< Of each arm, in W, metres.

bool known(int place) {
  return place >= 0 && place < peg_board::kBlockCount;
}

/// `before` is the sample that the clip is to go on from; null at the very beginning.
Result<Shifts> shifts_of(const Demonstration& document, const Clip& clip, const Splice& edit, const Sample* before) {
  Shifts by{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  switch (edit.align) {
    case Align::kAsRecorded:
      return by;
    case Align::kMeet:
      if (before == nullptr) return by;
      for (std::size_t arm = 0; arm < by.size(); ++arm) {
        by[arm] = measured_tip(*before, arm) - measured_tip(clip.samples.front(), arm);
      }
      return by;
    case Align::kPeg: {
      if (edit.peg < -1 || edit.peg >= peg_board::kBlockCount) {
        return fail(ErrorCode::kInvalidArgument, "start pegs are numbered 0 to 5; -1 is this demonstration's");
      }
      const int peg = edit.peg >= 0 ? edit.peg : document.block;
      if (!known(peg) || !known(clip.block)) {
        return fail(ErrorCode::kInvalidArgument, "it is not known which block was carried, so no peg can be met");
      }
      by.fill(peg_board::start_peg(peg) - peg_board::start_peg(clip.block));
      return by;
    }
  }
  return by;
}

/// The clip's samples moved; shared where nothing moves.
SampleTrack moved(const Clip& clip, const Shifts& by) {
  if (by[0].isZero(0.0) && by[1].isZero(0.0)) return clip.samples;
  BlockBuilder made;
  for (Sample sample : clip.samples) {
    for (std::size_t arm = 0; arm < by.size(); ++arm) {
      displace(sample, arm, by[arm], Eigen::Quaterniond::Identity(), clip.block);
    }
    made.add(sample);
  }
  return SampleTrack(made.take());
}

/// Where the clip goes: the samples that it replaces, and the tick of its first.
struct Place {
  std::size_t first = 0;
  std::size_t count = 0;
  std::int64_t tick = 0;
};

Result<Place> place_of(const Demonstration& document, const Splice& edit) {
  if (!std::isfinite(edit.at_s) || !std::isfinite(edit.until_s)) {
    return fail(ErrorCode::kInvalidArgument, "the times must be finite");
  }
  if (edit.until_s != 0.0 && edit.until_s < edit.at_s) {
    return fail(ErrorCode::kInvalidArgument, "what the clip replaces must end after it begins");
  }
  if (edit.at_s > document.end_s + Tick{kTicksPerSample}.seconds() || edit.at_s < 0.0) {
    return fail(
        ErrorCode::kInvalidArgument,
        fmt::format("{:.2f} s is not within the demonstration, which ends at {:.2f} s", edit.at_s, document.end_s));
  }
  const SampleTrack& track = document.samples;
  Place place;
  place.first = track.lower_bound(document.tick_from(std::max(edit.at_s, 0.0)));
  if (edit.until_s > edit.at_s) {
    place.count = track.lower_bound(document.tick_from(edit.until_s)) - place.first;
  }
  place.tick = place.first == 0 ? track.tick(0) : track.tick(place.first - 1) + kTicksPerSample;
  return place;
}

}  // namespace

Result<Demonstration> made_by(const Demonstration& document, const Splice& edit) {
  if (!edit.clip) return fail(ErrorCode::kInvalidArgument, "there is no clip to put in");
  TROCAR_ASSIGN_OR_RETURN(const Place place, place_of(document, edit));
  const Clip& clip = *edit.clip;
  const SampleTrack& track = document.samples;
  const Sample before = track[place.first == 0 ? 0 : place.first - 1];
  TROCAR_ASSIGN_OR_RETURN(const Shifts by, shifts_of(document, clip, edit, place.first == 0 ? nullptr : &before));
  const std::int64_t last = place.tick + clip.samples.tick(clip.samples.size() - 1);
  const std::size_t after = place.first + place.count;
  const std::int64_t shift = after < track.size() ? last + kTicksPerSample - track.tick(after) : 0;
  TROCAR_ASSIGN_OR_RETURN(Demonstration edited, with_other_length(document, place.first, place.count,
                                                                  moved(clip, by).shifted(place.tick), shift));
  const double begin_s = Tick{place.tick - edited.first_tick()}.seconds();
  const double end_s = Tick{last - edited.first_tick()}.seconds();
  // What goes in at the end of the gates, or in place of it, is meant to be seen.
  const std::size_t gate = track.lower_bound(document.tick_after(document.end_s));
  const bool at_gate = place.first <= gate && gate <= after;
  if (at_gate || (after == track.size() && edit.at_s >= document.end_s)) edited.end_s = end_s;
  for (const SegmentSpan& span : clip.segments) {
    TROCAR_ASSIGN_OR_RETURN(edited,
                            made_by(edited, LabelSegment{span.label, begin_s + span.begin_s, begin_s + span.end_s}));
  }
  return edited;
}

}  // namespace trocar::demonstration
