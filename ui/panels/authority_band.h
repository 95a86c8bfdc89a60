/// Who has the arm, to be read from two metres away: a band of words, shape and colour, pedals as lamps, the states.
#pragma once

#include "engine/trial/trial_status.h"
#include "ui/widgets/widgets.h"

namespace trocar::ui {

/// "AGENT", the segment's letter and whose turn it is next; as high as three lines.
void authority_band(Ui& ui, const trial::TrialStatus& status, demonstration::Segment segment, trial::Mode mode);
/// Both pedals: down or up, presses, what is wrong with them.
void pedal_lamps(Ui& ui, const trial::TrialStatus& status);
/// All states of the machine in their order; the present one is lit.
void control_states(Ui& ui, control::ControlState now);

/// What the band says: "AGENT", "OPERATOR", "CLUTCH", "HOLD", "STOPPED" …
std::string_view band_word(control::ControlState state, demonstration::Segment segment);
Rgba band_colour(control::ControlState state, demonstration::Segment segment);

}  // namespace trocar::ui
