#include "engine/kinematics/psm.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "engine/core/random.h"
#include "engine/spatial/grid.h"
#include "engine/spatial/rotation.h"
#include "engine/spatial/units.h"

using namespace trocar::kinematics;
using trocar::ErrorCode;
using trocar::Random;
using trocar::spatial::angle_between;
using trocar::spatial::from_degrees;
using trocar::spatial::Pose;

namespace {

Joints random_joints(const PsmModel& model, Random& random) {
  Joints q{};
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = random.uniform(model.limits[i].low, model.limits[i].high);
  return q;
}

}  // namespace

TEST_CASE("all joints at zero hold the tool straight down below the remote centre") {
  const PsmModel model = psm_model(ArmSide::kLeft);
  const Pose X_WT = forward(model, {0.0, 0.0, 0.1, 0.0, 0.0, 0.0});
  // 0.1 − (0.4318 − 0.4162) along the shaft, then 9.1 mm of wrist and 10.2 mm of jaw.
  CHECK((X_WT.p - model.X_WB.p - Eigen::Vector3d(0, 0, -(0.1 - 0.0156 + 0.0091 + 0.0102))).norm() < 1e-15);
  CHECK((X_WT.q * Eigen::Vector3d::UnitZ() + Eigen::Vector3d::UnitZ()).norm() < 1e-15);
}

TEST_CASE("100,000 random poses of each arm come back from the inverse to 1e-12 m and 1e-10 rad") {
  for (const ArmSide side : kArmSides) {
    const PsmModel model = psm_model(side);
    Random random(11);
    double worst_m = 0.0;
    double worst_rad = 0.0;
    int failures = 0;
    for (int i = 0; i < 100'000; ++i) {
      const Pose X_WT = forward(model, random_joints(model, random));
      const auto q = inverse(model, X_WT);
      if (!q) {
        ++failures;
        continue;
      }
      if (!check_limits(model, *q)) ++failures;
      const Pose back = forward(model, *q);
      worst_m = std::max(worst_m, (back.p - X_WT.p).norm());
      worst_rad = std::max(worst_rad, angle_between(back.q, X_WT.q));
    }
    CHECK(failures == 0);
    CHECK(worst_m < 1e-12);
    CHECK(worst_rad < 1e-10);  // the shaft turns by ε/d where the wrist is a small d from the remote centre
  }
}

TEST_CASE("the inverse finds the joints themselves where only one set is inside the limits") {
  const PsmModel model = psm_model(ArmSide::kRight);
  const Joints q{0.3, -0.4, 0.13, 0.7, -0.5, 0.6};
  const auto found = inverse(model, forward(model, q));
  REQUIRE(found);
  for (std::size_t i = 0; i < q.size(); ++i) CHECK((*found)[i] == doctest::Approx(q[i]).epsilon(1e-12));
}

TEST_CASE("a pose too far down names the insertion and by how much it is beyond") {
  const PsmModel model = psm_model(ArmSide::kLeft);
  const Pose X_WT = forward(model, {0.0, 0.0, 0.25, 0.0, 0.0, 0.0});
  const auto q = inverse(model, X_WT);
  REQUIRE_FALSE(q);
  CHECK(q.error().code() == ErrorCode::kOutOfReach);
  CHECK(q.error().text() == "the insertion joint would be 10.0 mm beyond its limit of 240.0 mm");
}

TEST_CASE("a pose beyond the pitch limit names the pitch and by how much it is beyond") {
  const PsmModel model = psm_model(ArmSide::kLeft);
  const auto q = inverse(model, forward(model, {0.0, from_degrees(58.5), 0.1, 0.0, 0.0, 0.0}));
  REQUIRE_FALSE(q);
  CHECK(q.error().text() == "the pitch joint would be 5.5° beyond its limit of 53.0°");
}

TEST_CASE("each joint alone beyond its limit is named by the limit check") {
  const PsmModel model = psm_model(ArmSide::kLeft);
  for (int joint = 0; joint < kJointCount; ++joint) {
    Joints q{0.0, 0.0, 0.1, 0.0, 0.0, 0.0};
    CHECK(check_limits(model, q));
    q[static_cast<std::size_t>(joint)] = model.limits[static_cast<std::size_t>(joint)].high + 0.01;
    const auto status = check_limits(model, q);
    REQUIRE_FALSE(status);
    CHECK(status.error().text().find(std::string("the ") + std::string(joint_name(joint)) + " joint") == 0);
  }
}

TEST_CASE("a pose that is not finite or not a rotation is an invalid argument") {
  const PsmModel model = psm_model(ArmSide::kLeft);
  Pose X_WT = ready_pose(ArmSide::kLeft);
  X_WT.p.x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(inverse(model, X_WT).error().code() == ErrorCode::kInvalidArgument);
  X_WT = ready_pose(ArmSide::kLeft);
  X_WT.q.coeffs() *= 2.0;
  CHECK(inverse(model, X_WT).error().code() == ErrorCode::kInvalidArgument);
}

TEST_CASE("the tool at the remote centre is an error and not a division by zero") {
  const PsmModel model = psm_model(ArmSide::kLeft);
  const Pose X_WT{model.X_WB.p, pointing_down(0.0)};
  const auto q = inverse(model, X_WT);
  if (q) CHECK((forward(model, *q).p - X_WT.p).norm() < 1e-12);
  Pose centred = X_WT;
  centred.p += centred.q * Eigen::Vector3d(0, 0, kTipFromWrist_m);  // the wrist itself at the remote centre
  CHECK(inverse(model, centred).error().code() == ErrorCode::kOutOfReach);
}

TEST_CASE("tool frame: hinge across, jaws out along z, and straight down means down") {
  const Eigen::Quaterniond q = pointing_down(0.3);
  CHECK((q * Eigen::Vector3d::UnitZ() + Eigen::Vector3d::UnitZ()).norm() < 1e-15);
  CHECK((q * Eigen::Vector3d::UnitX() - Eigen::Vector3d(std::cos(0.3), std::sin(0.3), 0.0)).norm() < 1e-15);
  const PsmModel model = psm_model(ArmSide::kLeft);
  const Joints joints{0.2, 0.1, 0.12, -0.3, 0.4, 0.2};
  const Pose X_WL = joint_frame(model, joints, 5);
  const Pose X_WT = forward(model, joints);
  CHECK((X_WT.q * Eigen::Vector3d::UnitX() + X_WL.q * Eigen::Vector3d::UnitZ()).norm() < 1e-14);
  CHECK((wrist_pose(X_WT).p - X_WL.p).norm() < 1e-15);
}

TEST_CASE("the skeleton's links have the lengths of the arm") {
  const PsmModel model = psm_model(ArmSide::kRight);
  const auto points = skeleton(model, {0.2, -0.3, 0.14, 1.0, 0.5, -0.4});
  CHECK((points[1] - points[0]).norm() == doctest::Approx(0.14 - 0.0156));
  CHECK((points[2] - points[1]).norm() == doctest::Approx(0.0091));
  CHECK((points[3] - points[2]).norm() == doctest::Approx(0.0102));
}

TEST_CASE("the left arm reaches every cell of the learning cube with the jaws straight down, at any yaw within 60°") {
  const PsmModel model = psm_model(ArmSide::kLeft);
  const trocar::spatial::Grid grid;
  int failures = 0;
  for (int cell = 0; cell < grid.cell_count(); ++cell) {
    const Eigen::Vector3d p = grid.centre(trocar::spatial::CellIndex{cell});
    for (const double yaw_degrees : {-60.0, -30.0, 0.0, 30.0, 60.0}) {
      if (!inverse(model, {p, pointing_down(from_degrees(yaw_degrees))})) ++failures;
    }
  }
  CHECK(failures == 0);
}

TEST_CASE("both arms reach their ready poses and the hand-off, the right arm every goal peg from above") {
  for (const ArmSide side : kArmSides) {
    const PsmModel model = psm_model(side);
    CHECK(inverse(model, ready_pose(side)));
    for (double yaw = -60.0; yaw <= 60.0; yaw += 15.0) {
      CHECK(inverse(model, {Eigen::Vector3d(-0.010, 0.0, 0.045), pointing_down(from_degrees(yaw))}));
    }
  }
  const PsmModel right = psm_model(ArmSide::kRight);
  for (int goal = 0; goal < 6; ++goal) {
    for (const double z_m : {0.003, 0.010, 0.030, 0.057}) {
      const Eigen::Vector3d p(-0.030 + 0.020 * (goal % 3), goal < 3 ? 0.043 : 0.013, z_m);
      CHECK(inverse(right, {p, pointing_down(0.0)}));
    }
  }
}
