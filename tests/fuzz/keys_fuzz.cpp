// A script of key presses: what is accepted comes in order of its times, ends, and moves a tool nowhere that is not
// finite, whatever the mode.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/kinematics/psm.h"
#include "engine/trial/key_script.h"
#include "engine/trial/tool_hand.h"

namespace {

using namespace trocar;

void play(trial::HandMode mode, const std::vector<trial::KeyStroke>& strokes) {
  constexpr auto kLeft = kinematics::ArmSide::kLeft;
  trial::KeyboardHands keyboard({mode});
  trial::ToolHand hand(mode, {kinematics::ready_pose(kLeft), 0.0});
  for (const trial::KeyStroke& stroke : strokes) {
    if (stroke.act != trial::KeyAct::kDown && stroke.act != trial::KeyAct::kUp) continue;
    for (const trial::HandEvent& event : keyboard.key(stroke.key, stroke.act == trial::KeyAct::kDown)) {
      if (const auto* drive = std::get_if<trial::DriveTool>(&event)) hand.drive(drive->v_WT, drive->w_WT_T);
      if (const auto* step = std::get_if<trial::StepTool>(&event)) hand.step(step->cells);
      if (const auto* shift = std::get_if<trial::ShiftTool>(&event)) hand.shift(shift->by_W_m);
      if (std::holds_alternative<trial::GoToWaypoint>(event)) hand.go();
    }
    for (int sample = 0; sample < 5; ++sample) {
      if (!hand.next().X_WT.finite()) __builtin_trap();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto strokes = trial::parse_key_script({reinterpret_cast<const char*>(data), size});
  if (!strokes) return 0;
  if (strokes->empty() || strokes->back().act != trial::KeyAct::kEnd) __builtin_trap();
  for (std::size_t i = 1; i < strokes->size(); ++i) {
    if ((*strokes)[i].at < (*strokes)[i - 1].at) __builtin_trap();
  }
  for (const auto mode : {trial::HandMode::kContinuous, trial::HandMode::kStep, trial::HandMode::kWaypoint}) {
    play(mode, *strokes);
  }
  return 0;
}
