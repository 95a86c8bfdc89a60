/// What each kind of edit makes of a demonstration; `transformed` picks one. Private to the module.
#pragma once

#include <cstdint>

#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/edit.h"

namespace trocar::demonstration {

// Errors of all: as `transformed`. Those that need an id take the stack entry's.
Result<Demonstration> made_by(const Demonstration& document, const Trim& edit);
Result<Demonstration> made_by(const Demonstration& document, const TrimIdle& edit);
Result<Demonstration> made_by(const Demonstration& document, const Rename& edit);
Result<Demonstration> made_by(const Demonstration& document, const LabelSegment& edit);
Result<Demonstration> made_by(const Demonstration& document, const ProposeLabels& edit);
Result<Demonstration> made_by(const Demonstration& document, const DeleteSpan& edit);
Result<Demonstration> made_by(const Demonstration& document, const Splice& edit);
Result<Demonstration> made_by(const Demonstration& document, const Overdub& edit);
Result<Demonstration> made_by(const Demonstration& document, const Bridge& edit);
Result<Demonstration> made_by(const Demonstration& document, const MoveTool& edit);
Result<Demonstration> made_by(const Demonstration& document, const RotateTool& edit);
Result<Demonstration> made_by(const Demonstration& document, const Offset& edit);
Result<Demonstration> made_by(const Demonstration& document, const Smooth& edit);
Result<Demonstration> made_by(const Demonstration& document, const Simplify& edit);
Result<Demonstration> made_by(const Demonstration& document, const Resample& edit);
Result<Demonstration> made_by(const Demonstration& document, const Retime& edit);
Result<Demonstration> made_by(const Demonstration& document, const SnapToGrid& edit);
Result<Demonstration> made_by(const Demonstration& document, const SetJaw& edit);
Result<Demonstration> made_by(const Demonstration& document, const JawEvents& edit);
Result<Demonstration> made_by(const Demonstration& document, const Mirror& edit);
Result<Demonstration> made_by(const Demonstration& document, const Retarget& edit);
Result<Demonstration> made_by(const Demonstration& document, const Perturb& edit);
Result<Demonstration> made_by(const Demonstration& document, const Revert& edit);
Result<Demonstration> made_by(const Demonstration& document, const AddNote& edit, std::int64_t entry);
Result<Demonstration> made_by(const Demonstration& document, const RemoveNote& edit);

/// What is labelled in the span as it was recorded; labels outside stay.
Demonstration with_recorded_labels(const Demonstration& document, double from_s, double to_s);

}  // namespace trocar::demonstration
