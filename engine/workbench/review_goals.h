/// What a project's models ask of a demonstration, as a review takes it.
#pragma once

#include "engine/review/review.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

/// Of one model; nothing for one that is only described.
std::vector<review::SegmentGoal> goals_of(const ModelEntry* entry);

}  // namespace trocar::workbench
