#include "engine/demonstration/jaw_limits.h"

#include <doctest/doctest.h>

#include "engine/kinematics/psm.h"

using namespace trocar;

TEST_CASE("edits and checks of a demonstration know the limits of the arm's jaws") {
  for (const kinematics::ArmSide side : {kinematics::ArmSide::kLeft, kinematics::ArmSide::kRight}) {
    const kinematics::JointLimit jaw = kinematics::psm_model(side).jaw;
    CHECK(jaw.low == doctest::Approx(demonstration::kJawLow_rad).epsilon(1e-12));
    CHECK(jaw.high == doctest::Approx(demonstration::kJawHigh_rad).epsilon(1e-12));
  }
}
