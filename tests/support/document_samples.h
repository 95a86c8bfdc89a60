/// Recordings and demonstrations for the tests of the document.
#pragma once

#include <cmath>
#include <memory>
#include <string>

#include "engine/demonstration/demonstration.h"

namespace trocar::testing {

/// Sample `index` of a smooth motion at 200 Hz through the middle of the lattice; all numbers differ in all samples.
inline demonstration::Sample moving_sample(int index) {
  demonstration::Sample sample;
  sample.tick = std::int64_t{index} * demonstration::kTicksPerSample;
  const double t_s = sample.t_s();
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const double side = arm == 0 ? -1.0 : 1.0;
    const Eigen::Vector3d p_WT(-0.010 + 0.012 * std::sin(0.9 * t_s), side * 0.022 + 0.010 * std::sin(0.5 * t_s),
                               0.030 + 0.010 * std::cos(0.7 * t_s));
    sample.arms[arm].set_setpoint({p_WT, Eigen::Quaterniond::Identity()}, 0.2 + 0.05 * std::sin(t_s));
    sample.arms[arm].measured = demonstration::CompactPose::from({p_WT, Eigen::Quaterniond::Identity()});
    sample.arms[arm].jaw_rad = static_cast<float>(sample.arms[arm].setpoint_jaw_rad);
  }
  return sample;
}

/// `count` samples in five segments of equal length, with a world and two hash marks.
inline demonstration::Recording moving_recording(int count) {
  demonstration::Recording recording;
  recording.provenance.operator_kind = "scripted";
  recording.provenance.skill = "expert";
  recording.provenance.seed = 0xFFFFFFFFFFFFFFFFULL;
  recording.initial_world = std::string("world\0bytes", 11);
  for (int i = 0; i < count; ++i) {
    recording.samples.push_back(moving_sample(i));
    recording.samples.back().segment = static_cast<demonstration::Segment>(i * demonstration::kSegmentCount / count);
  }
  recording.hashes = {{0, 1}, {995, 0xFFFFFFFFFFFFFFFFULL}};
  return recording;
}

inline demonstration::Demonstration moving_demonstration(int count) {
  return demonstration::make_demonstration({1}, "Moving",
                                           std::make_shared<const demonstration::Recording>(moving_recording(count)))
      .value();
}

/// The same motion, `count` samples at another rate, as a camera or another robot gives them.
inline demonstration::Demonstration slow_demonstration(int count, double rate_hz) {
  demonstration::Recording recording;
  recording.provenance.operator_kind = "imported";
  for (int i = 0; i < count; ++i) {
    const std::int64_t tick = std::llround(1000.0 * i / rate_hz);
    recording.samples.push_back(moving_sample(static_cast<int>(tick / demonstration::kTicksPerSample)));
    recording.samples.back().tick = tick;
    recording.samples.back().segment = static_cast<demonstration::Segment>(i * demonstration::kSegmentCount / count);
  }
  return demonstration::make_demonstration({1}, "Slow",
                                           std::make_shared<const demonstration::Recording>(std::move(recording)))
      .value();
}

/// What a demonstration was made of, as it was recorded.
inline demonstration::Recording recording_of(const demonstration::Demonstration& document) {
  demonstration::Recording recording;
  static_cast<demonstration::RecordingInfo&>(recording) = *document.recording;
  recording.samples = document.recorded.to_vector();
  return recording;
}

}  // namespace trocar::testing
