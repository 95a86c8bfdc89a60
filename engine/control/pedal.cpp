#include "engine/control/pedal.h"

namespace trocar::control {

PedalEvent Pedal::look(bool down, Tick now) {
  PedalEvent event;
  event.down = down;
  event.pressed = seen_ && down && !down_;
  event.released = seen_ && !down && down_;
  if (event.pressed) {
    armed_ = true;
    pressed_at_ = now;
  }
  const bool long_enough = now.count - pressed_at_.count >= kTap.count;
  event.dead_man = down && armed_ && long_enough;
  event.tapped = event.released && armed_ && !long_enough;
  if (!down) armed_ = false;
  seen_ = true;
  down_ = down;
  return event;
}

}  // namespace trocar::control
