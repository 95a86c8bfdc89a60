// The agent's motion: no jump of place, speed or direction, at its beginning, at corners and at its end.
#include "engine/control/glide.h"

#include <doctest/doctest.h>

#include <vector>

using namespace trocar;
using control::Glide;
using Eigen::Vector3d;

namespace {

constexpr double kStep_m = 0.0025;
constexpr double kSample_s = 0.005;

/// Along the corner x, x, y, y, z, z from `start`, until it rests.
std::vector<Vector3d> way(const Vector3d& start, const Vector3d& v, double rate_hz) {
  std::vector<Vector3d> cells;
  Vector3d cell(0.0, 0.0, 0.0);
  for (const int axis : {0, 0, 1, 1, 2, 2}) {
    cell[axis] += kStep_m;
    cells.push_back(cell);
  }
  Glide glide(start, v, rate_hz, cells.front());
  std::size_t next = 1;
  std::vector<Vector3d> places{start};
  for (int i = 0; i < 2000 && !glide.at_rest(); ++i) {
    if (glide.wants_place()) glide.add(cells[std::min(next++, cells.size() - 1)]);
    places.push_back(glide.advance(kSample_s));
  }
  REQUIRE(glide.at_rest());
  CHECK((places.back() - cells.back()).norm() < 1e-12);
  return places;
}

}  // namespace

TEST_CASE("it begins where the tool is and as the tool moves") {
  const Vector3d start(0.0009, -0.0011, 0.0004);
  const Vector3d v(0.03, 0.02, -0.01);
  const Glide glide(start, v, 20.0, {kStep_m, 0.0, 0.0});
  CHECK((glide.place() - start).norm() < 1e-15);
  CHECK((glide.velocity() - v).norm() < 1e-12);
}

TEST_CASE("speed and direction change by no more than a tool that weighs something could, at any rate") {
  for (const double rate_hz : {5.0, 20.0, 40.0}) {
    const std::vector<Vector3d> places = way({0.0005, 0.0, -0.0008}, Vector3d::Zero(), rate_hz);
    const double fastest = 1.2 * kStep_m * rate_hz;
    Vector3d before = Vector3d::Zero();
    for (std::size_t i = 1; i < places.size(); ++i) {
      const Vector3d v = (places[i] - places[i - 1]) / kSample_s;
      CHECK(v.norm() <= fastest);
      // The third differences of the places bound the acceleration: 3 cells a step² at most here.
      CHECK((v - before).norm() / kSample_s <= 3.0 * kStep_m * rate_hz * rate_hz);
      before = v;
    }
  }
}

TEST_CASE("it stays within a third of a cell of the cells that it is led through") {
  for (const Vector3d& p : way(Vector3d::Zero(), Vector3d::Zero(), 20.0)) {
    double nearest = 1.0;
    Vector3d from(0.0, 0.0, 0.0);
    for (const int axis : {0, 0, 1, 1, 2, 2}) {
      Vector3d to = from;
      to[axis] += kStep_m;
      const double s = std::clamp((p - from).dot(to - from) / (kStep_m * kStep_m), 0.0, 1.0);
      nearest = std::min(nearest, (from + s * (to - from) - p).norm());
      from = to;
    }
    CHECK(nearest <= kStep_m / 3.0);
  }
}
