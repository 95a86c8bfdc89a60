/// The right hand: takes the block at the hand-off and places it on its goal peg (segment E).
#pragma once

#include "engine/trial/scripted_operator.h"

namespace trocar::trial {

/// Threads: one at a time.
class ScriptedAssistant final : public ScriptedOperator {
 public:
  ScriptedAssistant(const Assignment& assignment, const Random& random);
  bool finished() const override { return step_ == Step::kRest; }

 private:
  enum class Step {
    kWatch,    ///< Until the user presents the block.
    kAbove,    ///< To above a free wall.
    kDescend,  ///< Over the wall.
    kClose,    ///< Closes and holds.
    kOverPeg,  ///< With the block to over the goal peg, once the user has gone.
    kLower,    ///< Down to the board.
    kOpen,     ///< Lets go.
    kUp,       ///< Off the block.
    kRetreat,  ///< Back to the ready pose.
    kRest,
  };

  void think(const Glimpse& seen) override;
  void go(Step step);
  void think_of_taking(const Glimpse& seen);
  void think_of_placing(const Glimpse& seen);
  void give_up(const Glimpse& seen);
  /// The free wall that faces the assistant most, as judged.
  spatial::Pose judge_grasp(const Glimpse& seen) const;
  /// The tool's pose that brings the block's centre to p_WK, the block kept as it is held.
  spatial::Pose carrying(const Glimpse& seen, const Eigen::Vector3d& p_WK) const;

  Step step_ = Step::kWatch;
  double pause_s_ = 0.0;
  spatial::Pose grasp_;  ///< As judged before going in: later the block moves with what touches it.
  spatial::Pose away_;
};

}  // namespace trocar::trial
