#include "engine/simulation/grasp.h"

#include <doctest/doctest.h>

#include "engine/core/random.h"
#include "engine/spatial/rotation.h"
#include "engine/spatial/units.h"
#include "tests/unit/simulation/transfer_motion.h"

using namespace trocar::simulation;
using trocar::kinematics::ArmSide;
using trocar::spatial::Pose;

TEST_CASE("a block is gripped by friction, lifted, held, and put back on its peg") {
  for (int block = 0; block < 6; ++block) {
    World world;
    const BlockState& held = world.state().blocks[static_cast<std::size_t>(block)];
    const Pose seated = held.X_WK;
    REQUIRE(take(world, ArmSide::kLeft, block, walls_by_preference(ArmSide::kLeft, seated)[0]));
    CHECK(held.held_by(ArmSide::kLeft));
    REQUIRE(carry(world, ArmSide::kLeft, block, seated.p + Eigen::Vector3d(0, 0, 0.032), 1.0));
    CHECK(held.held_by(ArmSide::kLeft));
    CHECK_FALSE(held.touches_scene);
    CHECK(held.X_WK.p.z() - seated.p.z() > 0.031);
    REQUIRE(carry(world, ArmSide::kLeft, block, seated.p, 1.0));
    REQUIRE(let_go(world, ArmSide::kLeft));
    CHECK_FALSE(held.touched_by(ArmSide::kLeft));
    CHECK((held.X_WK.p - seated.p).norm() < 0.002);
    CHECK(world.state().strained == 0);
  }
}

TEST_CASE("each block goes from its start peg over the hand-off to a goal peg") {
  for (int block = 0; block < 6; ++block) {
    World world({.seed = static_cast<std::uint64_t>(block) + 1});
    const int goal = (block * 5 + 2) % 6;
    const auto status = transfer(world, block, goal);
    if (!status) FAIL(status.error().text());
    CAPTURE(block);
    CAPTURE(miss(world, block, goal).transpose() * 1e3);
    CHECK(placed(world, block, goal));
    CHECK(world.state().strained == 0);
  }
}

TEST_CASE(
    "with the block turned by up to 30 degrees the arms take different walls with hinges within 60 degrees of x") {
  trocar::Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Pose X_WK{{0.0, 0.0, 0.01},
                    trocar::spatial::about_z(trocar::spatial::from_degrees(random.uniform(-29.9, 29.9)))};
    const int left = walls_by_preference(ArmSide::kLeft, X_WK)[0];
    const int right = walls_by_preference(ArmSide::kRight, X_WK)[0];
    CHECK(left == 2);
    CHECK(right == 0);
    for (const int wall : {left, right}) {
      const Pose X_WT = grasp_pose(X_WK, wall);
      CHECK((X_WT.q * Eigen::Vector3d::UnitX()).x() > 0.5);
      CHECK((X_WT.q * Eigen::Vector3d::UnitZ() + Eigen::Vector3d::UnitZ()).norm() < 1e-12);
      CHECK((X_WT.p - X_WK.p).head<2>().norm() == doctest::Approx(0.005));
    }
  }
}
