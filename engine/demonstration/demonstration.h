/// The document that an expert edits: an immutable recording seen through edits.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/id.h"
#include "engine/core/result.h"
#include "engine/demonstration/edit_stack.h"
#include "engine/demonstration/note.h"
#include "engine/demonstration/recording.h"
#include "engine/demonstration/sample_track.h"

namespace trocar::demonstration {

/// Times are whole ticks divided by 1000; one typed as a decimal may differ from them in the last bit.
constexpr double kTimeTolerance_s = 1e-9;

using DemonstrationId = Id<struct DemonstrationTag>;

/// A labelled span; times are of the demonstration (0 = its first recorded sample), end exclusive.
struct SegmentSpan {
  Segment label = Segment::kA;
  double begin_s = 0.0;
  double end_s = 0.0;
  bool operator==(const SegmentSpan&) const = default;
};

/// Immutable value. Times are seconds since the recording's first sample, also after a trim, so that labels stay put.
struct Demonstration {
  DemonstrationId id;
  std::string name;
  std::shared_ptr<const RecordingInfo> recording;
  /// The effective trajectory before gates; shares with the recording what no edit has changed.
  SampleTrack samples;
  SampleTrack recorded;  ///< As it was before all edits.
  /// The edits that led from `recorded` here; never null.
  std::shared_ptr<const EditStack> stack = std::make_shared<const EditStack>();
  double begin_s = 0.0;               ///< Gate: samples before are kept but not used.
  double end_s = 0.0;                 ///< Gate, inclusive.
  std::vector<SegmentSpan> segments;  ///< By begin, not overlapping.
  std::vector<Note> notes;            ///< By begin.
  int block = 0;                      ///< The target block and the goal peg, as recorded or retargeted.
  int goal = 0;

  /// The time of the last sample, gated or not.
  double full_duration_s() const;
  /// The tick at which the demonstration's time is 0.
  std::int64_t first_tick() const;
  /// The first tick at or after `t_s`, and the first one after it.
  std::int64_t tick_from(double t_s) const;
  std::int64_t tick_after(double t_s) const;
  /// The samples from `from_s` to `to_s`, both included.
  SampleTrack samples_within(double from_s, double to_s) const;
  /// The samples between the gates.
  SampleTrack gated() const;
  /// Of `sample` since the recording's first sample, in seconds.
  double time_of(const Sample& sample) const;
  /// The last gated sample at or before `t_s`; precondition: `gated()` is not empty.
  Sample sample_at(double t_s) const;
  double duration_s() const { return end_s - begin_s; }
  /// The first span with that label, cut to the gates.
  std::optional<SegmentSpan> segment(Segment label) const;
  /// The gated samples of a span; the last gated sample belongs to a span that ends there.
  SampleTrack samples_in(const SegmentSpan& span) const;
  /// Of everything but the id and the name (samples, gates, labels): the version that a model was trained on.
  std::uint64_t hash() const;
  /// True if edits changed, moved, added or took out samples; gates, labels and notes change none.
  bool motion_edited() const;
  /// How the transfer ended: as it was recorded; unknown once the motion is another, or the gates leave out the instant
  /// in which that was decided. Re-simulation tells then. Time: by the samples since that instant.
  Outcome outcome() const;
  bool placed() const;
  /// Why that is no longer what was recorded: "its motion was edited since"; empty if it is.
  std::string_view outcome_doubt() const;
};

/// The demonstration as it was recorded, with its id and name.
Demonstration original_of(const Demonstration& document);

/// Of what was recorded, segments taken from the samples' own labels. Preconditions: `recorded` has at least 2 samples,
/// and they passed `check_samples`.
Demonstration make_demonstration(DemonstrationId id, std::string name, std::shared_ptr<const RecordingInfo> recording,
                                 SampleTrack recorded);

/// A demonstration of a whole recording, segments taken from the samples' own labels.
/// Errors: kInvalidArgument if the recording has fewer than 2 samples or one that is not finite or out of order.
Result<Demonstration> make_demonstration(DemonstrationId id, std::string name,
                                         std::shared_ptr<const Recording> recording);

}  // namespace trocar::demonstration
