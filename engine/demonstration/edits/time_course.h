/// At which old time a span is at each of its new times: what Retime makes of its parameters. Private to the module.
#pragma once

#include <functional>
#include <vector>

#include "engine/demonstration/edit.h"
#include "engine/demonstration/sample_track.h"

namespace trocar::demonstration {

/// New times count from the begin of the span, old ones are ticks of the samples; neither need be whole.
struct TimeCourse {
  double length = 0.0;                   ///< Of the new span, in ticks.
  std::function<double(double)> old_at;  ///< From 0 … `length` to a tick; never decreases.
  bool even = false;                     ///< Old times go by at one rate.

  /// The share of the new span at which `share` of the old one has gone by.
  double share_at(double share) const;
};

/// Precondition: at least two samples, by tick; their times in knots count from `first_tick`.
/// Errors: kInvalidArgument for parameters that make no course, or one of no duration or of more than an hour.
Result<TimeCourse> time_course(const SampleTrack& samples, const Retime& edit, std::int64_t first_tick);

/// The same in `ticks`, more or fewer.
TimeCourse fitted(TimeCourse course, double ticks);

}  // namespace trocar::demonstration
