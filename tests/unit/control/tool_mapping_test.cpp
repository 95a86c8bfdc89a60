#include "engine/control/tool_mapping.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/control/clutch.h"
#include "engine/core/random.h"
#include "engine/peg_board/peg_board.h"
#include "engine/spatial/rotation.h"

using namespace trocar;
using control::ToolMapping;
using spatial::Pose;

namespace {

Eigen::Quaterniond random_rotation(Random& random) {
  return Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
}

Pose random_pose(Random& random, double reach_m) {
  return {{random.uniform(-reach_m, reach_m), random.uniform(-reach_m, reach_m), random.uniform(-reach_m, reach_m)},
          random_rotation(random)};
}

/// Where the paper's camera shows a point: right and up on the picture (tangents of the angles), and depth in metres.
Eigen::Vector3d in_picture(const Eigen::Vector3d& p_W) {
  const peg_board::PaperCamera camera = peg_board::paper_camera();
  const Eigen::Vector3d forward{-std::cos(camera.pitch_rad), 0.0, std::sin(camera.pitch_rad)};
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  const Eigen::Vector3d up = right.cross(forward);
  const Eigen::Vector3d d = p_W - camera.eye;
  return {right.dot(d) / forward.dot(d), up.dot(d) / forward.dot(d), forward.dot(d)};
}

}  // namespace

TEST_CASE("engaging at any of 10,000 poses does not move the tool") {
  Random random(1);
  double worst_jump_m = 0.0;
  double worst_turn_rad = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const Pose hand = random_pose(random, 0.3);
    const Pose tool = random_pose(random, 0.1);
    ToolMapping mapping(random_rotation(random), random.uniform(0.1, 0.5));
    mapping.engage(hand, tool);
    const Pose out = mapping.map(hand);
    worst_jump_m = std::max(worst_jump_m, (out.p - tool.p).norm());
    worst_turn_rad = std::max(worst_turn_rad, spatial::angle_between(out.q, tool.q));
  }
  CHECK(worst_jump_m == 0.0);
  // Two products of unit quaternions round to a few units of 1.1e-16 in each component; an angle is twice that.
  CHECK(worst_turn_rad < 1.5e-15);
}

TEST_CASE("changing the scale at any of 10,000 hand poses does not move the tool") {
  Random random(2);
  double worst_jump_m = 0.0;
  double worst_turn_rad = 0.0;
  ToolMapping mapping(control::display_rotation());
  mapping.engage(random_pose(random, 0.3), random_pose(random, 0.1));
  for (int i = 0; i < 10000; ++i) {
    const Pose hand = random_pose(random, 0.3);
    const Pose before = mapping.map(hand);
    mapping.set_scale(random.uniform(0.1, 0.5), hand);
    const Pose after = mapping.map(hand);
    worst_jump_m = std::max(worst_jump_m, (after.p - before.p).norm());
    worst_turn_rad = std::max(worst_turn_rad, spatial::angle_between(after.q, before.q));
  }
  CHECK(worst_jump_m == 0.0);
  CHECK(worst_turn_rad < 1.5e-15);
}

TEST_CASE("the scale stays within the menu's range") {
  ToolMapping mapping(control::display_rotation());
  mapping.set_scale(3.0, Pose{});
  CHECK(mapping.scale() == control::kLargestScale);
  mapping.set_scale(0.0, Pose{});
  CHECK(mapping.scale() == control::kSmallestScale);
}

TEST_CASE("the tool moves the hand's way times the scale") {
  ToolMapping mapping(control::display_rotation(), 0.2);
  const Pose tool{{0.01, 0.02, 0.03}, spatial::about_x(0.3)};
  const Pose hand{{0.1, 0.2, 0.3}, spatial::about_y(0.5)};
  mapping.engage(hand, tool);
  Pose moved = hand;
  moved.p += Eigen::Vector3d(0.010, 0.0, 0.0);
  const Pose out = mapping.map(moved);
  CHECK((out.p - tool.p - Eigen::Vector3d(0.0, 0.002, 0.0)).norm() < 1e-15);
}

TEST_CASE("turning the hand about an axis of the display turns the tool about that axis as seen in the board frame") {
  const Eigen::Quaterniond R_WD = control::display_rotation();
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    ToolMapping mapping(R_WD);
    const Pose hand = random_pose(random, 0.1);
    const Pose tool = random_pose(random, 0.1);
    mapping.engage(hand, tool);
    const Eigen::Vector3d axis_D = random_rotation(random) * Eigen::Vector3d::UnitX();
    const Eigen::Quaterniond turn_D(Eigen::AngleAxisd(0.4, axis_D));
    const Eigen::Quaterniond turn_W(Eigen::AngleAxisd(0.4, R_WD * axis_D));
    const Pose out = mapping.map({hand.p, turn_D * hand.q});
    CHECK(spatial::angle_between(out.q, turn_W * tool.q) < 1e-14);
  }
}

TEST_CASE("a push right, up or away moves the tool right, up or away in the paper's picture") {
  const Pose tool{{-0.010, -0.022, 0.050}, Eigen::Quaterniond::Identity()};
  const auto pushed = [&](const Eigen::Vector3d& push_D) {
    ToolMapping mapping(control::display_rotation());
    mapping.engage(Pose{}, tool);
    return Eigen::Vector3d(in_picture(mapping.map(Pose::translation(push_D)).p) - in_picture(tool.p));
  };
  const Eigen::Vector3d right = pushed({0.010, 0.0, 0.0});
  CHECK(right.x() > 0.010);
  CHECK(std::abs(right.y()) < 1e-12);
  CHECK(std::abs(right.z()) < 1e-12);
  const Eigen::Vector3d up = pushed({0.0, 0.010, 0.0});
  CHECK(up.y() > 0.010);
  CHECK(std::abs(up.x()) < 1e-12);
  CHECK(std::abs(up.z()) < 1e-12);
  const Eigen::Vector3d away = pushed({0.0, 0.0, -0.010});
  CHECK(away.z() == doctest::Approx(0.002));
}

TEST_CASE("while the clutch is down the hand moves and the tool holds, and nothing jumps when it comes up") {
  control::ClutchedMapping mapping{ToolMapping(control::display_rotation())};
  Random random(4);
  mapping.take_over(random_pose(random, 0.1), random_pose(random, 0.1));
  const Pose before = mapping.follow(random_pose(random, 0.1), false, Tick{0});
  Pose hand;
  for (int i = 1; i <= 20; ++i) {
    hand = random_pose(random, 0.1);
    CHECK(mapping.follow(hand, true, Tick{5 * i}) == before);
  }
  CHECK(mapping.follow(hand, false, Tick{105}) == before);
  CHECK(mapping.count() == 1);
  hand.p.x() += 0.010;
  CHECK(mapping.follow(hand, false, Tick{110}).p.y() - before.p.y() == doctest::Approx(0.002));
}
