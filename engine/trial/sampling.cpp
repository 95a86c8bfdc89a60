#include "engine/trial/sampling.h"

namespace trocar::trial {

using demonstration::CompactPose;
using kinematics::ArmSide;

demonstration::Sample make_sample(const simulation::WorldState& state, const SampleContext& context) {
  demonstration::Sample sample;
  sample.tick = state.tick.count;
  for (std::size_t i = 0; i < 2; ++i) {
    demonstration::ArmSample& arm = sample.arms[i];
    arm.set_setpoint(context.setpoints[i].X_WT, context.setpoints[i].jaw_rad);
    arm.measured = CompactPose::from(state.arms[i].X_WT);
    arm.jaw_rad = static_cast<float>(state.arms[i].jaw_rad);
    for (std::size_t k = 0; k < arm.joints.size(); ++k) arm.joints[k] = static_cast<float>(state.arms[i].joints[k]);
  }
  for (std::size_t i = 0; i < sample.blocks.size(); ++i) sample.blocks[i] = CompactPose::from(state.blocks[i].X_WK);

  const simulation::BlockState& block = state.blocks[static_cast<std::size_t>(context.block)];
  if (context.agent_pedal) sample.flags |= demonstration::kAgentPedal;
  if (context.clutch_pedal) sample.flags |= demonstration::kClutchPedal;
  if (block.held_by(ArmSide::kLeft)) sample.flags |= demonstration::kLeftHolds;
  if (block.held_by(ArmSide::kRight)) sample.flags |= demonstration::kRightHolds;
  sample.authority = context.authority;
  sample.segment = context.segment;
  return sample;
}

control::ToolCommand setpoint_of(const simulation::WorldState& state, ArmSide side) {
  const simulation::ArmCommand& setpoint = state.arm(side).setpoint;
  return {setpoint.X_WT, setpoint.jaw_rad};
}

control::ToolCommand recorded_setpoint(const demonstration::ArmSample& arm) {
  return {arm.setpoint(), arm.setpoint_jaw_rad};
}

}  // namespace trocar::trial
