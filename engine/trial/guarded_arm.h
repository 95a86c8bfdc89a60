/// One arm behind its guard: the hand's mapping, the agent's hand-over, limits, reach.
#pragma once

#include "engine/control/carry_over.h"
#include "engine/control/clutch.h"
#include "engine/control/guard.h"
#include "engine/trial/agent.h"
#include "engine/trial/operator_input.h"

namespace trocar::trial {

/// What the arm is told from here to the next sample, or to the next cut. Threads: one at a time.
class GuardedArm {
 public:
  /// `arm` must outlive it.
  GuardedArm(control::Arm& arm, control::GuardSettings settings, double scale);

  control::Guard& guard() { return guard_; }
  const control::Guard& guard() const { return guard_; }
  const control::ClutchedMapping& mapping() const { return mapping_; }
  const std::string& refusal() const { return refusal_; }
  const control::LimitReport& limits() const { return limits_; }

  /// The operator's from here on: the hand means the setpoint, and what speed there was runs out.
  void take_over(const HandSample& hand);
  /// The setpoint at the end of the period: the operator's, the agent's, or, as nobody's, at rest.
  control::ToolCommand follow(const HandSample& hand, Tick now, double period_s);
  control::ToolCommand follow(Agent& agent, Tick now, double period_s);
  control::ToolCommand rest(double period_s);

 private:
  double jaw_for(double grip_rad);
  control::ToolCommand admit(const control::ToolCommand& wish, Tick now, double period_s, bool autonomous);

  control::Arm* arm_;
  control::Guard guard_;
  control::ClutchedMapping mapping_;
  control::CarryOver carry_;
  control::LimitReport limits_;
  std::string refusal_;
  bool jaw_follows_ = true;  ///< Not from take-over until the grip has come past where the jaw is.
  double grip_before_rad_ = 0.0;
};

/// Limits, box, floor and the pegs of this board.
control::GuardSettings guard_settings();

}  // namespace trocar::trial
