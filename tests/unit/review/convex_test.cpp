#include "engine/review/convex.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/random.h"
#include "engine/simulation/ode_handles.h"

using namespace trocar;
using namespace trocar::review;
using Eigen::Vector3d;

namespace {

Vector3d point(Random& random, double size) {
  const double x = random.uniform(-size, size);
  const double y = random.uniform(-size, size);
  const double z = random.uniform(-size, size);
  return {x, y, z};
}

Eigen::Quaterniond rotation(Random& random) {
  const double w = random.normal();
  const double x = random.normal();
  const double y = random.normal();
  const double z = random.normal();
  return Eigen::Quaterniond(w, x, y, z).normalized();
}

RoundedBox random_box(Random& random, double radius_m) {
  RoundedBox box;
  box.p = point(random, 0.02);
  box.R = rotation(random).toRotationMatrix();
  box.half_m = (point(random, 0.006).cwiseAbs().array() + 0.0005).matrix();
  box.radius_m = radius_m;
  return box;
}

Vector3d nearest_in(const RoundedBox& box, const Vector3d& q) {
  const Vector3d local = (box.R.transpose() * (q - box.p)).cwiseMax(-box.half_m).cwiseMin(box.half_m);
  return box.p + box.R * local;
}

Vector3d nearest_in(const Cylinder& cylinder, const Vector3d& q) {
  Vector3d local = q - cylinder.foot;
  const double across = local.head<2>().norm();
  if (across > cylinder.radius_m) local.head<2>() *= cylinder.radius_m / across;
  local.z() = std::clamp(local.z(), 0.0, cylinder.height_m);
  return cylinder.foot + local;
}

/// By going to and fro between two convex shapes: another way to the distance than the one that is tested.
template <typename A, typename B>
double distance_by_projection(const A& a, const B& b, const Vector3d& start) {
  Vector3d p = start;
  double distance = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const Vector3d q = nearest_in(b, p);
    p = nearest_in(a, q);
    const double now = (p - q).norm();
    if (std::abs(now - distance) < 1e-13 && i > 50) break;
    distance = now;
  }
  return distance;
}

/// The core grown by `by_m`, coarsely: whether it still meets the other shape when it is moved away along `normal`.
template <typename Other>
bool parts_when_moved(RoundedBox a, const Other& b, const Vector3d& by_m) {
  a.p += by_m;
  return separation(a, b).distance_m > -1e-7;
}

}  // namespace

TEST_CASE("distances between boxes are those that projecting to and fro finds") {
  Random random(7);
  int apart = 0;
  for (int i = 0; i < 400; ++i) {
    const RoundedBox a = random_box(random, 0.0);
    const RoundedBox b = random_box(random, 0.0);
    const Separation found = separation(a, b);
    if (found.distance_m <= 1e-5) continue;
    ++apart;
    CHECK(found.distance_m == doctest::Approx(distance_by_projection(a, b, a.p)).epsilon(1e-4));
    CHECK(separation(b, a).distance_m == doctest::Approx(found.distance_m).epsilon(1e-6));
  }
  CHECK(apart > 250);
}

TEST_CASE("distances between a box and a peg are those that projecting to and fro finds") {
  Random random(11);
  int apart = 0;
  for (int i = 0; i < 400; ++i) {
    const RoundedBox a = random_box(random, 0.0);
    const Cylinder peg{point(random, 0.01), 0.0015, 0.026};
    const Separation found = separation(a, peg);
    if (found.distance_m <= 1e-5) continue;
    ++apart;
    CHECK(found.distance_m == doctest::Approx(distance_by_projection(a, peg, a.p)).epsilon(1e-4));
  }
  CHECK(apart > 250);
}

TEST_CASE("a capsule is nearer than its line by its radius, and deeper") {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    RoundedBox box = random_box(random, 0.0);
    const Cylinder peg{point(random, 0.01), 0.0015, 0.026};
    const Vector3d from = point(random, 0.02);
    const Vector3d to = point(random, 0.02);
    const double line = separation(capsule(from, to, 0.0), peg).distance_m;
    CHECK(separation(capsule(from, to, 0.004), peg).distance_m == doctest::Approx(line - 0.004).epsilon(1e-6));
    const double apart = separation(box, capsule(from, to, 0.001)).distance_m;
    CHECK(apart == doctest::Approx(separation(box, capsule(from, to, 0.0)).distance_m - 0.001).epsilon(1e-6));
  }
}

TEST_CASE("lines have the distance of their nearest points") {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    const Vector3d a = point(random, 0.02);
    const Vector3d half_a = point(random, 0.01);
    const Vector3d b = point(random, 0.02);
    const Vector3d half_b = i % 5 == 0 ? Vector3d(0.7 * half_a) : point(random, 0.01);
    double least = 1.0;
    for (int s = -40; s <= 40; ++s) {
      for (int t = -40; t <= 40; ++t) least = std::min(least, (a + s / 40.0 * half_a - b - t / 40.0 * half_b).norm());
    }
    const double found = distance_of_segments(a, half_a, b, half_b);
    CHECK(found <= least + 1e-12);
    CHECK(found > least - 0.0006);
    CHECK(
        found ==
        doctest::Approx(
            std::max(0.0,
                     separation(capsule(a - half_a, a + half_a, 0.0), capsule(b - half_b, b + half_b, 0.0)).distance_m))
            .epsilon(1e-5));
  }
}

TEST_CASE("shapes that are in each other part when one goes along the normal by the depth, and not by less") {
  Random random(23);
  int deep = 0;
  for (int i = 0; i < 900; ++i) {
    RoundedBox a = random_box(random, i % 2 == 0 ? 0.0 : 0.002);
    a.p *= 0.3;
    const RoundedBox b = random_box(random, 0.0);
    const Cylinder peg{b.p - Vector3d(0.0, 0.0, 0.020), 0.0015, 0.026};
    for (const bool with_peg : {false, true}) {
      const Separation found = with_peg ? separation(a, peg) : separation(a, b);
      if (found.distance_m > -1e-4) continue;
      ++deep;
      const Vector3d away = -found.distance_m * found.normal;
      CHECK(found.normal.norm() == doctest::Approx(1.0));
      CHECK((with_peg ? parts_when_moved(a, peg, away) : parts_when_moved(a, b, away)));
      CHECK_FALSE((with_peg ? parts_when_moved(a, peg, 0.9 * away) : parts_when_moved(a, b, 0.9 * away)));
      // No other of many directions parts them sooner.
      for (int k = 0; k < 30; ++k) {
        const Vector3d other = (with_peg ? 0.8 : 0.99) * found.distance_m * (rotation(random) * Vector3d::UnitX());
        if (with_peg && other.z() < 0.0) continue;  // A peg is open below.
        CHECK_FALSE((with_peg ? parts_when_moved(a, peg, other) : parts_when_moved(a, b, other)));
      }
    }
  }
  CHECK(deep > 100);
}

TEST_CASE("shapes are in each other exactly where the simulation's collision detection finds contacts") {
  using namespace simulation;
  prepare_ode_for_this_thread();
  Random random(31);
  int touching = 0;
  int missed_by_ode = 0;
  for (int i = 0; i < 1500; ++i) {
    RoundedBox a = random_box(random, 0.0);
    RoundedBox b = random_box(random, 0.0);
    a.p *= 0.4;
    b.p *= 0.4;
    const auto geom = [](const RoundedBox& box) {
      const Vector3d size = 2.0 * kOdeLength * box.half_m;
      OdeGeom made(dCreateBox(nullptr, size.x(), size.y(), size.z()));
      set_pose(made.get(), {box.p, Eigen::Quaterniond(box.R)});
      return made;
    };
    const double half_m = 0.5 * kOdeLength * 0.026;
    OdeGeom peg(dCreateCylinder(nullptr, 0.0015 * kOdeLength, 2.0 * half_m));
    OdeGeom shaft(dCreateCapsule(nullptr, 0.0025 * kOdeLength, 2.0 * kOdeLength * b.half_m.z()));
    set_pose(peg.get(), {b.p, Eigen::Quaterniond::Identity()});
    set_pose(shaft.get(), {b.p, Eigen::Quaterniond(b.R)});
    const Vector3d end = b.half_m.z() * b.R.col(2);
    const std::array<std::pair<OdeGeom, double>, 3> others{
        std::pair{geom(b), separation(a, b).distance_m},
        std::pair{std::move(shaft), separation(a, capsule(b.p - end, b.p + end, 0.0025)).distance_m},
        std::pair{std::move(peg), separation(a, Cylinder{b.p - Vector3d(0, 0, 0.013), 0.0015, 0.026}).distance_m}};
    const OdeGeom first = geom(a);
    for (std::size_t k = 0; k < others.size(); ++k) {
      const auto& [other, distance] = others[k];
      if (std::abs(distance) < 5e-5) continue;  // ODE rounds differently.
      std::array<dContactGeom, 8> contacts;
      const int found = dCollide(first.get(), other.get(), 8, contacts.data(), sizeof(dContactGeom));
      CAPTURE(k);
      CAPTURE(distance);
      // ODE now and then misses a box and a cylinder that are deep in each other; those the projection finds.
      const bool missed = k == 2 && found == 0;
      const double way =
          missed ? distance_by_projection(a, Cylinder{b.p - Vector3d(0, 0, 0.013), 0.0015, 0.026}, a.p) : 1.0;
      CHECK((found > 0 || way < 1e-9) == (distance < 0.0));
      missed_by_ode += missed && distance < 0.0 ? 1 : 0;
      touching += found > 0 ? 1 : 0;
    }
  }
  CHECK(touching > 500);
  CHECK(missed_by_ode < 10);
}
