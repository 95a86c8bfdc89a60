/// A time warp as a curve through knots: which new time answers to an old one.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/core/result.h"

namespace trocar::demonstration {

/// The knots of a warp of the span, its begin and its end among them: x is an old time, y the new one, both in seconds
/// of the demonstration and both increasing. The begin stays where it is; an end without a knot of its own is as far
/// behind the last one as it was. A knot at or behind the end is the end's.
/// Errors: kInvalidArgument if there is no knot, one lies outside of the span, or one of the times does not increase.
Result<std::vector<Eigen::Vector2d>> warp_knots(const std::vector<Eigen::Vector2d>& knots, double begin_s,
                                                double end_s);

/// A smooth curve through points that goes up wherever they do (Fritsch and Carlson, 1980).
class MonotoneCurve {
 public:
  /// Precondition: at least two points, both coordinates increasing.
  explicit MonotoneCurve(std::vector<Eigen::Vector2d> points);
  /// Beyond the ends: as at the ends.
  double at(double x) const;

 private:
  std::vector<Eigen::Vector2d> points_;
  std::vector<double> slopes_;
};

}  // namespace trocar::demonstration
