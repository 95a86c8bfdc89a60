/// Keyboard and gamepad while a take by hand goes on: the operator's keys go to the tools and mean nothing else.
#pragma once

#include "engine/trial/keyboard_hands.h"
#include "engine/trial/stick_hands.h"
#include "ui/command_table.h"
#include "ui/widgets/ui.h"

namespace trocar::ui {

/// Threads: that of the window.
class TakeKeys {
 public:
  /// What the operator did in this frame. `free`: no field and no form has the keyboard; else all keys count as let go.
  Requests follow(const Ui& ui, const WorkbenchState& state, bool free);
  /// True for chords that are the operator's now.
  static bool claims(const Chord& chord, const WorkbenchState& state);

 private:
  /// What the gamepad did, if it drives.
  std::vector<trial::HandEvent> follow_gamepad(const std::optional<trial::GamepadLook>& pad,
                                               const WorkbenchState& state);

  trial::KeyboardHands keyboard_;
  trial::StickHands stick_;
  bool taking_ = false;
  bool pedal_ = false;  ///< Space is held, in a trial.
};

/// A person here drives a tool of a trial.
bool trial_goes_on(const WorkbenchState& state);
/// A take by hand goes on: the tools can be driven.
bool take_goes_on(const WorkbenchState& state);

}  // namespace trocar::ui
