/// What of a trial is shown while it runs.
#pragma once

#include <string>

#include "engine/control/authority.h"
#include "engine/trial/trial_options.h"

namespace trocar::trial {

struct TrialStatus {
  control::ControlState state = control::ControlState::kReady;
  bool agent_pedal = false;
  bool clutch_pedal = false;
  int agent_presses = 0;
  bool pedal_stuck = false;
  Agent::State agent = Agent::State::kIdle;
  std::string agent_refusal;  ///< Why the agent cannot have the arm now; "" if it can.
  std::string guard;          ///< Why the guard holds; "" if it does not.
  double tool_speed_m_s = 0.0;
  double to_block_m = 0.0;
  double error_m = 0.0;  ///< From where the tool was told to be to where it is.
  double delay_s = 0.0;  ///< Of the last message.
  double segment_s = 0.0;
  TrialCounts counts;
};

}  // namespace trocar::trial
