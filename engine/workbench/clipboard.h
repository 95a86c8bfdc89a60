/// Cutting, copying and pasting: a selection in time, what was copied, and the edits that follow from them.
#pragma once

#include <optional>
#include <string>

#include "engine/core/result.h"
#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/edit.h"

namespace trocar::workbench {

/// Times of a demonstration; the end is not in it, unless it is that of the gates.
struct TimeSpan {
  double begin_s = 0.0;
  double end_s = 0.0;
  double length_s() const { return end_s - begin_s; }
  bool operator==(const TimeSpan&) const = default;
};

/// What was copied: it names its source, the span and the point of the history, and holds no samples. What is done to
/// the source afterwards, its removal included, changes nothing of what is pasted.
struct Clipboard {
  demonstration::DemonstrationId source;
  std::string name;     ///< Of the source, then.
  double from_s = 0.0;  ///< Of the first sample; times of the source.
  double to_s = 0.0;    ///< Of the last one.
  std::int64_t as_of = 0;

  double length_s() const { return to_s - from_s + 1.0 / demonstration::kSampleRate_hz; }
};

/// `span`, its ends in order and between the gates; none if no sample lies in it.
std::optional<TimeSpan> kept_within(const demonstration::Demonstration& shown, const TimeSpan& span);

/// `as_of`: the node of the history that shows `source`. Precondition: `span` is `kept_within` it.
Clipboard copied(const demonstration::Demonstration& source, const TimeSpan& span, std::int64_t as_of);

/// The edit that takes the span out: `ripple`: what follows moves up, else a gap stays. Where the span reaches a gate
/// nothing would follow, or a gap would begin, and the gate moves instead.
/// Errors: kInvalidArgument if nothing would stay. Precondition: `span` is `kept_within` the demonstration.
Result<demonstration::Edit> deletion(const demonstration::Demonstration& shown, const TimeSpan& span, bool ripple);

/// The clipboard at the playhead, or in place of a selection. At the end of the gates it goes on from there.
demonstration::Splice paste(const Clipboard& clipboard, const demonstration::Demonstration& into, double playhead_s,
                            const std::optional<TimeSpan>& selection, demonstration::Align align);

}  // namespace trocar::workbench
