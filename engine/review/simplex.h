/// The distance of a convex shape from the origin, from its support function alone (Gilbert, Johnson and Keerthi).
#pragma once

#include <Eigen/Core>
#include <array>

namespace trocar::review {

/// Up to four points, and the point of their hull that is nearest to the origin.
class Simplex {
 public:
  /// True if the point is one of those that are kept: nothing nearer will be found.
  bool holds(const Eigen::Vector3d& point) const;
  /// Adds a point and forgets those that the nearest point does not need. Precondition: fewer than four are kept.
  void add(const Eigen::Vector3d& point);
  const Eigen::Vector3d& nearest() const { return nearest_; }
  /// Four points are kept: the origin is among them.
  bool full() const { return count_ == 4; }

 private:
  void reduce_segment();
  void reduce_triangle();
  void reduce_tetrahedron();
  void keep(std::array<int, 3> which, int count);

  std::array<Eigen::Vector3d, 4> points_;
  int count_ = 0;
  Eigen::Vector3d nearest_{0.0, 0.0, 0.0};
};

/// The point nearest to the origin of a convex shape; zero if the origin is in it. `support(d)` is the shape's farthest
/// point along `d`, `start` any point near it.
template <typename Support>
Eigen::Vector3d nearest_to_origin(const Support& support, const Eigen::Vector3d& start) {
  constexpr double kTouching = 1e-8;
  constexpr double kRelative = 1e-7;
  constexpr int kMost = 60;
  Simplex simplex;
  Eigen::Vector3d v = start;
  if (v.squaredNorm() < kTouching * kTouching) v = Eigen::Vector3d::UnitZ();
  bool first = true;
  for (int i = 0; i < kMost; ++i) {
    const Eigen::Vector3d w = support(Eigen::Vector3d(-v));
    // At first v is not yet a point of the shape, so that nothing follows from it.
    if (!first && (v.dot(v - w) <= kRelative * v.squaredNorm() || simplex.holds(w))) return v;
    first = false;
    simplex.add(w);
    v = simplex.nearest();
    if (simplex.full() || v.squaredNorm() < kTouching * kTouching) return Eigen::Vector3d::Zero();
  }
  return v;
}

}  // namespace trocar::review
