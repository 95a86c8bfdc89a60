#include "engine/review/simplex.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace trocar::review {
namespace {

using Eigen::Vector3d;

/// A point of the hull of some points, and which of them it needs.
struct Found {
  Vector3d point{0.0, 0.0, 0.0};
  std::array<int, 3> which{};
  int count = 0;
};

Found nearest_of_segment(const std::array<Vector3d, 4>& points, int a, int b) {
  const Vector3d& from = points[static_cast<std::size_t>(a)];
  const Vector3d along = points[static_cast<std::size_t>(b)] - from;
  const double length2 = along.squaredNorm();
  const double s = length2 > 0.0 ? -from.dot(along) / length2 : 0.0;
  if (s <= 0.0) return {from, {a, 0, 0}, 1};
  if (s >= 1.0) return {points[static_cast<std::size_t>(b)], {b, 0, 0}, 1};
  return {from + s * along, {a, b, 0}, 2};
}

Found nearest_of_triangle(const std::array<Vector3d, 4>& points, int a, int b, int c) {
  const Vector3d& pa = points[static_cast<std::size_t>(a)];
  const Vector3d& pb = points[static_cast<std::size_t>(b)];
  const Vector3d& pc = points[static_cast<std::size_t>(c)];
  const Vector3d normal = (pb - pa).cross(pc - pa);
  const double area2 = normal.squaredNorm();
  const bool inside = area2 > 0.0 && normal.dot(pa.cross(pb)) >= 0.0 && normal.dot(pb.cross(pc)) >= 0.0 &&
                      normal.dot(pc.cross(pa)) >= 0.0;
  if (inside) return {normal * (pa.dot(normal) / area2), {a, b, c}, 3};
  Found best = nearest_of_segment(points, a, b);
  for (const Found& other : {nearest_of_segment(points, b, c), nearest_of_segment(points, c, a)}) {
    if (other.point.squaredNorm() < best.point.squaredNorm()) best = other;
  }
  return best;
}

/// Whether the origin is on the other side of the triangle than the fourth point, or the four lie in a plane.
bool outside(const std::array<Vector3d, 4>& points, int a, int b, int c, int fourth) {
  const Vector3d& pa = points[static_cast<std::size_t>(a)];
  const Vector3d normal = (points[static_cast<std::size_t>(b)] - pa).cross(points[static_cast<std::size_t>(c)] - pa);
  const double of_origin = -pa.dot(normal);
  const double of_fourth = (points[static_cast<std::size_t>(fourth)] - pa).dot(normal);
  return of_origin * of_fourth <= 0.0;
}

}  // namespace

bool Simplex::holds(const Vector3d& point) const {
  return std::find(points_.begin(), points_.begin() + count_, point) != points_.begin() + count_;
}

void Simplex::keep(std::array<int, 3> which, int count) {
  const std::array<Vector3d, 4> all = points_;
  for (int i = 0; i < count; ++i) {
    points_[static_cast<std::size_t>(i)] = all[static_cast<std::size_t>(which[static_cast<std::size_t>(i)])];
  }
  count_ = count;
}

void Simplex::reduce_segment() {
  const Found found = nearest_of_segment(points_, 0, 1);
  nearest_ = found.point;
  keep(found.which, found.count);
}

void Simplex::reduce_triangle() {
  const Found found = nearest_of_triangle(points_, 0, 1, 2);
  nearest_ = found.point;
  keep(found.which, found.count);
}

void Simplex::reduce_tetrahedron() {
  constexpr std::array<std::array<int, 4>, 4> kFaces{{{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}}};
  Found best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c, fourth] : kFaces) {
    if (!outside(points_, a, b, c, fourth)) continue;
    const Found found = nearest_of_triangle(points_, a, b, c);
    if (found.point.squaredNorm() >= least) continue;
    least = found.point.squaredNorm();
    best = found;
  }
  if (best.count == 0) {
    nearest_.setZero();
    return;
  }
  nearest_ = best.point;
  keep(best.which, best.count);
}

void Simplex::add(const Vector3d& point) {
  points_[static_cast<std::size_t>(count_++)] = point;
  if (count_ == 1) nearest_ = point;
  if (count_ == 2)
    reduce_segment();
  else if (count_ == 3)
    reduce_triangle();
  else if (count_ == 4)
    reduce_tetrahedron();
}

}  // namespace trocar::review
