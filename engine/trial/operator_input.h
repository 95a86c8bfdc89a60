/// What a person at the console does at one instant, whatever device it comes from: one interface for all inputs.
#pragma once

#include <optional>
#include <string_view>

#include "engine/core/tick.h"
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

/// How the way from the person to us stands, as the guard is shown it (rules 5 to 7).
struct LinkState {
  bool connected = true;  ///< The other end is there.
  bool present = true;    ///< The person says so of themselves: the dead-man.
  Tick stamp;             ///< When that was last heard, in the session's ticks.
};

/// Asked once every 5 ticks (200 Hz), in simulated time; sees only what the picture shows. Threads: simulation thread.
class OperatorInput {
 public:
  virtual ~OperatorInput() = default;
  virtual HandSample sample(const simulation::WorldState& seen) = 0;
  /// Asked in the ticks between: what must not wait for the next sample, as a pedal that went up.
  virtual std::optional<HandSample> news(Tick now) {
    static_cast<void>(now);
    return std::nullopt;
  }
  /// Asked every tick, after the hand. What sits in the same program is always there.
  virtual LinkState link(Tick now) { return {true, true, now}; }
  /// "scripted expert", "keyboard" …
  virtual std::string_view name() const = 0;
};

}  // namespace trocar::trial
