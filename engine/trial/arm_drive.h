/// One arm's way from the operator's hand to the setpoint: mapping, clutch, limits, reach.
#pragma once

#include <string>

#include "engine/control/clutch.h"
#include "engine/control/setpoint_limiter.h"
#include "engine/kinematics/psm.h"
#include "engine/trial/operator_input.h"

namespace trocar::trial {

/// Threads: one at a time.
class ArmDrive {
 public:
  /// The hand's first sample engages at `start`.
  ArmDrive(kinematics::ArmSide side, const control::ToolCommand& start, double scale = 0.2);

  /// The setpoint of the next sample. Where the wish is out of the arm's reach the tool holds, and the hand is engaged
  /// anew there, so that moving back does not jump.
  control::ToolCommand advance(const HandSample& hand, Tick now);
  /// The same for who wishes for a place of the tool instead of moving a hand; out of reach the tool holds.
  control::ToolCommand approach(const control::ToolCommand& wish);

  const control::ToolCommand& setpoint() const { return limiter_.setpoint(); }
  const control::ClutchedMapping& mapping() const { return mapping_; }
  /// Which limits the last sample hit.
  const control::LimitReport& limits() const { return limits_; }
  /// Why the arm could not reach the last wish; "" if it could.
  const std::string& refusal() const { return refusal_; }
  /// Samples at which a limit was hit.
  std::int64_t limit_hits() const { return limiter_.hits(); }
  /// Samples at which the arm could not reach the wish.
  std::int64_t unreachable() const { return unreachable_; }

 private:
  kinematics::PsmModel model_;
  control::ClutchedMapping mapping_;
  control::SetpointLimiter limiter_;
  control::LimitReport limits_;
  std::string refusal_;
  bool engaged_ = false;
  std::int64_t unreachable_ = 0;
};

/// The command for the `sub`-th of `count` ticks from one sample's setpoint to the next; the last is `to` exactly.
/// Recorder and replay both use it: that is why a replay gives the same bits. Precondition: 1 ≤ sub ≤ count.
control::ToolCommand between(const control::ToolCommand& from, const control::ToolCommand& to, int sub, int count);

}  // namespace trocar::trial
