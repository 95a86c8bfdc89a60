/// A gamepad as both hands and the pedals of a console.
#pragma once

#include <array>

#include "engine/link/messages.h"
#include "engine/trial/stick_hands.h"
#include "engine/trial/tool_hand.h"

namespace trocar::link {

/// The sticks give speeds; hands are where these have led them, so that the tool goes as fast as in the window with a
/// trial that maps by `scale` (control::ToolMapping). Threads: one at a time.
class PadHand {
 public:
  /// Precondition: `scale` of 0.1 … 0.5.
  explicit PadHand(double scale) : scale_(scale) {}

  /// At `t_s` with the gamepad as it is then. Times do not run backwards; no step counts for more than 50 ms.
  HandFrame at(double t_s, const trial::GamepadLook& pad);

 private:
  struct Arm {
    OneHand hand{{}, trial::kHandOpen_rad};
    double grip_goal_rad = trial::kHandOpen_rad;
    Eigen::Vector3d v_D{0.0, 0.0, 0.0};  ///< Of the hand, m/s.
    Eigen::Vector3d w_D{0.0, 0.0, 0.0};  ///< rad/s.
  };

  double scale_;
  double t_s_ = 0.0;
  trial::StickHands sticks_;
  std::array<Arm, 2> arms_;
  HandFrame pedals_;  ///< As they are, and how often they were pressed.
};

}  // namespace trocar::link
