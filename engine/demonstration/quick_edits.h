/// Edits that one key makes: what is not said follows from the demonstration.
#pragma once

#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/edit.h"

namespace trocar::demonstration {

/// How far a gripper is told to open and to close, in radians: beyond what counts as open and as closed.
constexpr double kOpenJaw_rad = 0.35;
constexpr double kClosedJaw_rad = 0.0;

/// The gripper opens or closes at `at_s`, and stays so until it next does something else, or to the end gate.
SetJaw gripper_event(const Demonstration& document, Arms arms, double at_s, bool open);

/// From `at_s` to where the next segment begins, or to the end gate.
LabelSegment label_from(const Demonstration& document, Segment label, double at_s);

}  // namespace trocar::demonstration
