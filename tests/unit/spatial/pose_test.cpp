#include "engine/spatial/pose.h"

#include <doctest/doctest.h>

#include "engine/spatial/rotation.h"
#include "engine/spatial/units.h"

using namespace trocar::spatial;

TEST_CASE("a pose times its inverse is the identity") {
  const Pose X_AB{{0.1, -0.2, 0.3}, about_z(0.7) * about_x(-0.4)};
  const Pose identity = X_AB * X_AB.inverse();
  CHECK(identity.p.norm() < 1e-15);
  CHECK(angle_between(identity.q, Eigen::Quaterniond::Identity()) < 1e-12);
}

TEST_CASE("interpolation passes through both ends and half way") {
  const Pose a{{0, 0, 0}, about_z(0.0)};
  const Pose b{{1, 0, 0}, about_z(from_degrees(90.0))};
  CHECK(interpolate(a, b, 0.0).p == a.p);
  CHECK(interpolate(a, b, 0.5).p.x() == doctest::Approx(0.5));
  CHECK(angle_between(a.q, interpolate(a, b, 0.5).q) == doctest::Approx(from_degrees(45.0)));
}
