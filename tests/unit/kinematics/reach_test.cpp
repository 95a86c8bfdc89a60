#include "engine/kinematics/reach.h"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include "engine/core/random.h"
#include "engine/spatial/units.h"

using namespace trocar::kinematics;
using trocar::Random;

TEST_CASE("the excess is that of which the inverse speaks, and none where the inverse has an answer") {
  Random random(5);
  int beyond = 0;
  for (const ArmSide side : kArmSides) {
    const PsmModel model = psm_model(side);
    for (int i = 0; i < 4000; ++i) {
      trocar::spatial::Pose X_WT = ready_pose(side);
      X_WT.p += Eigen::Vector3d(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.1));
      X_WT.q = X_WT.q * Eigen::Quaterniond(1.0, random.normal(), random.normal(), random.normal()).normalized();
      const auto joints = inverse(model, X_WT);
      const auto excess = excess_at(model, X_WT);
      REQUIRE(excess);
      CHECK(joints.has_value() == (excess->joint == -1));
      if (joints) continue;
      ++beyond;
      CHECK(excess->beyond > 0.0);
      // The sentence names the first joint that is beyond, the excess the worst one.
      const std::string amount = excess->joint == 2
                                     ? fmt::format("{:.1f} mm", 1e3 * excess->beyond)
                                     : fmt::format("{:.1f}°", trocar::spatial::to_degrees(excess->beyond));
      const std::string named = fmt::format("the {} joint would be {} beyond", joint_name(excess->joint), amount);
      const bool first = joints.error().text().find(fmt::format("the {} joint", joint_name(excess->joint))) == 0;
      if (first) CHECK(joints.error().text().starts_with(named));
    }
  }
  CHECK(beyond > 1000);
}
