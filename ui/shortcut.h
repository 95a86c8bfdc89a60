/// Key chords: as text for people ("Ctrl+Shift+T"), as keys for the program.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "ui/window/input.h"

namespace trocar::ui {

struct Chord {
  Key key = Key::kNone;
  Modifiers modifiers;
  bool operator==(const Chord&) const = default;
};

/// Names are those of `to_text`; letters in either case; "?" and its kin are Shift and a key. Errors: kInvalidArgument
/// naming the part that is no key.
Result<Chord> chord_from(std::string_view text);
std::string to_text(const Chord& chord);
/// "A" … "Z", "0" … "9", "F1" … "F12", "Left", "Home", "Space", "Enter", "Escape", ",", "Keypad7" and their kin.
std::optional<Key> key_from(std::string_view name);

/// True in the frame in which the chord is pressed, exactly these modifiers held.
bool pressed(const InputQueue& input, const Chord& chord);

}  // namespace trocar::ui
