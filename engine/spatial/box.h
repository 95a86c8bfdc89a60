/// An axis-aligned box.
#pragma once

#include <Eigen/Core>

namespace trocar::spatial {

struct Box {
  Eigen::Vector3d low{0.0, 0.0, 0.0};   ///< Metres.
  Eigen::Vector3d high{0.0, 0.0, 0.0};  ///< Metres.

  bool contains(const Eigen::Vector3d& point) const {
    return (point.array() >= low.array()).all() && (point.array() <= high.array()).all();
  }
  Eigen::Vector3d centre() const { return 0.5 * (low + high); }
  Eigen::Vector3d clamp(const Eigen::Vector3d& point) const { return point.cwiseMax(low).cwiseMin(high); }
  bool operator==(const Box&) const = default;
};

}  // namespace trocar::spatial
