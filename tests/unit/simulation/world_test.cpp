#include "engine/simulation/world.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "engine/core/random.h"
#include "engine/spatial/rotation.h"
#include "engine/spatial/units.h"
#include "tests/unit/simulation/transfer_motion.h"

using namespace trocar::simulation;
using trocar::ErrorCode;
using trocar::kinematics::ArmSide;
using trocar::spatial::angle_between;
using trocar::spatial::Pose;

namespace {

constexpr double kMillimetre = 1e-3;

void wait(World& world, double seconds) {
  const int ticks = static_cast<int>(seconds * world.options().ticks_per_second);
  for (int i = 0; i < ticks; ++i) world.step();
}

/// X_TK of the block in the left tool's frame: it changes only when the grip slips.
Pose in_grip(const World& world, std::size_t block) {
  return world.state().arm(ArmSide::kLeft).X_WT.inverse() * world.state().blocks[block].X_WK;
}

World world_with_lifted_block(const WorldOptions& options = {}) {
  World world(options);
  REQUIRE(take(world, ArmSide::kLeft, 1, 2));
  REQUIRE(carry(world, ArmSide::kLeft, 1, world.state().blocks[1].X_WK.p + Eigen::Vector3d(0, 0, 0.032), 1.0));
  return world;
}

}  // namespace

TEST_CASE("at the start each block stands on its start peg, turned by at most 30 degrees, and both tools are ready") {
  const World world({.seed = 21});
  for (int i = 0; i < 6; ++i) {
    const Pose& X_WK = world.state().blocks[static_cast<std::size_t>(i)].X_WK;
    const Eigen::Vector3d seat = trocar::peg_board::start_peg(i) + Eigen::Vector3d(0, 0, 0.00725);
    CHECK((X_WK.p - seat).norm() < 1e-9);
    CHECK(angle_between(X_WK.q, Eigen::Quaterniond::Identity()) <= trocar::spatial::from_degrees(30.0));
  }
  for (const ArmSide side : trocar::kinematics::kArmSides) {
    CHECK(world.state().arm(side).X_WT == trocar::kinematics::ready_pose(side));
    CHECK(std::abs(world.state().arm(side).jaw_rad) < 1e-9);
  }
}

TEST_CASE("blocks at rest fall asleep and stay where they are") {
  World world;
  wait(world, 0.5);
  const WorldState before = world.state();
  for (const BlockState& block : before.blocks) {
    CHECK(block.asleep);
    CHECK(block.touches_scene);
  }
  wait(world, 10.0);
  for (std::size_t i = 0; i < before.blocks.size(); ++i) CHECK(world.state().blocks[i].X_WK == before.blocks[i].X_WK);
}

TEST_CASE("a block kept awake by a gripper above it stays within a hundredth of a millimetre for 20 s") {
  World world;
  const Pose above = raised(grasp_pose(world.state().blocks[1].X_WK, 2), 0.018);
  REQUIRE(follow(world, {ArmSide::kLeft, above, 0.0, 1.0}));
  const Pose before = world.state().blocks[1].X_WK;
  wait(world, 20.0);
  CHECK_FALSE(world.state().blocks[1].asleep);
  CHECK((world.state().blocks[1].X_WK.p - before.p).norm() < 0.01 * kMillimetre);
}

TEST_CASE("the jaws follow the command over air, stop at the wall, and grip no harder than the servo's limit") {
  World world;
  const Pose ready = trocar::kinematics::ready_pose(ArmSide::kLeft);
  REQUIRE(follow(world, {ArmSide::kLeft, ready, 0.6, 0.5}));
  wait(world, 0.1);
  CHECK(world.state().arm(ArmSide::kLeft).jaw_rad == doctest::Approx(0.6).epsilon(1e-3));
  REQUIRE(follow(world, {ArmSide::kLeft, ready, kGripCommand_rad, 0.5}));
  wait(world, 0.1);
  CHECK(std::abs(world.state().arm(ArmSide::kLeft).jaw_rad) < 1e-3);
  REQUIRE(take(world, ArmSide::kLeft, 1, 2));
  const double gripping_rad = world.state().arm(ArmSide::kLeft).jaw_rad;
  CHECK(gripping_rad > 0.02);
  ArmCommand harder = world.state().arm(ArmSide::kLeft).setpoint;
  harder.jaw_rad = trocar::spatial::from_degrees(-40.0);
  REQUIRE(world.command(ArmSide::kLeft, harder));
  wait(world, 0.5);
  CHECK(world.state().arm(ArmSide::kLeft).jaw_rad == doctest::Approx(gripping_rad).epsilon(0.01));
}

TEST_CASE("held for 60 s by friction alone a block slips by less than a hundredth of a millimetre") {
  World world = world_with_lifted_block();
  wait(world, 0.5);
  const Pose before = in_grip(world, 1);
  wait(world, 60.0);
  const Pose after = in_grip(world, 1);
  CHECK((after.p - before.p).norm() < 0.01 * kMillimetre);
  CHECK(angle_between(before.q, after.q) < trocar::spatial::from_degrees(0.05));
}

TEST_CASE("shaken hard for 10 s a held block slips by less than a tenth of a millimetre") {
  World world = world_with_lifted_block();
  const ArmCommand still = world.state().arm(ArmSide::kLeft).setpoint;
  const Pose before = in_grip(world, 1);
  for (int i = 0; i < 10'000; ++i) {
    ArmCommand command = still;
    const double t_s = i * 1e-3;
    const double ramp = std::min(1.0, t_s);
    // 5 mm at 5 Hz is 5 m/s²; the three axes go out of step.
    command.X_WT.p +=
        5.0 * kMillimetre * ramp * Eigen::Vector3d(std::sin(31.4 * t_s), std::sin(33.0 * t_s), std::sin(35.0 * t_s));
    REQUIRE(world.command(ArmSide::kLeft, command));
    world.step();
  }
  REQUIRE(follow(world, {ArmSide::kLeft, still.X_WT, kGripCommand_rad, 0.5}));
  CHECK(world.state().blocks[1].held_by(ArmSide::kLeft));
  CHECK((in_grip(world, 1).p - before.p).norm() < 0.1 * kMillimetre);
}

TEST_CASE("with jaws that hardly reach the wall, or hardly rub, some blocks are lost on the way") {
  const auto lost = [](const WorldOptions& options, double overlap_m) {
    int count = 0;
    for (int block = 0; block < 6; ++block) {
      World world(options);
      const Eigen::Vector3d error(0, 0, trocar::peg_board::kBlockHeight_m / 2.0 - kGraspAboveCentre_m - overlap_m);
      const auto status = transfer(world, block, block, &World::step, error);
      if (!status || !placed(world, block, block)) ++count;
    }
    return count;
  };
  CHECK(lost({}, 0.004) == 0);
  CHECK(lost({}, 0.0001) > 0);
  CHECK(lost({.jaw_friction = 0.02, .grip_torque_nm = 0.002}, 0.004) > 0);
}

TEST_CASE("a block that is let go in the air falls freely, lands, and comes to rest") {
  World world = world_with_lifted_block();
  Pose aside = world.state().arm(ArmSide::kLeft).X_WT;
  aside.p.x() -= 0.023;  // between the pegs
  REQUIRE(follow(world, {ArmSide::kLeft, aside, kGripCommand_rad, 1.0}));
  const double height = world.state().blocks[1].X_WK.p.z();
  REQUIRE(follow(world, {ArmSide::kLeft, aside, kApproachOpening_rad, 0.1}));
  wait(world, 0.05);
  CHECK(world.state().blocks[1].X_WK.p.z() < height - 0.002);
  wait(world, 5.0);
  CHECK(world.state().blocks[1].touches_scene);
  CHECK(world.state().blocks[1].v_WK.norm() < 0.001);
}

TEST_CASE("transfers with up to half a millimetre of aim error all end on the goal peg") {
  trocar::Random random(8);
  for (int i = 0; i < 12; ++i) {
    World world({.seed = random.next()});
    Eigen::Vector3d error;
    for (double& x : error) x = random.uniform(-0.5, 0.5) * kMillimetre;
    REQUIRE(transfer(world, i % 6, (i * 5) % 6, &World::step, error));
    CHECK(placed(world, i % 6, (i * 5) % 6));
    CHECK(world.state().strained == 0);
  }
}

TEST_CASE("closed jaws that sweep through a sleeping block wake it and push it") {
  World world;
  wait(world, 0.3);
  REQUIRE(world.state().blocks[1].asleep);
  const Pose start = world.state().blocks[1].X_WK;
  Pose tool = trocar::kinematics::ready_pose(ArmSide::kLeft);
  tool.p = start.p + Eigen::Vector3d(0.014, 0.0, 0.0);
  REQUIRE(follow(world, {ArmSide::kLeft, raised(tool, 0.02), 0.0, 1.0}));
  REQUIRE(follow(world, {ArmSide::kLeft, tool, 0.0, 1.0}));
  tool.p.x() -= 0.007;
  REQUIRE(follow(world, {ArmSide::kLeft, tool, 0.0, 1.0}));
  CHECK_FALSE(world.state().blocks[1].asleep);
  CHECK(world.state().blocks[1].X_WK.p.x() < start.p.x() - 0.001);
}

TEST_CASE("a command that is not finite, out of reach or beyond the jaws' limits is refused and the setpoint stays") {
  World world;
  const ArmCommand before = world.state().arm(ArmSide::kRight).setpoint;
  ArmCommand command = before;
  command.X_WT.p.y() = std::numeric_limits<double>::quiet_NaN();
  CHECK(world.command(ArmSide::kRight, command).error().code() == ErrorCode::kInvalidArgument);
  command = before;
  command.X_WT.p.z() = -0.3;
  const auto far = world.command(ArmSide::kRight, command);
  CHECK(far.error().code() == ErrorCode::kOutOfReach);
  CHECK(far.error().text().find("the insertion joint would be") == 0);
  command = before;
  command.jaw_rad = trocar::spatial::from_degrees(81.0);
  CHECK(world.command(ArmSide::kRight, command).error().text() == "the jaws would be 1.0° beyond their limit of 80°");
  command.jaw_rad = std::numeric_limits<double>::infinity();
  CHECK(world.command(ArmSide::kRight, command).error().code() == ErrorCode::kInvalidArgument);
  CHECK(world.state().arm(ArmSide::kRight).setpoint.X_WT == before.X_WT);
  CHECK(world.state().arm(ArmSide::kRight).setpoint.jaw_rad == before.jaw_rad);
}

TEST_CASE("arms rammed through board, pegs and blocks for 20 s leave a world that still steps and has finite poses") {
  World world;
  trocar::Random random(2);
  for (int i = 0; i < 20'000; ++i) {
    if (i % 40 == 0) {
      for (const ArmSide side : trocar::kinematics::kArmSides) {
        const Pose X_WT{{random.uniform(-0.04, 0.02), random.uniform(-0.05, 0.05), random.uniform(-0.02, 0.03)},
                        trocar::kinematics::pointing_down(random.uniform(-1.0, 1.0))};
        REQUIRE(world.command(side, {X_WT, random.uniform(-0.6, 1.3)}));
      }
    }
    world.step();
  }
  for (const BlockState& block : world.state().blocks) {
    CHECK(block.X_WK.finite());
    CHECK(block.X_WK.p.norm() < 10.0);
  }
  World again;
  CHECK(again.restore(world.snapshot()));
}
