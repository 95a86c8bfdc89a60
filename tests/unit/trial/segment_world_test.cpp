// Segment C begins with a block in the jaws: for rollouts in the simulator, and for what a person records from there.
#include "engine/trial/segment_world.h"

#include <doctest/doctest.h>

#include "engine/learning/rollout.h"
#include "engine/simulation/world.h"
#include "engine/trial/hand_session.h"
#include "engine/trial/physics_rollout.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::trial;
using demonstration::Segment;
using kinematics::ArmSide;

namespace {

std::string carrying(std::uint64_t seed) {
  TransferOptions options;
  options.seed = seed;
  options.block = 2;
  Progress progress;
  return segment_world(Segment::kC, options, progress).value();
}

/// From the start of C, where a scripted expert lifted block 2 to, up to the cell of the hand-off.
learning::Model carrier(const simulation::WorldState& state) {
  const spatial::Grid grid;
  learning::CellSequence way;
  Eigen::Vector3d tip = state.arm(ArmSide::kLeft).X_WT.p;
  spatial::CellCoordinates cell = grid.coordinates(grid.cell_at(tip).value());
  const spatial::CellCoordinates end = grid.coordinates(grid.cell_at(peg_board::kHandOff_m).value());
  way.push_back(grid.index(cell));
  for (int spatial::CellCoordinates::*axis :
       {&spatial::CellCoordinates::z, &spatial::CellCoordinates::x, &spatial::CellCoordinates::y}) {
    while (cell.*axis != end.*axis) {
      cell.*axis += cell.*axis < end.*axis ? 1 : -1;
      way.push_back(grid.index(cell));
    }
  }
  learning::TrainOptions options;
  options.method = learning::Method::kExact;
  Progress progress;
  return learning::train(grid, {way}, options, progress).value();
}

}  // namespace

TEST_CASE("segment A begins in a new world, C with the block held and lifted, the same each time") {
  Progress progress;
  CHECK(segment_world(Segment::kA, {}, progress).value().empty());
  const std::string bytes = carrying(3);
  CHECK(bytes == carrying(3));
  simulation::World world;
  REQUIRE(world.restore({bytes}));
  CHECK(world.state().blocks[2].held_by(ArmSide::kLeft));
  CHECK(world.state().blocks[2].X_WK.p.z() > peg_board::kPegHeight_m);
  progress.cancel();
  CHECK(segment_world(Segment::kC, {}, progress).error().code() == ErrorCode::kCancelled);
}

TEST_CASE("a rollout of segment C carries the block to the hand-off, and one without a grip has dropped it") {
  const std::string bytes = carrying(1);
  simulation::World world;
  REQUIRE(world.restore({bytes}));
  const learning::Model model = carrier(world.state());
  const auto policy = learning::greedy_policy(model);
  PhysicsOptions options;
  options.segment = Segment::kC;
  options.block = 2;
  const PhysicsRollout held = physics_rollout(model, policy, model.start, options, bytes);
  CHECK(held.end == PhysicsEnd::kArrives);
  CHECK(held.steps > 0);
  PhysicsRollouts many(1);
  Progress progress;
  options.threads = 1;
  REQUIRE(run_physics(model, {model.start}, options, many, progress));
  CHECK(*many.front() == held);

  // The jaws open for half a second, and shut again on nothing.
  for (const double jaw_rad : {0.6, 0.0}) {
    const simulation::ArmCommand now = world.state().arm(ArmSide::kLeft).setpoint;
    for (int tick = 1; tick <= 500; ++tick) {
      const double rad = now.jaw_rad + (jaw_rad - now.jaw_rad) * tick / 500.0;
      REQUIRE(world.command(ArmSide::kLeft, {now.X_WT, rad}));
      world.step();
    }
  }
  const PhysicsRollout lost = physics_rollout(model, policy, model.start, options, world.snapshot().bytes);
  CHECK(lost.end == PhysicsEnd::kDrops);
  CHECK(lost.steps == 0);
}

TEST_CASE("a take can begin in segment C: led to its place with the block, and recorded from there") {
  HandOptions options;
  options.begin_segment = Segment::kC;
  options.block = 2;
  options.countdown_s = 0.0;
  options.begin_p_WT[0] = peg_board::kHandOff_m + Eigen::Vector3d(-0.02, 0.0, 0.01);
  auto session = HandSession::create(options).value();
  for (int i = 0; i < 60'000 && session->status().phase != Phase::kRecording; ++i) session->step();
  REQUIRE(session->status().phase == Phase::kRecording);
  CHECK(session->segment() == Segment::kC);
  CHECK(session->state().blocks[2].held_by(ArmSide::kLeft));
  CHECK((session->state().arm(ArmSide::kLeft).X_WT.p - *options.begin_p_WT[0]).norm() < 1e-3);
  const auto world = session->take_initial_world();
  REQUIRE(world);
  options.initial_world = *world;
  CHECK(HandSession::create(options).error().code() == ErrorCode::kInvalidArgument);
}
