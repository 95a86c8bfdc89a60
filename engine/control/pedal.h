/// A foot pedal: its level, its edges, and whether it is held long enough to count as a dead-man.
#pragma once

#include "engine/core/tick.h"

namespace trocar::control {

/// Shorter presses are taps and never count as a dead-man.
constexpr Tick kTap{150};

/// What one look at a pedal tells.
struct PedalEvent {
  bool down = false;      ///< Level.
  bool pressed = false;   ///< Went down at this look.
  bool released = false;  ///< Went up at this look.
  bool dead_man = false;  ///< Down without a break since an observed press, for `kTap` or longer.
  bool tapped = false;    ///< Went up at this look before it became a dead-man.
};

/// Threads: one at a time. A pedal that is already down at the first look has no press edge, and so is no dead-man
/// until it was let go and pressed again.
class Pedal {
 public:
  /// Precondition: `now` does not run backwards.
  PedalEvent look(bool down, Tick now);

 private:
  bool seen_ = false;
  bool down_ = false;
  bool armed_ = false;
  Tick pressed_at_;
};

}  // namespace trocar::control
