/// Who moves the left arm, and when: the state machine of a trial (paper, sections II and IV; "Shared control",
/// Authority).
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/control/pedal.h"
#include "engine/core/tick.h"

namespace trocar::control {

enum class ControlState : std::uint8_t {
  kDisconnected,
  kConnected,
  kHomed,
  kChecked,  ///< The arm's frame is confirmed.
  kArmed,
  kReady,     ///< The next trial can begin.
  kOperator,  ///< Through the hand controller.
  kAgent,     ///< While the left pedal is down.
  kClutch,    ///< While the right pedal is down: the hand moves, the tool holds.
  kOutcome,   ///< The trial has ended.
  kReset,     ///< The scene is made ready for the next.
  kHold,      ///< Something is not as it must be; goes on by itself.
  kStopped,   ///< Until it is armed again.
};
constexpr int kControlStates = 13;
/// "operator" …
std::string_view to_string(ControlState state);

/// What one tick tells.
struct ControlLook {
  Tick now;
  bool connected = true;
  bool homed = true;
  bool checked = true;
  bool armed = true;
  bool scene_ready = true;
  bool begin = false;         ///< The trial is started, now.
  bool ended = false;         ///< Its outcome is known.
  bool reset = false;         ///< The next one is asked for, now.
  bool agent_pedal = false;   ///< Level of the left pedal.
  bool clutch_pedal = false;  ///< Level of the right one.
  /// This segment is the agent's (A or C), it knows what to do from where the tool is, and nothing forbids it.
  bool agent_may = false;
  bool fresh = true;  ///< Link, feedback and heartbeat.
  bool fault = false;
  bool stop = false;  ///< Somebody presses stop, now.
};

/// Deterministic. Never two owners; the agent owns the arm only while the left pedal is down without a break since a
/// press that was seen, long enough to be no tap, and after anything that held it only after another press. Threads:
/// one at a time.
class AuthorityMachine {
 public:
  /// Every tick. Returns the state for this tick.
  ControlState look(const ControlLook& look);

  ControlState state() const { return state_; }
  /// The last look changed the state.
  bool changed() const { return changed_; }
  const PedalEvent& agent_pedal() const { return agent_; }
  const PedalEvent& clutch_pedal() const { return clutch_; }
  /// Times the arm went from the operator to the agent or back.
  int hand_overs() const { return hand_overs_; }
  /// The left pedal was down at the first look, and has not come up since: it may be stuck.
  bool agent_pedal_stuck() const { return stuck_; }

 private:
  ControlState next(const ControlLook& look);
  ControlState driving(const ControlLook& look) const;
  static ControlState before_trial(const ControlLook& look);

  Pedal agent_pedal_;
  Pedal clutch_pedal_;
  PedalEvent agent_;
  PedalEvent clutch_;
  ControlState state_ = ControlState::kDisconnected;
  bool changed_ = false;
  bool spent_ = false;  ///< The press that goes on began before a hold: it moves nothing more.
  bool seen_ = false;
  bool stuck_ = false;
  bool running_ = false;
  Tick last_;
  int hand_overs_ = 0;
};

}  // namespace trocar::control
