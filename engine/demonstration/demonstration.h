/// The document that an expert edits: an immutable recording seen through edits.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/id.h"
#include "engine/core/result.h"
#include "engine/demonstration/recording.h"

namespace trocar::demonstration {

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
  std::shared_ptr<const Recording> recording;
  /// The effective trajectory before gates; shared with the recording until an edit changes samples.
  std::shared_ptr<const std::vector<Sample>> samples;
  double begin_s = 0.0;               ///< Gate: samples before are kept but not used.
  double end_s = 0.0;                 ///< Gate, inclusive.
  std::vector<SegmentSpan> segments;  ///< By begin, not overlapping.
  /// `hash_of(*samples)`, kept by whoever sets `samples` so that `hash()` is cheap; 0: not known.
  std::uint64_t samples_hash = 0;

  /// The time of the last sample, gated or not.
  double full_duration_s() const;
  /// The samples between the gates.
  std::span<const Sample> gated() const;
  /// Of `sample` since the recording's first sample, in seconds.
  double time_of(const Sample& sample) const;
  /// The last gated sample at or before `t_s`; precondition: `gated()` is not empty.
  const Sample& sample_at(double t_s) const;
  double duration_s() const { return end_s - begin_s; }
  /// The first span with that label, cut to the gates.
  std::optional<SegmentSpan> segment(Segment label) const;
  /// The gated samples of a span; the last gated sample belongs to a span that ends there.
  std::span<const Sample> samples_in(const SegmentSpan& span) const;
  /// Of everything but the id and the name (samples, gates, labels): the version that a model was trained on.
  std::uint64_t hash() const;
};

/// A demonstration of a whole recording, segments taken from the samples' own labels.
/// Errors: kInvalidArgument if the recording has fewer than 2 samples or one that is not finite or out of order.
Result<Demonstration> make_demonstration(DemonstrationId id, std::string name,
                                         std::shared_ptr<const Recording> recording);

}  // namespace trocar::demonstration
