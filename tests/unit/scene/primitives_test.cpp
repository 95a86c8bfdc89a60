#include "engine/scene/primitives.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

using namespace trocar;
using Eigen::Vector3d;

namespace {

/// By the divergence theorem; positive only if the triangles face outwards.
double volume(const scene::Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vector3d a = mesh.positions[mesh.indices[i]].cast<double>();
    const Vector3d b = mesh.positions[mesh.indices[i + 1]].cast<double>();
    const Vector3d c = mesh.positions[mesh.indices[i + 2]].cast<double>();
    sum += a.dot(b.cross(c)) / 6.0;
  }
  return sum;
}

}  // namespace

TEST_CASE("the unit cube is closed and faces outwards") {
  CHECK(volume(scene::unit_cube()) == doctest::Approx(1.0));
}

TEST_CASE("a straight tube holds what a prism of as many sides holds") {
  const std::vector<Vector3d> points{{0, 0, 0}, {0, 0, 0.01}, {0, 0, 0.01}, {0, 0, 0.03}};
  const scene::Mesh mesh = scene::tube(points, {}, 0.001, 64);
  // Area of a regular 64-gon; single precision positions.
  const double area = 32.0 * 1e-6 * std::sin(2.0 * std::numbers::pi / 64.0);
  CHECK(volume(mesh) == doctest::Approx(0.03 * area).epsilon(1e-4));
}

TEST_CASE("a bent tube keeps its radius about each point and its colours") {
  const std::vector<Vector3d> points{{0, 0, 0}, {0.01, 0, 0}, {0.01, 0.01, 0}, {0.01, 0.01, 0.01}, {0.01, 0.01, 0.0}};
  const std::vector<Rgba> colours{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}, {13, 14, 15}};
  const scene::Mesh mesh = scene::tube(points, colours, 0.001, 6);
  REQUIRE(mesh.colours.size() == mesh.positions.size());
  for (std::size_t i = 0; i < points.size() * 6; ++i) {
    CHECK((mesh.positions[i].cast<double>() - points[i / 6]).norm() == doctest::Approx(0.001).epsilon(1e-3));
    CHECK(mesh.colours[i] == colours[i / 6]);
  }
}

TEST_CASE("a path that never moves has no tube") {
  const std::vector<Vector3d> points(5, Vector3d(0.01, 0.02, 0.03));
  CHECK(scene::tube(points, {}, 0.001, 6).indices.empty());
  CHECK(scene::tube({}, {}, 0.001, 6).indices.empty());
}

TEST_CASE("an arrow reaches its length and is closed") {
  const scene::Mesh mesh = scene::arrow(0.01F, 0.0005F, 0.003F, 0.001F);
  float top = 0.0F;
  for (const Eigen::Vector3f& p : mesh.positions) top = std::max(top, p.z());
  CHECK(top == doctest::Approx(0.01));
  CHECK(volume(mesh) > 0.0);
}
