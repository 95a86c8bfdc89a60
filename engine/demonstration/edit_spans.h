/// Where in time each edit of a demonstration's stack has worked, for a lane that shows it.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/demonstration/demonstration.h"

namespace trocar::demonstration {

/// Times of the demonstration as it is now: what later edits took out or put in has moved them.
struct EditSpan {
  std::int64_t entry = 0;  ///< Of the stack.
  double begin_s = 0.0;
  double end_s = 0.0;  ///< Equal to the begin for what was taken out.
};

/// Of the edits that are applied, in their order; none for those that move the gates.
/// How much longer or shorter a span became is what its edit says; where only carrying it out would tell (`retime` to
/// a speed, `bridge` by a speed, pauses taken out by `trim-idle`), later spans are as if nothing had moved.
std::vector<EditSpan> edit_spans(const Demonstration& document);

}  // namespace trocar::demonstration
