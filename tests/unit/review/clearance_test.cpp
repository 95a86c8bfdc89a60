#include "engine/review/clearance.h"

#include <doctest/doctest.h>

#include "engine/core/random.h"
#include "engine/demonstration/edits.h"
#include "engine/review/sweep.h"
#include "engine/simulation/gripper.h"
#include "engine/simulation/physics.h"
#include "tests/support/document_samples.h"
#include "tests/support/recorded_transfer.h"

using namespace trocar;
using namespace trocar::review;
using demonstration::Demonstration;
using demonstration::Sample;

namespace {

/// The same distance without any memory of the samples before: every pair of shapes of the scene in this one.
double brute_force(const Sample& sample, std::size_t arm, Obstacle obstacle, int carried) {
  Sample alone = sample;
  demonstration::Recording recording;
  recording.provenance.block = carried;
  recording.samples = {alone, alone};
  recording.samples[1].tick += 5;
  const Demonstration document =
      demonstration::make_demonstration({1}, "One", std::make_shared<const demonstration::Recording>(recording))
          .value();
  ClearanceMaker maker;
  return static_cast<double>(maker.make(document)[0][arm].nearest[static_cast<std::size_t>(obstacle)].distance_m);
}

}  // namespace

TEST_CASE("a tool has the simulation's shapes in the simulation's places") {
  using namespace simulation;
  Random random(2);
  const Physics physics = make_physics();
  for (const kinematics::ArmSide side : kinematics::kArmSides) {
    const kinematics::PsmModel model = kinematics::psm_model(side);
    const Gripper& gripper = physics.grippers[kinematics::index_of(side)];
    int reached = 0;
    for (int i = 0; i < 100; ++i) {
      spatial::Pose X_WT = kinematics::ready_pose(side);
      X_WT.p += Eigen::Vector3d(random.uniform(-0.03, 0.03), random.uniform(-0.02, 0.02), random.uniform(-0.03, 0.0));
      X_WT.q = X_WT.q *
               Eigen::Quaterniond(1.0, random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3))
                   .normalized();
      const auto joints = kinematics::inverse(model, X_WT);
      if (!joints) continue;
      ++reached;
      const double jaw_rad = random.uniform(0.0, 1.2);
      place(gripper, {X_WT, kinematics::skeleton(model, *joints)}, jaw_rad);
      const ToolShape shape = tool_shape(model, X_WT, jaw_rad);
      const std::array<dBodyID, 4> bodies{gripper.links[1].body.get(), gripper.links[0].body.get(),
                                          gripper.jaws[0].body.get(), gripper.jaws[1].body.get()};
      for (std::size_t part = 0; part < kPartCount; ++part) {
        const spatial::Pose pose = pose_of(bodies[part]);
        CHECK((shape[part].p - pose.p).norm() < 1e-9);
        CHECK(std::abs(shape[part].R.col(2).dot(pose.q * Eigen::Vector3d::UnitZ())) > 1.0 - 1e-9);
      }
      dReal radius = 0.0;
      dReal length = 0.0;
      dGeomCapsuleGetParams(gripper.links[1].capsule.get(), &radius, &length);
      CHECK(shape[0].half_m.z() == doctest::Approx(0.5 * length / kOdeLength));
      CHECK(shape[0].radius_m == doctest::Approx(radius / kOdeLength));
      dVector3 size;
      dGeomBoxGetLengths(gripper.jaws[0].box.get(), size);
      CHECK((shape[2].half_m - 0.5 * from_ode(size)).norm() < 1e-12);
    }
    CHECK(reached > 50);
  }
}

TEST_CASE("what is passed over while sweeping changes no distance") {
  const Demonstration document = testing::transfer(1);
  ClearanceMaker maker;
  const ClearanceCurve curve = maker.make(document);
  const demonstration::SampleTrack samples = document.gated();
  REQUIRE(curve.size() == samples.size());
  for (std::size_t i = 0; i < samples.size(); i += 23) {
    for (std::size_t arm = 0; arm < 2; ++arm) {
      for (std::size_t k = 0; k < kObstacleCount; ++k) {
        const double alone = brute_force(samples[i], arm, static_cast<Obstacle>(k), document.block);
        CHECK(static_cast<double>(curve[i][arm].nearest[k].distance_m) == doctest::Approx(alone).epsilon(1e-4));
      }
    }
  }
}

TEST_CASE("only what an edit touched is worked out again, and gives what working out everything gives") {
  const Demonstration before = testing::transfer(1);
  ClearanceMaker maker;
  const ClearanceCurve first = maker.make(before);
  CHECK(maker.worked_out() == before.gated().size());
  maker.make(before);
  CHECK(maker.worked_out() == 0);
  demonstration::MoveTool move;
  move.at_s = 12.0;
  move.by_m = {0.0, 0.004, 0.0};
  const Demonstration moved = apply(before, move).value();
  demonstration::DeleteSpan cut;
  cut.from_s = 3.0;
  cut.to_s = 3.5;
  const Demonstration shorter = apply(moved, cut).value();
  for (const Demonstration& document : {moved, shorter}) {
    const ClearanceCurve found = maker.make(document);
    // A second of 25 was moved, and nothing but two seams is new where half a second was cut out.
    CHECK(maker.worked_out() < before.gated().size() / 3);
    CHECK(maker.worked_out() > 0);
    ClearanceMaker afresh;
    const ClearanceCurve all = afresh.make(document);
    REQUIRE(found.size() == all.size());
    for (std::size_t i = 0; i < all.size(); i += 7) {
      for (std::size_t arm = 0; arm < 2; ++arm) CHECK(found[i][arm].least_m() == all[i][arm].least_m());
    }
  }
}

TEST_CASE("a tool that is moved onto a peg is as deep in it as it was moved too far") {
  const Demonstration document = testing::moving_demonstration(400);
  Sample sample = document.samples[0];
  // The closed jaws point straight down beside goal peg 0, their flat side towards it.
  const Eigen::Vector3d peg = peg_board::goal_peg(0);
  const double thickness_m = 0.0014;
  for (const double gap_m : {0.004, 0.0, -0.0008}) {
    const Eigen::Vector3d tip = peg + Eigen::Vector3d(0.0, peg_board::kPegRadius_m + thickness_m + gap_m, 0.024);
    sample.arms[1].measured = demonstration::CompactPose::from({tip, kinematics::pointing_down(0.0)});
    sample.arms[1].jaw_rad = 0.0F;
    const double found = brute_force(sample, 1, Obstacle::kPeg, 0);
    // The wrist, which is rounder, is well above the peg.
    CHECK(found == doctest::Approx(gap_m).epsilon(1e-3));
  }
}

TEST_CASE("below the board's top a tool is in the board, and beside the board it may go down to the table") {
  const Demonstration document = testing::moving_demonstration(400);
  Sample sample = document.samples[0];
  const auto at = [&](const Eigen::Vector3d& tip) {
    sample.arms[0].measured = demonstration::CompactPose::from({tip, kinematics::pointing_down(0.0)});
    sample.arms[0].jaw_rad = 0.0F;
    return brute_force(sample, 0, Obstacle::kBoard, 0);
  };
  CHECK(at({0.03, -0.06, 0.003}) == doctest::Approx(0.003).epsilon(1e-4));
  CHECK(at({0.03, -0.06, -0.002}) == doctest::Approx(-0.002).epsilon(1e-4));
  CHECK(at({0.03, -0.081, -0.005}) == doctest::Approx(0.081 - 0.077 - 0.0014).epsilon(1e-3));
  CHECK(at({0.03, -0.09, -0.0221}) == doctest::Approx(-0.001).epsilon(1e-3));
}

TEST_CASE(
    "blocks whose place is not known are no obstacles, nor is the one that is carried to the jaws that carry it") {
  Demonstration document = testing::transfer(1);
  ClearanceMaker maker;
  const ClearanceCurve curve = maker.make(document);
  const auto samples = document.gated();
  bool held = false;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if ((samples[i].flags & demonstration::kLeftHolds) == 0) continue;
    held = true;
    CHECK(curve[i][0].nearest[2].distance_m > 0.0F);
  }
  CHECK(held);
  Sample sample = samples[0];
  for (auto& block : sample.blocks) block = {};
  sample.arms[0].measured = demonstration::CompactPose::from({{0.0, 0.0, 0.005}, kinematics::pointing_down(0.0)});
  CHECK(brute_force(sample, 0, Obstacle::kBlock, 3) == doctest::Approx(kHorizon_m));
  sample.blocks[1] = demonstration::CompactPose::from(spatial::Pose::translation({0.0, 0.004, 0.005}));
  CHECK(brute_force(sample, 0, Obstacle::kBlock, 3) < 0.0);
}

TEST_CASE("a chunk that is kept gives the reviews of which it was made") {
  const Demonstration document = testing::transfer(1);
  Sweep sweep(document.block);
  std::vector<SampleReview> reviews;
  for (const Sample& sample : document.gated().slice(2000, 300)) reviews.push_back(sweep.next(sample));
  // One of them beyond reach, and one beyond a joint's limit.
  reviews[7][1].reachable = false;
  reviews[8][0].excess = {2, 0.01, 0.24};
  const ClearanceChunk chunk(reviews);
  REQUIRE(chunk.size() == reviews.size());
  double least_m = kHorizon_m;
  for (std::size_t i = 0; i < reviews.size(); ++i) {
    const SampleReview kept = chunk[i];
    for (std::size_t arm = 0; arm < 2; ++arm) {
      for (std::size_t k = 0; k < kObstacleCount; ++k) {
        CHECK(kept[arm].nearest[k].distance_m == reviews[i][arm].nearest[k].distance_m);
        if (static_cast<double>(kept[arm].nearest[k].distance_m) >= kHorizon_m) continue;
        CHECK(kept[arm].nearest[k].part == reviews[i][arm].nearest[k].part);
        CHECK(kept[arm].nearest[k].index == reviews[i][arm].nearest[k].index);
      }
      CHECK(kept[arm].reachable == reviews[i][arm].reachable);
      CHECK(kept[arm].excess.joint == reviews[i][arm].excess.joint);
      least_m = std::min(least_m, reviews[i][arm].least_m());
    }
  }
  CHECK(chunk.least_m() == least_m);
}

TEST_CASE("who shares a store works nothing out that another has worked out") {
  const Demonstration document = testing::transfer(1);
  const auto store = std::make_shared<ClearanceStore>();
  ClearanceMaker first(store);
  ClearanceMaker second(store);
  const ClearanceCurve curve = first.make(document);
  const ClearanceCurve again = second.make(document);
  CHECK(first.worked_out() == document.gated().size());
  CHECK(second.worked_out() == 0);
  CHECK(again.chunks() == curve.chunks());
}

TEST_CASE("a store keeps to its budget, lets go of what was used longest ago, and finds what a curve still holds") {
  const Demonstration document = testing::transfer(1);
  const auto whole = std::make_shared<ClearanceStore>();
  ClearanceMaker(whole).make(document);
  const std::size_t half = whole->bytes() / 2;
  const auto store = std::make_shared<ClearanceStore>(half);
  ClearanceMaker maker(store);
  {
    const ClearanceCurve held = maker.make(document);
    CHECK(store->bytes() <= half);
    CHECK(store->count() < whole->count());
    CHECK(store->count() > 0);
    maker.make(document);
    CHECK(maker.worked_out() == 0);
  }
  // Nobody holds it any more: what was let go of has to be worked out again.
  maker.make(document);
  CHECK(maker.worked_out() > 0);
  CHECK(store->bytes() <= half);
}
