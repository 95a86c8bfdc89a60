#include "ui/take_keys.h"

#include <array>

namespace trocar::ui {
namespace {

using trial::HandKey;
using trial::KeyboardHands;

/// Where the key of the operator is on this keyboard.
Key place_of(HandKey key) {
  if (key == trial::kShiftKey) return Key::kLeftShift;
  if (key == trial::kEnterKey) return Key::kEnter;
  return static_cast<Key>(key);
}

}  // namespace

bool take_goes_on(const WorkbenchState& state) {
  return state.live && state.take && !state.take->reviewing;
}

bool trial_goes_on(const WorkbenchState& state) {
  if (!state.live || !state.live->trial || !state.trials || state.trials->request.console_port) return false;
  return state.trials->request.person || state.trials->request.person_assists;
}

bool TakeKeys::claims(const Chord& chord, const WorkbenchState& state) {
  const bool in_trial = trial_goes_on(state);
  if ((!in_trial && !take_goes_on(state)) || chord.modifiers.control || chord.modifiers.alt) return false;
  if (in_trial) {
    const int key = static_cast<int>(chord.key);
    return chord.key == Key::kSpace || (key > 0 && key < 128 && KeyboardHands::means(static_cast<HandKey>(key)));
  }
  if (chord.key == Key::kEnter) return state.take->request.options.mode == trial::HandMode::kWaypoint;
  // What would play the demonstration that is selected.
  if (chord.key == Key::kSpace) return state.live->status.phase != trial::Phase::kCountdown;
  const int code = static_cast<int>(chord.key);
  return code > 0 && code < 128 && KeyboardHands::means(static_cast<HandKey>(code));
}

std::vector<trial::HandEvent> TakeKeys::follow_gamepad(const std::optional<trial::GamepadLook>& pad,
                                                       const WorkbenchState& state) {
  std::array<bool, 2> drivable{};
  if (trial_goes_on(state)) {
    const workbench::StartTrials& request = state.trials->request;
    if (!request.gamepad) return {};
    drivable = {request.person, request.person_assists};
  } else {
    if (!state.take->request.gamepad) return {};
    const auto& sources = state.take->request.options.sources;
    drivable = {sources[0] == trial::ArmSource::kHand, sources[1] == trial::ArmSource::kHand};
  }
  const auto& arms = state.live->world.arms;
  // One that was pulled out drives no more.
  return stick_.look(pad ? trial::look_of(*pad) : trial::StickLook{}, drivable, {arms[0].X_WT.q, arms[1].X_WT.q});
}

Requests TakeKeys::follow(const Ui& ui, const WorkbenchState& state, bool free) {
  const InputQueue& input = ui.input();
  std::vector<trial::HandEvent> events;
  const bool in_trial = trial_goes_on(state);
  const bool taking = (take_goes_on(state) || in_trial) && free;
  if (taking && !taking_) {
    keyboard_ = KeyboardHands({in_trial ? trial::HandMode::kContinuous : state.take->request.options.mode});
    stick_ = {};
  }
  if (taking) events = follow_gamepad(ui.gamepad(), state);
  if (!taking && taking_) events = keyboard_.release_all();
  taking_ = taking;
  // The left pedal: what has no keyboard any more is let go.
  if (const bool pedal = in_trial && taking && input.down(Key::kSpace); pedal != pedal_) {
    events.emplace_back(trial::HoldAgentPedal{pedal});
    pedal_ = pedal;
  }
  const Modifiers held = input.modifiers();
  for (int code = 1; taking && code < 128; ++code) {
    const auto key = static_cast<HandKey>(code);
    if (!KeyboardHands::means(key)) continue;
    const Key here = place_of(key);
    bool down = input.down(here);
    if (key == trial::kShiftKey) down = held.shift;
    const bool pressed = input.pressed(here) || (key == trial::kShiftKey && down);
    // With Ctrl or Alt it is a command's key; what was held before may still be let go.
    if (pressed && !held.control && !held.alt) {
      for (trial::HandEvent& event : keyboard_.key(key, true)) events.push_back(std::move(event));
    }
    if (down) continue;
    for (trial::HandEvent& event : keyboard_.key(key, false)) events.push_back(std::move(event));
  }
  if (events.empty()) return {};
  return {workbench::Command{workbench::HandInput{std::move(events)}}};
}

}  // namespace trocar::ui
