/// A hand on its controller as a person moves it: submovements, tremor, a limited reach, and the clutch.
#pragma once

#include <vector>

#include "engine/core/random.h"
#include "engine/trial/operator_input.h"
#include "engine/trial/skill.h"
#include "engine/trial/tremor.h"

namespace trocar::trial {

/// Half the width of the cube in which the hand moves comfortably, about its neutral position.
constexpr double kHandReach_m = 0.10;

/// What a submovement is meant to do to the tool, in W.
struct Intention {
  Eigen::Vector3d way_W{0.0, 0.0, 0.0};                        ///< Metres.
  Eigen::Quaterniond turn_W = Eigen::Quaterniond::Identity();  ///< Applied from the left.
  double width_m = 1e-3;                                       ///< Width of the target (Fitts).
  double care = 1.0;                                           ///< > 1: slower than Fitts' law.
};

/// Threads: one at a time. Stepped at 200 Hz. Frames: hand in D (display), intentions in W.
class HumanHand {
 public:
  /// `scale` and `R_WD`: what the person has learned of the controls (`control::ToolMapping`).
  HumanHand(const SkillParameters& skill, const Random& random, const Eigen::Quaterniond& R_WD, double scale);

  /// Begins a minimum-jerk submovement, with noise at its end. If the hand's reach does not allow the whole of it, the
  /// hand goes as far as it can and then clutches back; the eye has to look again. Precondition: not `busy()`.
  void move(const Intention& intention);
  /// Begins to open or close the gripper over `duration_s`.
  void grip(double grip_rad, double duration_s);
  /// A submovement or a clutching is going on.
  bool busy() const { return phase_ != Phase::kStill; }
  bool gripping() const { return grip_step_ < grip_steps_; }

  /// The next sample.
  HandSample step();

 private:
  enum class Phase { kStill, kMoving, kPressing, kReturning, kReleasing };
  struct Stroke {
    Eigen::Vector3d from{0.0, 0.0, 0.0};
    Eigen::Vector3d to{0.0, 0.0, 0.0};
    Eigen::Quaterniond q_from = Eigen::Quaterniond::Identity();
    Eigen::Quaterniond q_to = Eigen::Quaterniond::Identity();
    int steps = 0;
    int step = 0;
  };

  void begin(Phase phase, const Eigen::Vector3d& to, const Eigen::Quaterniond& q_to, double duration_s);
  void begin_clutching();
  void advance();
  Eigen::Vector3d noise(const Eigen::Vector3d& way_D);

  SkillParameters skill_;
  Random random_;
  Eigen::Quaterniond R_WD_;
  double scale_;
  Tremor tremor_;
  Phase phase_ = Phase::kStill;
  Stroke stroke_;
  spatial::Pose hand_;                       ///< Without tremor.
  Eigen::Vector3d wanted_D_{0.0, 0.0, 0.0};  ///< Direction that ran out of reach; zero if none.
  double grip_from_ = 0.0;
  double grip_to_ = 0.0;
  int grip_step_ = 0;
  int grip_steps_ = 0;
};

/// 0 → 1 with zero speed and acceleration at both ends; `s` is clamped to 0 … 1.
double minimum_jerk(double s);

}  // namespace trocar::trial
