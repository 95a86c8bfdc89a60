#include "engine/control/clutch.h"

namespace trocar::control {

spatial::Pose ClutchedMapping::follow(const spatial::Pose& X_DH, bool clutch_down, Tick now) {
  const PedalEvent pedal = pedal_.look(clutch_down, now);
  if (pedal.pressed) ++count_;
  if (clutch_down) mapping_.release();
  spatial::Pose setpoint = mapping_.map(X_DH);
  if (pedal.released) mapping_.engage(X_DH, setpoint);
  return setpoint;
}

}  // namespace trocar::control
