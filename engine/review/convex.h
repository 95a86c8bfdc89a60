/// Distances between the simple shapes that collide in the simulated world: rounded boxes and upright cylinders.
#pragma once

#include <Eigen/Core>

namespace trocar::review {

/// All points within `radius_m` of a box: a box where that is 0, a capsule where the box is a line.
///
/// Frames: W. `R`'s columns are the box's axes.
struct RoundedBox {
  Eigen::Vector3d p{0.0, 0.0, 0.0};  ///< The middle.
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d half_m{0.0, 0.0, 0.0};  ///< Half of its size along its axes, without the rounding.
  double radius_m = 0.0;
};
/// The points within `radius_m` of the line from `a` to `b`.
RoundedBox capsule(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius_m);

/// A peg: its axis along z, open below, where the board is.
struct Cylinder {
  Eigen::Vector3d foot{0.0, 0.0, 0.0};
  double radius_m = 0.0;
  double height_m = 0.0;
};

struct Separation {
  /// Of the shapes' surfaces. Below 0: as deep as they are in each other, the least way on which they would part.
  double distance_m = 0.0;
  Eigen::Vector3d normal{0.0, 0.0, 1.0};  ///< In W, unit; where the first shape would have to go to get away.
};

/// Exact but for rounding (1e-7 of the distance, 1e-8 m); the depth in a cylinder, along any of the directions that
/// part a box from a prism about it or a corner from its side.
Separation separation(const RoundedBox& a, const RoundedBox& b);
Separation separation(const RoundedBox& a, const Cylinder& b);

/// The distance between two segments, each given by its middle and its half.
double distance_of_segments(const Eigen::Vector3d& middle_a, const Eigen::Vector3d& half_a,
                            const Eigen::Vector3d& middle_b, const Eigen::Vector3d& half_b);

}  // namespace trocar::review
