/// How fast the tools of a demonstration move: speed, acceleration and jerk along the measured paths.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "engine/demonstration/demonstration.h"

namespace trocar::demonstration {

/// At one instant, by differences over at least 20 ms, so that rounding to single precision does not show.
struct MotionPoint {
  double t_s = 0.0;  ///< Of the demonstration.
  double speed_m_s = 0.0;
  double acceleration_m_s2 = 0.0;
  double jerk_m_s3 = 0.0;
};

/// p_WT as measured.
Eigen::Vector3d measured_tip(const Sample& sample, std::size_t arm);

/// Of one arm (0 left, 1 right) between the gates; empty for fewer than 5 samples. Differences are not taken across
/// a gap of more than 0.1 s.
std::vector<MotionPoint> motion_of(const Demonstration& document, std::size_t arm);

/// The length of an arm's measured path between the gates, in metres.
double path_length_m(const Demonstration& document, std::size_t arm);

}  // namespace trocar::demonstration
