/// Demonstrations of the JIGSAWS data set (Gao et al., 2014): a text file of kinematics, 76 numbers a line and 30 lines
/// a second, and a transcription of gestures.
#pragma once

#include <string_view>

#include "engine/exchange/imported.h"

namespace trocar::exchange {

/// Takes the two slave arms: columns 39 to 57 are the left one, 58 to 76 the right one; of each the tip's position in
/// metres (3 numbers), its rotation by rows (9), velocities (6, left out) and the jaw in radians. Poses stay in the
/// file's frame. `transcription` may be empty; its lines "FIRST LAST GESTURE", frames from 1, both included, become
/// notes tagged "gesture".
/// Errors: kCorrupt naming the line at fault, and whether it is one of the transcription.
Result<Imported> from_jigsaws(std::string_view kinematics, std::string_view transcription);

}  // namespace trocar::exchange
