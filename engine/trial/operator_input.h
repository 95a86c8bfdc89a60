/// What a person at the console does at one instant, whatever device it comes from: one interface for all inputs.
#pragma once

#include <string_view>

#include "engine/simulation/world_state.h"
#include "engine/spatial/pose.h"

namespace trocar::trial {

/// One hand on its controller, and the pedals. Frame D is the display (see `control::ToolMapping`).
struct HandSample {
  spatial::Pose X_DH;
  double grip_rad = 0.0;      ///< Gripper angle of the hand controller; the jaw follows it.
  bool agent_pedal = false;   ///< Left pedal: the agent may move.
  bool clutch_pedal = false;  ///< Right pedal: the hand moves, the tool holds.
};

/// Asked once every 5 ticks (200 Hz), in simulated time; sees only what the picture shows. Threads: simulation thread.
class OperatorInput {
 public:
  virtual ~OperatorInput() = default;
  virtual HandSample sample(const simulation::WorldState& seen) = 0;
  /// "scripted expert", "keyboard" …
  virtual std::string_view name() const = 0;
};

}  // namespace trocar::trial
