/// What happens in a demonstration and can be looked for: grippers that open and close, grasps, segments, notes.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/demonstration/demonstration.h"

namespace trocar::demonstration {

enum class EventKind : std::uint8_t { kJawOpens, kJawCloses, kGrasp, kRelease, kSegment, kNote };

struct Event {
  double t_s = 0.0;  ///< Of the demonstration.
  EventKind kind = EventKind::kSegment;
  int arm = -1;  ///< 0 left, 1 right; −1: neither.
  bool operator==(const Event&) const = default;
};

/// From `from_s` to `to_s`, both included, gated or not, by time. A gripper has opened when it is told to be wider than
/// 0.3 rad, and closed when narrower than 0.1 rad; between them it is as it was. Begins and ends of segments and notes
/// count once each. Time: by the samples of the span.
std::vector<Event> events_within(const Demonstration& document, double from_s, double to_s);

/// Where the next event after `t_s` is (`direction` 1), or the one before it (−1); else the gate. What is nearer than
/// half a sample is not found again.
double next_event(const Demonstration& document, double t_s, int direction);

}  // namespace trocar::demonstration
