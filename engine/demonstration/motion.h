/// How fast the tools of a demonstration move: speed, acceleration and jerk along the measured paths.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/demonstration/demonstration.h"

namespace trocar::demonstration {

/// At one instant, from four samples that are at least 20 ms apart each, so that rounding to single precision does not
/// show. The differences are the filter: speed is a mean over 20 ms (the middle two), acceleration over 60 ms (the mean
/// of two second differences), jerk over 60 ms (the third difference). Of a path that is cubic in time and sampled
/// evenly, acceleration and jerk are exact.
struct MotionPoint {
  double t_s = 0.0;  ///< Of the demonstration: the middle of the four.
  double speed_m_s = 0.0;
  double acceleration_m_s2 = 0.0;
  double jerk_m_s3 = 0.0;
};

/// Below the rounding of single precision at arm's length, nothing has moved.
constexpr double kUnmoved_m = 1e-7;

/// p_WT as measured.
Eigen::Vector3d measured_tip(const Sample& sample, std::size_t arm);

/// Of one arm (0 left, 1 right) between the gates; empty for fewer than 5 samples. Differences are not taken across
/// what is longer than `motion_gap_s`. Slower than 50 Hz the four samples are neighbours, and the means are over as
/// much more time.
std::vector<MotionPoint> motion_of(const Demonstration& document, std::size_t arm);
/// Of any samples; times count from `first_tick`.
std::vector<MotionPoint> motion_of(const SampleTrack& samples, std::int64_t first_tick, std::size_t arm);

/// Of a path that went through a Gaussian of 50 ms in time: of a tremor at 10 Hz a hundredth is left, of a motion that
/// takes a second nearly all.
struct JerkSummary {
  double mean_m_s3 = 0.0;  ///< Of its magnitude.
  double peak_m_s3 = 0.0;
};
/// Of samples that are usually further apart no jerk is told: a reach begins and ends between two of them.
constexpr double kRarestForJerk_s = 0.2;
/// Of one arm between the gates, without 0.15 s at the ends. None where it cannot be told: of what is shorter than
/// 0.4 s, or of samples that are too rare.
std::optional<JerkSummary> jerk_without_tremor(const Demonstration& document, std::size_t arm);

/// Beyond this, two neighbours are apart: nothing is said of what was between them. Where samples are rare it is two
/// and a half of what is usual from one to the next.
constexpr double kMotionGap_s = 0.1;
double motion_gap_s(const SampleTrack& samples);

/// The length of an arm's measured path between the gates, in metres.
double path_length_m(const Demonstration& document, std::size_t arm);

}  // namespace trocar::demonstration
