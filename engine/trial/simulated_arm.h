/// An arm of the simulator behind the seam that a physical one has, too.
#pragma once

#include "engine/control/arm.h"
#include "engine/kinematics/psm.h"
#include "engine/simulation/world.h"

namespace trocar::trial {

/// The world must outlive it. Threads: the world's.
class SimulatedArm final : public control::Arm {
 public:
  SimulatedArm(simulation::World& world, kinematics::ArmSide side);

  control::ArmFeedback feedback() const override;
  control::ToolCommand setpoint_cp() const override;
  Status servo_cp(const control::ToolCommand& setpoint) override;
  Status reaches(const spatial::Pose& X_WT) const override;
  /// What a simulated arm never says by itself: somebody plays a fault, a pause, a disable.
  void play(control::OperatingState state) { operating_state_ = state; }

 private:
  simulation::World* world_;
  kinematics::ArmSide side_;
  kinematics::PsmModel model_;
  control::OperatingState operating_state_ = control::OperatingState::kEnabled;
};

}  // namespace trocar::trial
