/// The left hand: segments A to D of a transfer, from the ready pose to the released block.
#pragma once

#include "engine/trial/scripted_operator.h"

namespace trocar::trial {

/// Threads: one at a time.
class ScriptedUser final : public ScriptedOperator {
 public:
  ScriptedUser(const Assignment& assignment, const Random& random);
  bool finished() const override { return step_ == Step::kRest; }

 private:
  enum class Step {
    kIdle,     ///< Looks at the scene.
    kAgentA,   ///< Holds the left pedal until the tool rests (A, shared control).
    kOver,     ///< High over the wall (A).
    kAbove,    ///< Straight down to above it (A).
    kAlign,    ///< Exactly over it, jaws open.
    kHover,    ///< Down to just over the block's top.
    kDescend,  ///< Over the wall.
    kClose,    ///< Closes and feels.
    kLift,     ///< Up.
    kAgentC,   ///< As in A.
    kCarry,    ///< To the hand-off (C).
    kPresent,  ///< Holds still for the assistant (D).
    kOpen,     ///< Lets go.
    kUp,       ///< Off the block.
    kRetreat,  ///< Back to the ready pose.
    kRest,
  };

  void think(const Glimpse& seen) override;
  void go(Step step);
  void think_of_approach(const Glimpse& seen);
  void think_of_lift(const Glimpse& seen);
  void think_of_transfer(const Glimpse& seen);
  /// Holds the left pedal; true once the tool has come to rest and the foot is up again.
  bool agent_has_done();
  Aim above(const Glimpse& seen) const;
  void choose_grasp(const Glimpse& seen);
  /// Opens the jaws and goes for the block anew.
  void try_again(const Glimpse& seen);
  /// The block as it was seen when the grasp was chosen has been pushed.
  bool pushed(const Glimpse& seen) const;

  Step step_ = Step::kIdle;
  double pause_s_ = 0.0;
  spatial::Pose grasp_;         ///< As judged.
  spatial::Pose block_before_;  ///< When the grasp was chosen.
  double grip_rad_ = 0.0;
  bool hasty_ = false;  ///< Will let go too early.
  int still_ = 0;       ///< Samples for which the tool has rested under the agent.
  bool foot_up_ = false;
};

}  // namespace trocar::trial
