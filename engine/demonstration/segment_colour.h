/// One colour for each segment, the same in timeline, badges, paths and films; always shown together with its letter.
#pragma once

#include "engine/core/image.h"
#include "engine/demonstration/recording.h"

namespace trocar::demonstration {

/// After Okabe and Ito, lightened so that dark letters can be read on them.
Rgba segment_colour(Segment segment);

}  // namespace trocar::demonstration
