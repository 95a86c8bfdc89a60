/// Where an edit has put together what was apart, and how far the tools jump there.
#pragma once

#include <string>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/edit.h"

namespace trocar::demonstration {

/// From one sample to the next; of the two arms, the larger.
struct Join {
  double at_s = 0.0;        ///< Of the later sample.
  double gap_s = 0.0;       ///< Time between them that is more than a sample's.
  double moved_m = 0.0;     ///< Between the measured tool tips.
  double turned_rad = 0.0;  ///< Between the measured orientations.
};

/// Between the samples `index` − 1 and `index`. Precondition: both are there.
Join join_at(const Demonstration& document, std::size_t index);

/// The joins that `edit` made of `before` in `after`, in order: of what was taken out or put in, none of other edits.
std::vector<Join> joins_of(const Edit& edit, const Demonstration& before, const Demonstration& after);

/// "the tools jump 1.20 mm and 3.4° at 2.50 s", with the time of a gap that was left; "" without joins.
std::string sentence_of(const std::vector<Join>& joins);

}  // namespace trocar::demonstration
