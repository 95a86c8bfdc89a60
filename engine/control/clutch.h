/// The right pedal: while it is down the hand moves and the tool holds.
#pragma once

#include "engine/control/pedal.h"
#include "engine/control/tool_mapping.h"

namespace trocar::control {

/// A mapping behind a clutch. Threads: one at a time.
class ClutchedMapping {
 public:
  explicit ClutchedMapping(const ToolMapping& mapping) : mapping_(mapping) {}

  /// The operator takes the tool over at its setpoint X_WT (start, hand-over from the agent).
  void take_over(const spatial::Pose& X_DH, const spatial::Pose& X_WT) { mapping_.engage(X_DH, X_WT); }
  /// The tool's setpoint for this hand and this pedal. The tool stands still from the look at which the pedal goes down
  /// to the one at which it comes up, and follows from there without a jump.
  spatial::Pose follow(const spatial::Pose& X_DH, bool clutch_down, Tick now);
  void set_scale(double scale, const spatial::Pose& X_DH) { mapping_.set_scale(scale, X_DH); }
  double scale() const { return mapping_.scale(); }
  /// Presses of the pedal so far.
  int count() const { return count_; }

 private:
  ToolMapping mapping_;
  Pedal pedal_;
  int count_ = 0;
};

}  // namespace trocar::control
