#include "engine/trial/task.h"

#include <doctest/doctest.h>

using namespace trocar;
using demonstration::Outcome;
using demonstration::Segment;
using kinematics::ArmSide;
using trial::Task;

namespace {

/// A world without physics that a test arranges by hand; time passes in samples.
struct Stage {
  simulation::WorldState state;
  Task task{0, 0};

  Stage() {
    for (int i = 0; i < peg_board::kBlockCount; ++i) {
      state.blocks[static_cast<std::size_t>(i)].X_WK.p =
          peg_board::start_peg(i) + Eigen::Vector3d(0.0, 0.0, peg_board::kBlockRest_m);
    }
    for (const ArmSide side : kinematics::kArmSides) {
      state.arms[kinematics::index_of(side)].X_WT = kinematics::ready_pose(side);
    }
  }
  simulation::BlockState& block() { return state.blocks[0]; }
  simulation::ArmState& left() { return state.arms[0]; }
  void contact(ArmSide side, bool both) { block().jaw_contact[kinematics::index_of(side)] = {both, both}; }
  void wait(int ms) {
    for (int i = 0; i < ms; i += demonstration::kTicksPerSample) {
      state.tick.count += demonstration::kTicksPerSample;
      task.update(state);
    }
  }
  /// In the left jaws, at the height of the hand-off.
  void lift() {
    contact(ArmSide::kLeft, true);
    block().X_WK.p = {-0.010, 0.005, 0.042};
    left().X_WT.p = peg_board::kHandOff_m;
    wait(200);
  }
};

}  // namespace

TEST_CASE("a lift attempt takes both jaws and 2 mm for 100 ms") {
  Stage stage;
  stage.contact(ArmSide::kLeft, true);
  stage.block().X_WK.p.z() += 0.0019;
  stage.wait(500);
  CHECK_FALSE(stage.task.lift_attempted());
  stage.block().X_WK.p.z() += 0.0002;
  stage.wait(100);
  CHECK_FALSE(stage.task.lift_attempted());
  stage.wait(10);
  CHECK(stage.task.lift_attempted());
}

TEST_CASE("a block touched by one jaw only is no lift attempt") {
  Stage stage;
  stage.block().jaw_contact[0] = {true, false};
  stage.block().X_WK.p.z() += 0.01;
  stage.wait(500);
  CHECK_FALSE(stage.task.lift_attempted());
}

TEST_CASE("a block that no jaw touches for 100 ms after a lift attempt is dropped") {
  Stage stage;
  stage.lift();
  stage.contact(ArmSide::kLeft, false);
  stage.wait(90);
  CHECK(stage.task.outcome() == Outcome::kUnfinished);
  stage.wait(30);
  CHECK(stage.task.outcome() == Outcome::kDropped);
  REQUIRE(stage.task.decided_at().has_value());
}

TEST_CASE("a block that was never lifted cannot be dropped") {
  Stage stage;
  stage.wait(5000);
  CHECK(stage.task.outcome() == Outcome::kUnfinished);
}

TEST_CASE("success needs the assistant's hold for 200 ms and the user's release") {
  Stage stage;
  stage.lift();
  stage.contact(ArmSide::kRight, true);
  stage.wait(400);
  CHECK(stage.task.outcome() == Outcome::kUnfinished);
  stage.contact(ArmSide::kLeft, false);
  stage.wait(5);
  CHECK(stage.task.outcome() == Outcome::kSuccess);
  CHECK(stage.task.segment() == Segment::kE);
}

TEST_CASE("a release before the assistant held for 200 ms is not yet a success") {
  Stage stage;
  stage.lift();
  stage.contact(ArmSide::kRight, true);
  stage.wait(100);
  stage.contact(ArmSide::kLeft, false);
  stage.wait(90);
  CHECK(stage.task.outcome() == Outcome::kUnfinished);
  stage.wait(50);
  CHECK(stage.task.outcome() == Outcome::kSuccess);
}

TEST_CASE("a drop after the hand-off leaves the success standing but nothing placed") {
  Stage stage;
  stage.lift();
  stage.contact(ArmSide::kRight, true);
  stage.wait(300);
  stage.contact(ArmSide::kLeft, false);
  stage.wait(5);
  stage.contact(ArmSide::kRight, false);
  stage.block().X_WK.p = {0.0, 0.0, peg_board::kBlockRest_m};
  stage.wait(1000);
  CHECK(stage.task.outcome() == Outcome::kSuccess);
  CHECK_FALSE(stage.task.placed());
}

TEST_CASE("placed means on the goal peg within 5 mm and 4 mm, untouched, with both grippers open") {
  Stage stage;
  for (simulation::ArmState& arm : stage.state.arms) arm.jaw_rad = 0.3;
  const Eigen::Vector3d seat = peg_board::goal_peg(0) + Eigen::Vector3d(0.0, 0.0, peg_board::kBlockRest_m);
  const auto placed_at = [&](const Eigen::Vector3d& offset) {
    stage.block().X_WK.p = seat + offset;
    stage.wait(150);
    return stage.task.placed();
  };
  CHECK(placed_at({0.0, 0.0, 0.0}));
  CHECK(placed_at({0.0049, 0.0, 0.0039}));
  CHECK_FALSE(placed_at({0.0, 0.0051, 0.0}));
  CHECK_FALSE(placed_at({0.0, 0.0, 0.0041}));
  CHECK(placed_at({0.0, 0.0, 0.0}));
  stage.state.arms[1].jaw_rad = 0.0;
  CHECK_FALSE(placed_at({0.0, 0.0, 0.0}));
  stage.state.arms[1].jaw_rad = 0.3;
  stage.contact(ArmSide::kRight, true);
  CHECK_FALSE(placed_at({0.0, 0.0, 0.0}));
}

TEST_CASE("jaws that close on air are one miss, and jaws that never opened are none") {
  Stage stage;
  stage.wait(1000);
  CHECK(stage.task.misses() == 0);
  stage.left().jaw_rad = 0.3;
  stage.wait(100);
  stage.left().jaw_rad = 0.0;
  stage.wait(1000);
  CHECK(stage.task.misses() == 1);
}

TEST_CASE("jaws that close on the block are no miss") {
  Stage stage;
  stage.left().jaw_rad = 0.3;
  stage.wait(100);
  stage.left().jaw_rad = 0.034;
  stage.contact(ArmSide::kLeft, true);
  stage.wait(1000);
  CHECK(stage.task.misses() == 0);
}

TEST_CASE("the segments follow one another: over the block, lifted clear, near the hand-off, handed over") {
  Stage stage;
  stage.wait(200);
  CHECK(stage.task.segment() == Segment::kA);
  const Eigen::Vector3d over = stage.block().X_WK.p + Eigen::Vector3d(0.005, 0.0, 0.0);
  stage.left().X_WT.p = {over.x(), over.y(), 0.028};
  stage.wait(100);
  CHECK(stage.task.segment() == Segment::kB);
  stage.contact(ArmSide::kLeft, true);
  stage.left().X_WT.p = {over.x(), over.y(), 0.045};
  stage.block().X_WK.p.z() = 0.042;
  stage.wait(200);
  CHECK(stage.task.segment() == Segment::kC);
  stage.lift();
  CHECK(stage.task.segment() == Segment::kD);
  stage.contact(ArmSide::kRight, true);
  stage.wait(300);
  stage.contact(ArmSide::kLeft, false);
  stage.wait(5);
  CHECK(stage.task.segment() == Segment::kE);
}

TEST_CASE("passing over the block without stopping does not end the approach") {
  Stage stage;
  const Eigen::Vector3d start = stage.block().X_WK.p + Eigen::Vector3d(0.020, 0.0, 0.022);
  for (int i = 0; i < 160; ++i) {
    stage.left().X_WT.p = start - Eigen::Vector3d(0.00025 * i, 0.0, 0.0);  // 50 mm/s
    stage.wait(5);
  }
  CHECK(stage.task.segment() == Segment::kA);
}
