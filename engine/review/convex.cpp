#include "engine/review/convex.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/review/simplex.h"

namespace trocar::review {
namespace {

using Eigen::Vector3d;

/// The farthest point of the box, without its rounding, along `d`.
Vector3d support(const RoundedBox& box, const Vector3d& d) {
  const Vector3d local = box.R.transpose() * d;
  return box.p + box.R * Vector3d(std::copysign(box.half_m.x(), local.x()), std::copysign(box.half_m.y(), local.y()),
                                  std::copysign(box.half_m.z(), local.z()));
}

Vector3d support(const Cylinder& cylinder, const Vector3d& d) {
  const double across = d.head<2>().norm();
  Vector3d point = cylinder.foot;
  if (across > 0.0) point.head<2>() += cylinder.radius_m / across * d.head<2>();
  if (d.z() > 0.0) point.z() += cylinder.height_m;
  return point;
}

/// The least way on which two shapes that are in each other part, over the directions that were tried.
template <typename Other>
class Depth {
 public:
  Depth(const RoundedBox& a, const Other& b) : a_(a), b_(b) {}

  /// The first shape goes along `direction`, of any length.
  void along(const Vector3d& direction) {
    const double length = direction.norm();
    if (!(length > 1e-12)) return;
    const Vector3d n = direction / length;
    const double depth = n.dot(support(b_, n)) - n.dot(support(a_, Vector3d(-n)));
    if (depth >= least_) return;
    least_ = depth;
    normal_ = n;
  }
  void both_ways(const Vector3d& direction) {
    along(direction);
    along(-direction);
  }
  Separation result(double radius_m) const { return {-(std::max(least_, 0.0) + radius_m), normal_}; }

 private:
  const RoundedBox& a_;
  const Other& b_;
  double least_ = std::numeric_limits<double>::infinity();
  Vector3d normal_{0.0, 0.0, 1.0};
};

Separation depth_of(const RoundedBox& a, const RoundedBox& b) {
  Depth<RoundedBox> depth(a, b);
  for (int i = 0; i < 3; ++i) {
    depth.both_ways(a.R.col(i));
    depth.both_ways(b.R.col(i));
    for (int j = 0; j < 3; ++j) depth.both_ways(a.R.col(i).cross(b.R.col(j)));
  }
  return depth.result(a.radius_m + b.radius_m);
}

Separation depth_of(const RoundedBox& a, const Cylinder& b) {
  Depth<Cylinder> depth(a, b);
  depth.along(Vector3d::UnitZ());
  for (int i = 0; i < 3; ++i) {
    depth.both_ways(a.R.col(i));
    depth.both_ways(Vector3d(-a.R(1, i), a.R(0, i), 0.0));
  }
  for (unsigned corner = 0; corner < 8; ++corner) {
    Vector3d local = a.half_m;
    for (int i = 0; i < 3; ++i) {
      if ((corner >> static_cast<unsigned>(i) & 1U) != 0) local[i] = -local[i];
    }
    Vector3d beside = a.p + a.R * local - b.foot;
    beside.z() = 0.0;
    depth.along(beside);
  }
  return depth.result(a.radius_m);
}

template <typename Other>
Separation separation_of(const RoundedBox& a, const Other& b, const Vector3d& middle_b, double radius_m) {
  const auto difference = [&](const Vector3d& d) { return Vector3d(support(a, d) - support(b, Vector3d(-d))); };
  const Vector3d nearest = nearest_to_origin(difference, a.p - middle_b);
  const double distance = nearest.norm();
  if (distance == 0.0) return depth_of(a, b);
  return {distance - radius_m, nearest / distance};
}

}  // namespace

RoundedBox capsule(const Vector3d& a, const Vector3d& b, double radius_m) {
  const Vector3d along = b - a;
  const double length = along.norm();
  const Vector3d z = length > 0.0 ? Vector3d(along / length) : Vector3d::UnitZ();
  // Of the axes across only that they are across matters.
  const Vector3d x = z.unitOrthogonal();
  RoundedBox shape{0.5 * (a + b), Eigen::Matrix3d(), {0.0, 0.0, 0.5 * length}, radius_m};
  shape.R << x, z.cross(x), z;
  return shape;
}

Separation separation(const RoundedBox& a, const RoundedBox& b) {
  return separation_of(a, b, b.p, a.radius_m + b.radius_m);
}

Separation separation(const RoundedBox& a, const Cylinder& b) {
  return separation_of(a, b, b.foot + Vector3d(0.0, 0.0, 0.5 * b.height_m), a.radius_m);
}

double distance_of_segments(const Vector3d& middle_a, const Vector3d& half_a, const Vector3d& middle_b,
                            const Vector3d& half_b) {
  const Vector3d r = middle_a - middle_b;
  const double aa = half_a.squaredNorm();
  const double bb = half_b.squaredNorm();
  const double ab = half_a.dot(half_b);
  const double ar = half_a.dot(r);
  const double br = half_b.dot(r);
  const double across = aa * bb - ab * ab;
  double s = across > 1e-12 * aa * bb ? std::clamp((ab * br - bb * ar) / across, -1.0, 1.0) : 0.0;
  double t = bb > 0.0 ? (ab * s + br) / bb : 0.0;
  if (t < -1.0 || t > 1.0) {
    t = std::clamp(t, -1.0, 1.0);
    s = aa > 0.0 ? std::clamp((ab * t - ar) / aa, -1.0, 1.0) : 0.0;
  }
  return (r + s * half_a - t * half_b).norm();
}

}  // namespace trocar::review
