#include "engine/trial/tremor.h"

#include <cmath>
#include <numbers>

#include "engine/demonstration/recording.h"

namespace trocar::trial {
namespace {

constexpr double kCentre_hz = 10.0;
// Pole radius: a half-power width of about 2.5 Hz at 200 Hz.
constexpr double kPole = 0.962;

}  // namespace

Eigen::Vector3d Tremor::next() {
  const double angle = 2.0 * std::numbers::pi * kCentre_hz / demonstration::kSampleRate_hz;
  const double a1 = 2.0 * kPole * std::cos(angle);
  const double a2 = -kPole * kPole;
  // Variance of the process for unit noise, from its Yule–Walker equations.
  const double variance = (1.0 - a2) / ((1.0 + a2) * ((1.0 - a2) * (1.0 - a2) - a1 * a1));
  const double gain = rms_m_ / std::sqrt(variance);
  const double x = random_.normal();
  const double y = random_.normal();
  const double z = random_.normal();
  Eigen::Vector3d now = a1 * last_ + a2 * before_ + gain * Eigen::Vector3d(x, y, z);
  before_ = last_;
  last_ = now;
  return now;
}

}  // namespace trocar::trial
