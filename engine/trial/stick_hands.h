/// A gamepad or a mouse of six axes as the operator's hand: from how far it is pushed to what the tool does.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/trial/hand_event.h"

namespace trocar::trial {

/// One look at a gamepad, in the order that GLFW and SDL have: axes left x, left y, right x, right y, left trigger,
/// right trigger (sticks: right and down are positive; triggers rest at −1); buttons A, B, X, Y, left and right bumper.
struct GamepadLook {
  std::array<float, 6> axes{0.0F, 0.0F, 0.0F, 0.0F, -1.0F, -1.0F};
  std::uint32_t buttons = 0;  ///< Bit i: the i-th is down.
};

/// How far a hand is pushed and what it presses, whatever the device. Axes from −1 to 1.
struct StickLook {
  Eigen::Vector3d move_W{0.0, 0.0, 0.0};
  Eigen::Vector3d turn_W{0.0, 0.0, 0.0};
  bool jaw = false;
  bool clutch = false;
  bool agent = false;  ///< The left pedal of a trial.
  bool other_arm = false;
  bool fine = false;
};
/// Left stick: left, right, away and towards; right stick: up, down and turn; A jaws, B clutch, Y the other arm, right
/// bumper fine, left bumper the agent's pedal.
StickLook look_of(const GamepadLook& pad);
/// A SpaceMouse's axes as libspnav has them (x right, y up, z away, ±350 at most, and turns about these) and its
/// buttons: the first is the jaws, the second the other arm.
StickLook look_of_space_mouse(const std::array<int, 6>& axes, std::uint32_t buttons);

/// Threads: one at a time.
class StickHands {
 public:
  /// What changed since the last look. `drivable`: the arms that the operator drives, by `kinematics::index_of`;
  /// `q_WT`: how the tools are turned.
  std::vector<HandEvent> look(const StickLook& now, const std::array<bool, 2>& drivable,
                              const std::array<Eigen::Quaterniond, 2>& q_WT);
  kinematics::ArmSide arm() const { return arm_; }

 private:
  kinematics::ArmSide arm_ = kinematics::ArmSide::kLeft;
  StickLook last_;
  DriveTool sent_;
};

}  // namespace trocar::trial
