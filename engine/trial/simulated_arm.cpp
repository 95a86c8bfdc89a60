#include "engine/trial/simulated_arm.h"

#include "engine/trial/sampling.h"

namespace trocar::trial {

SimulatedArm::SimulatedArm(simulation::World& world, kinematics::ArmSide side)
    : world_(&world), side_(side), model_(kinematics::psm_model(side)) {}

control::ArmFeedback SimulatedArm::feedback() const {
  const simulation::WorldState& state = world_->state();
  const simulation::ArmState& arm = state.arm(side_);
  control::ArmFeedback feedback;
  // The first tick is 1: 0 stands for "nothing was measured yet".
  feedback.stamp = Tick{state.tick.count + 1};
  feedback.measured_cp = arm.X_WT;
  feedback.measured_jaw_rad = arm.jaw_rad;
  feedback.operating_state = operating_state_;
  feedback.homed = true;
  return feedback;
}

control::ToolCommand SimulatedArm::setpoint_cp() const {
  return setpoint_of(world_->state(), side_);
}

Status SimulatedArm::servo_cp(const control::ToolCommand& setpoint) {
  return world_->command(side_, {setpoint.X_WT, setpoint.jaw_rad});
}

Status SimulatedArm::reaches(const spatial::Pose& X_WT) const {
  const auto joints = kinematics::inverse(model_, X_WT);
  if (joints) return {};
  return tl::unexpected<Error>(joints.error());
}

}  // namespace trocar::trial
