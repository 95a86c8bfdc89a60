#include "engine/control/authority.h"

#include <array>

namespace trocar::control {
namespace {

/// Between two looks; longer ones are a jump of the clock.
constexpr Tick kLongestSilence{100};

}  // namespace

std::string_view to_string(ControlState state) {
  constexpr std::array<std::string_view, kControlStates> kNames{
      "disconnected", "connected", "homed",   "checked", "armed", "ready",  "operator",
      "agent",        "clutch",    "outcome", "reset",   "hold",  "stopped"};
  return kNames[static_cast<std::size_t>(state)];
}

ControlState AuthorityMachine::before_trial(const ControlLook& look) {
  if (!look.connected) return ControlState::kDisconnected;
  if (!look.homed) return ControlState::kConnected;
  if (!look.checked) return ControlState::kHomed;
  if (!look.armed) return ControlState::kChecked;
  return look.scene_ready ? ControlState::kReady : ControlState::kArmed;
}

ControlState AuthorityMachine::driving(const ControlLook& look) const {
  // Both pedals: the tool holds, whoever would have moved it.
  if (look.clutch_pedal) return ControlState::kClutch;
  return agent_.dead_man && !spent_ && look.agent_may ? ControlState::kAgent : ControlState::kOperator;
}

ControlState AuthorityMachine::next(const ControlLook& look) {
  if (look.stop || look.fault) return ControlState::kStopped;
  if (state_ == ControlState::kStopped) {
    // Only a new arming, which begins with being disarmed, leads out of here.
    return look.armed ? ControlState::kStopped : before_trial(look);
  }
  if (state_ == ControlState::kOutcome) return look.reset ? ControlState::kReset : ControlState::kOutcome;
  if (state_ == ControlState::kReset) return look.scene_ready ? before_trial(look) : ControlState::kReset;
  if (!running_) {
    const ControlState before = before_trial(look);
    return before == ControlState::kReady && look.begin && look.fresh ? driving(look) : before;
  }
  if (look.ended) return ControlState::kOutcome;
  const std::int64_t since = look.now.count - last_.count;
  const bool well = look.fresh && look.connected && look.homed && look.checked && look.armed && since >= 0 &&
                    since <= kLongestSilence.count;
  return well ? driving(look) : ControlState::kHold;
}

ControlState AuthorityMachine::look(const ControlLook& look) {
  if (!seen_) stuck_ = look.agent_pedal;
  if (!look.agent_pedal) stuck_ = false;
  seen_ = true;
  agent_ = agent_pedal_.look(look.agent_pedal, look.now);
  clutch_ = clutch_pedal_.look(look.clutch_pedal, look.now);
  if (!look.agent_pedal) spent_ = false;

  const ControlState before = state_;
  state_ = next(look);
  changed_ = state_ != before;
  running_ = state_ == ControlState::kOperator || state_ == ControlState::kAgent || state_ == ControlState::kClutch ||
             state_ == ControlState::kHold;
  // What goes on after a hold, a stop or the end of the agent's segment is not the agent's by the same press.
  if (look.agent_pedal && (state_ == ControlState::kHold || !running_)) spent_ = true;
  if (before == ControlState::kAgent && state_ == ControlState::kOperator && look.agent_pedal) spent_ = true;
  const bool handed = (before == ControlState::kAgent) != (state_ == ControlState::kAgent);
  if (changed_ && handed) ++hand_overs_;
  last_ = look.now;
  return state_;
}

}  // namespace trocar::control
