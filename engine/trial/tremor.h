/// Physiological tremor: narrow-band noise around 10 Hz on three axes.
#pragma once

#include <Eigen/Core>

#include "engine/core/random.h"

namespace trocar::trial {

/// A resonance driven by white noise, most of its power between 8 and 12 Hz. Threads: one at a time.
class Tremor {
 public:
  /// `rms_m`: root mean square on each axis, in metres. Sampled at 200 Hz.
  Tremor(double rms_m, const Random& random) : rms_m_(rms_m), random_(random) {}
  /// The next sample's offset of the hand.
  Eigen::Vector3d next();

 private:
  double rms_m_;
  Random random_;
  Eigen::Vector3d last_{0.0, 0.0, 0.0};
  Eigen::Vector3d before_{0.0, 0.0, 0.0};
};

}  // namespace trocar::trial
