/// Scripts that use the window: one act a line, by label. `demos/…/*.ui`, `tests/gui/*.ui`, `trocar ui run`.
///
///     # a comment
///     click "Library/Record…"
///     type "Record/Seed" 7
///     drag "Timeline/In gate" 80 0
///     hold "Timeline/In gate" 80 0             (a drag that is not let go)
///     expect "Timeline/Playhead" value 0.500
///     expect "Toolbar/Undo" enabled            (disabled, present, absent, contains WORDS)
///     key Ctrl+Shift+T
///     key_down Ctrl                            (and hold it, until: key_up Ctrl)
///     drop "hand.csv"                          (on the window; beside the script)
///     wait idle 120                            (seconds; 60 if not said)
///     wait for "Library/Expert 1" 30
///     frames 5
///     screenshot out.png
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace trocar::ui {

struct ScriptLine {
  int number = 0;                  ///< From 1.
  std::vector<std::string> words;  ///< The verb first.
};

/// Empty lines and comments are left out; words are parted by blanks, "…" keeps blanks, \" and \\ within.
/// Errors: kInvalidArgument naming the line: an unknown verb, too few or too many words, a number that is none.
Result<std::vector<ScriptLine>> parse_script(std::string_view text);

/// How each verb is written, one a line, indented by two blanks.
std::string script_verbs();

}  // namespace trocar::ui
