/// What both scripted operators have in common: eyes, a hand, and the cycle of aiming, moving, looking and correcting.
#pragma once

#include <string>

#include "engine/trial/eyes.h"
#include "engine/trial/human_hand.h"
#include "engine/trial/operator_input.h"

namespace trocar::trial {

/// What an operator is given to do.
struct Assignment {
  int block = 0;
  int goal = 0;
  SkillParameters skill;
  std::string skill_name;
  /// If not negative: the grasp is misjudged by up to this, evenly along each axis, instead of by the skill's σ;
  /// metres.
  double aim_jitter_m = -1.0;
  /// Presses the left pedal where the agent can do it, waits, and goes on from where it rests.
  bool shares_control = false;
  double scale = 0.2;  ///< From hand to tool, which the person knows.
};

/// Where the hand is to bring the tool, and how exactly.
struct Aim {
  spatial::Pose X_WT;
  double tolerance_m = 1e-3;
  double tolerance_rad = 0.08;
  double care = 1.0;  ///< > 1: slower than Fitts' law.
};

/// Threads: one at a time. The same assignment and random state give the same samples for the same world.
class ScriptedOperator : public OperatorInput {
 public:
  ScriptedOperator(kinematics::ArmSide side, const Assignment& assignment, const Random& random);

  HandSample sample(const simulation::WorldState& seen) final;
  std::string_view name() const final { return name_; }
  /// Nothing more is to be done.
  virtual bool finished() const = 0;
  /// Attempts to grasp so far.
  int attempts() const { return attempts_; }

 protected:
  static constexpr double kGripTime_s = 0.35;  ///< To close the hand.
  static constexpr double kFeel_s = 0.25;      ///< Until a closed hand tells whether it holds.

  /// Looks at the world and moves on; called once a sample.
  virtual void think(const Glimpse& seen) = 0;

  /// True once the tool is seen within tolerance; until then moves, waits for the eye, and corrects.
  bool reach(const Glimpse& seen, const Aim& aim);
  /// True once `seconds` have passed since the step began.
  bool waited(double seconds) const { return step_time_s() >= seconds; }
  double step_time_s() const;
  /// A new step of the task begins.
  void begin_step();
  void grip(double grip_rad, double duration_s) { hand_.grip(grip_rad, duration_s); }
  void press_agent_pedal(bool down) { agent_pedal_ = down; }
  bool hand_busy() const { return hand_.busy() || hand_.gripping(); }
  /// From what a movement causes to what the operator does about it.
  double loop_s() const { return assignment_.skill.visual_delay_s + assignment_.skill.reaction_s; }
  /// A pause of a person who thinks, drawn anew: 0.5 … 1.5 times the skill's mean.
  double hesitation_s() { return assignment_.skill.hesitation_s * random_.uniform(0.5, 1.5); }
  /// How wrong the next grasp will be judged, in the tool's frame T; also counts the attempt.
  void judge_anew();
  /// The pose as it is judged to be.
  spatial::Pose judged(const spatial::Pose& X_WT) const { return {X_WT * misjudged_T_, X_WT.q}; }
  double draw_opening() { return skill().open_rad + skill().open_noise_rad * random_.normal(); }
  double draw_grip() { return skill().grip_rad + skill().grip_noise_rad * random_.normal(); }

  const SkillParameters& skill() const { return assignment_.skill; }
  const Assignment& assignment() const { return assignment_; }
  const Eyes& eyes() const { return eyes_; }
  kinematics::ArmSide side() const { return side_; }
  Random& random() { return random_; }

 private:
  kinematics::ArmSide side_;
  Assignment assignment_;
  std::string name_;
  Random random_;
  Eyes eyes_;
  HumanHand hand_;
  Eigen::Vector3d misjudged_T_{0.0, 0.0, 0.0};
  std::int64_t now_ = 0;          ///< Samples since the start.
  std::int64_t step_began_ = 0;   ///< Sample.
  std::int64_t still_since_ = 0;  ///< Sample since which the hand rests.
  bool moved_ = false;            ///< In this step.
  bool agent_pedal_ = false;
  int attempts_ = 0;
};

/// `pose` moved in W.
spatial::Pose shifted(const spatial::Pose& pose, const Eigen::Vector3d& way_W);

}  // namespace trocar::trial
