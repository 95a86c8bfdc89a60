/// Key presses with their times, as text: a take by hand that can be made again, without a window.
///
///     # seconds since the recording began, what happens, which key
///     0.00  down D
///     0.50  up D
///     0.60  tap C                (down and up at once)
///     1.00  hold Shift+S 0.75    (down, and up after so many seconds; with Shift held meanwhile)
///     3.00  pause 1.5            (for so many seconds; simulated time stands)
///     4.00  end
#pragma once

#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/core/tick.h"
#include "engine/trial/keyboard_hands.h"

namespace trocar::trial {

enum class KeyAct : std::uint8_t { kDown, kUp, kPause, kEnd };
struct KeyStroke {
  Tick at;  ///< Since the recording began; pauses do not count.
  KeyAct act = KeyAct::kDown;
  HandKey key = 0;  ///< Of `kDown` and `kUp`.
  Tick duration;    ///< Of a pause.
};

/// By time, the last of them `kEnd`: where the text does not say when, one second after all else.
/// Errors: kInvalidArgument naming the line: an unknown act or key, a time that is none, beyond an hour, or before the
/// line above; likewise for a text without any act.
Result<std::vector<KeyStroke>> parse_key_script(std::string_view text);

}  // namespace trocar::trial
