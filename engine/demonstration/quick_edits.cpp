#include "engine/demonstration/quick_edits.h"

#include <algorithm>

#include "engine/demonstration/events.h"

namespace trocar::demonstration {

SetJaw gripper_event(const Demonstration& document, Arms arms, double at_s, bool open) {
  SetJaw edit;
  edit.arms = arms;
  edit.from_s = at_s;
  edit.to_s = document.end_s;
  edit.jaw_rad = open ? kOpenJaw_rad : kClosedJaw_rad;
  // While the jaws are still on their way is no time for the next event.
  for (const Event& event : events_within(document, at_s + edit.ramp_s, document.end_s)) {
    const bool of_jaw = event.kind == EventKind::kJawOpens || event.kind == EventKind::kJawCloses;
    const bool of_arm = arms == Arms::kBoth || event.arm == static_cast<int>(arms);
    if (!of_jaw || !of_arm) continue;
    edit.to_s = event.t_s;
    break;
  }
  return edit;
}

LabelSegment label_from(const Demonstration& document, Segment label, double at_s) {
  LabelSegment edit{label, at_s, document.end_s};
  for (const SegmentSpan& span : document.segments) {
    if (span.begin_s > at_s) edit.to_s = std::min(edit.to_s, span.begin_s);
  }
  return edit;
}

}  // namespace trocar::demonstration
