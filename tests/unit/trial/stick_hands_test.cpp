#include "engine/trial/stick_hands.h"

#include <doctest/doctest.h>

#include "engine/trial/tool_hand.h"

using namespace trocar;
using namespace trocar::trial;
using kinematics::ArmSide;

namespace {

const std::array<Eigen::Quaterniond, 2> kDown{kinematics::pointing_down(0.0), kinematics::pointing_down(0.0)};
constexpr std::array<bool, 2> kBoth{true, true};

std::vector<HandEvent> looked(StickHands& stick, const GamepadLook& pad, std::array<bool, 2> drivable = kBoth) {
  return stick.look(look_of(pad), drivable, kDown);
}

}  // namespace

TEST_CASE("sticks move the tool right, away and up, and a stick at rest moves nothing") {
  StickHands stick;
  GamepadLook pad;
  pad.axes = {0.1F, -0.1F, 0.05F, 0.1F, -1.0F, -1.0F};
  CHECK(looked(stick, pad).empty());
  pad.axes = {1.0F, -1.0F, 0.0F, -1.0F, -1.0F, -1.0F};
  const auto events = looked(stick, pad);
  REQUIRE(events.size() == 1);
  const auto& drive = std::get<DriveTool>(events[0]);
  CHECK(drive.v_WT.y() == doctest::Approx(0.060));
  CHECK(drive.v_WT.x() == doctest::Approx(-0.060));
  CHECK(drive.v_WT.z() == doctest::Approx(0.060));
  CHECK(looked(stick, pad).empty());
}

TEST_CASE("a stick pushed to the right turns a tool that points down to the right as seen from above") {
  StickHands stick;
  GamepadLook pad;
  pad.axes[2] = 1.0F;
  const auto drive = std::get<DriveTool>(looked(stick, pad).at(0));
  const Eigen::Vector3d w_W = kDown[0] * drive.w_WT_T;
  CHECK(w_W.z() < -0.5);
  CHECK(std::abs(w_W.x()) < 1e-9);
}

TEST_CASE("buttons act when they go down, and the other arm is taken only if it can be driven") {
  StickHands stick;
  GamepadLook pad;
  pad.buttons = 1U << 0;
  CHECK(std::holds_alternative<ToggleJaw>(looked(stick, pad).at(0)));
  CHECK(looked(stick, pad).empty());
  pad.buttons = 1U << 3;
  looked(stick, pad);
  CHECK(stick.arm() == ArmSide::kRight);
  pad.buttons = 0;
  looked(stick, pad, {true, false});
  CHECK(stick.arm() == ArmSide::kLeft);
  pad.buttons = 1U << 3;
  looked(stick, pad, {true, false});
  CHECK(stick.arm() == ArmSide::kLeft);
}

TEST_CASE("the right bumper makes it slow") {
  StickHands stick;
  GamepadLook pad;
  pad.axes[0] = 1.0F;
  pad.buttons = 1U << 5;
  CHECK(std::get<DriveTool>(looked(stick, pad).at(0)).v_WT.norm() == doctest::Approx(0.012));
}

TEST_CASE("a SpaceMouse pushed right, up and away moves the tool so, and a stuck axis cannot exceed full speed") {
  const auto moved = [](std::array<int, 6> axes) {
    StickHands stick;
    return std::get<DriveTool>(stick.look(look_of_space_mouse(axes, 0), kBoth, kDown).at(0)).v_WT;
  };
  CHECK(moved({350, 0, 0, 0, 0, 0}).y() == doctest::Approx(0.060));
  CHECK(moved({0, 350, 0, 0, 0, 0}).z() == doctest::Approx(0.060));
  CHECK(moved({0, 0, 350, 0, 0, 0}).x() == doctest::Approx(-0.060));
  CHECK(moved({100'000, 0, 0, 0, 0, 0}).y() == doctest::Approx(0.060));
}

TEST_CASE("the left bumper is the agent's pedal: down as long as it is held") {
  StickHands stick;
  GamepadLook pad;
  pad.buttons = 1U << 4;
  CHECK(std::get<HoldAgentPedal>(looked(stick, pad).at(0)).down);
  CHECK(looked(stick, pad).empty());
  pad.buttons = 0;
  CHECK_FALSE(std::get<HoldAgentPedal>(looked(stick, pad).at(0)).down);
}
