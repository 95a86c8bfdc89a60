#include <doctest/doctest.h>

#include "engine/simulation/world.h"
#include "tests/unit/simulation/transfer_motion.h"

using namespace trocar::simulation;
using trocar::kinematics::ArmSide;
using trocar::spatial::Pose;

TEST_CASE("a block is gripped by friction, lifted, held, and put back on its peg") {
  for (int block = 0; block < 6; ++block) {
    World world;
    const auto k = static_cast<std::size_t>(block);
    const Pose seated = world.state().blocks[k].X_WK;
    const int wall = walls_by_preference(ArmSide::kLeft, seated)[0];
    take(world, ArmSide::kLeft, block, wall);
    CHECK(world.state().blocks[k].held_by(ArmSide::kLeft));
    const Pose grip = world.state().arm(ArmSide::kLeft).setpoint.X_WT;
                world.state().arm(ArmSide::kLeft).jaw_rad, (world.state().blocks[k].X_WK.p - seated.p).x() * 1e3,
                (world.state().blocks[k].X_WK.p - seated.p).y() * 1e3,
                (world.state().blocks[k].X_WK.p - seated.p).z() * 1e3);
                follow(world, {ArmSide::kLeft, raised(grip, 0.032), kGripCommand_rad, 1.0});
                CHECK(world.state().blocks[k].held_by(ArmSide::kLeft));
                CHECK_FALSE(world.state().blocks[k].touches_scene);
                CHECK(world.state().blocks[k].X_WK.p.z() - seated.p.z() > 0.030);
                follow(world, {ArmSide::kLeft, grip, kGripCommand_rad, 1.0});
                follow(world, {ArmSide::kLeft, grip, kApproachOpening_rad, 0.4});
                follow(world, {ArmSide::kLeft, raised(grip, 0.030), kApproachOpening_rad, 1.0});
                const BlockState& placed = world.state().blocks[k];
                CHECK_FALSE(placed.touched_by(ArmSide::kLeft));
                CHECK((placed.X_WK.p - seated.p).norm() < 0.002);
                CHECK(world.state().strained == 0);
                (long)world.state().strained);
  }
}
