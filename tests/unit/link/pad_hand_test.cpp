// A gamepad as a console's hands.
#include "engine/link/pad_hand.h"

#include <doctest/doctest.h>

#include "engine/control/tool_mapping.h"

using namespace trocar;
using namespace trocar::link;

namespace {

constexpr double kScale = 0.2;

/// The last of a second at 200 Hz from `begin_s` on.
HandFrame held(PadHand& hand, const trial::GamepadLook& pad, double begin_s) {
  HandFrame frame;
  for (int i = 1; i <= 200; ++i) frame = hand.at(begin_s + i / 200.0, pad);
  return frame;
}

trial::GamepadLook with_axis(std::size_t axis, float value) {
  trial::GamepadLook pad;
  pad.axes[axis] = value;
  return pad;
}

trial::GamepadLook with_button(unsigned button) {
  trial::GamepadLook pad;
  pad.buttons = 1U << button;
  return pad;
}

}  // namespace

TEST_CASE("a full stick leads the tool at 60 mm/s by the mapping of the trial") {
  PadHand hand(kScale);
  control::ToolMapping mapping(control::display_rotation(), kScale);
  mapping.engage(hand.at(0.0, {}).left.X_DH, {});
  // Right on the stick is +y of the board.
  const spatial::Pose X_WT = mapping.map(held(hand, with_axis(0, 1.0F), 0.0).left.X_DH);
  CHECK((X_WT.p - Eigen::Vector3d(0.0, 0.060, 0.0)).norm() < 1e-9);
  // A turn about the vertical turns the tool by so much, and moves nothing.
  const spatial::Pose turned = mapping.map(held(hand, with_axis(2, -1.0F), 1.0).left.X_DH);
  CHECK((turned.p - X_WT.p).norm() < 1e-9);
  CHECK(spatial::angle_between(turned.q, Eigen::Quaterniond(Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitZ()))) < 1e-6);
}

TEST_CASE("a gamepad's buttons shut jaws, press pedals and change arms") {
  PadHand hand(kScale);
  CHECK(hand.at(0.0, {}).left.grip_rad == trial::kHandOpen_rad);
  const double first_rad = hand.at(0.005, with_button(0)).left.grip_rad;
  CHECK(first_rad < trial::kHandOpen_rad);
  CHECK(first_rad > trial::kHandOpen_rad - 0.01);
  CHECK(held(hand, with_button(0), 0.005).left.grip_rad == trial::kHandGrip_rad);
  HandFrame frame = hand.at(2.0, with_button(4));
  CHECK(frame.agent_pedal);
  CHECK(frame.agent_presses == 1);
  CHECK_FALSE(frame.clutch_pedal);
  CHECK_FALSE(hand.at(2.005, {}).agent_pedal);
  CHECK(hand.at(2.010, with_button(4)).agent_presses == 2);
  static_cast<void>(hand.at(2.015, with_button(3)));
  frame = held(hand, with_axis(0, 1.0F), 2.015);
  CHECK(frame.left.X_DH.p.norm() == 0.0);
  CHECK(frame.right.X_DH.p.norm() > 0.1);
}

TEST_CASE("while the clutch is held a gamepad's hand rests, and a long silence is no leap") {
  PadHand hand(kScale);
  trial::GamepadLook pad = with_axis(0, 1.0F);
  pad.buttons = 1U << 1U;
  const HandFrame clutched = held(hand, pad, 0.0);
  CHECK(clutched.clutch_pedal);
  CHECK(clutched.clutch_presses == 1);
  CHECK(clutched.left.X_DH.p.norm() == 0.0);
  static_cast<void>(hand.at(1.005, with_axis(0, 1.0F)));
  const Eigen::Vector3d before = hand.at(1.010, with_axis(0, 1.0F)).left.X_DH.p;
  CHECK((hand.at(9.0, with_axis(0, 1.0F)).left.X_DH.p - before).norm() < 0.0151);
}
