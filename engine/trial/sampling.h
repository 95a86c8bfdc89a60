/// From the world's state to a sample of a recording.
#pragma once

#include <array>

#include "engine/demonstration/recording.h"
#include "engine/simulation/world_state.h"
#include "engine/trial/arm_drive.h"
#include "engine/trial/task.h"

namespace trocar::trial {

/// What the sample holds besides the world.
struct SampleContext {
  int block = 0;                                  ///< The target, for the contact flags.
  std::array<control::ToolCommand, 2> setpoints;  ///< By `kinematics::index_of`, exact.
  bool agent_pedal = false;
  bool clutch_pedal = false;
  demonstration::Authority authority = demonstration::Authority::kOperator;
  demonstration::Segment segment = demonstration::Segment::kA;
};

demonstration::Sample make_sample(const simulation::WorldState& state, const SampleContext& context);

/// Where the arm was last told to be.
control::ToolCommand setpoint_of(const simulation::WorldState& state, kinematics::ArmSide side);

/// The setpoint as it was recorded, bit for bit.
control::ToolCommand recorded_setpoint(const demonstration::ArmSample& arm);

}  // namespace trocar::trial
