#include "engine/demonstration/motion.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/support/document_samples.h"

namespace trocar::demonstration {
namespace {

/// The left tool along x for 8 s: a swing of 20 mm at 0.5 Hz, and a tremor of `tremor_m` at 10 Hz over it.
Demonstration swinging(double swing_m, double tremor_m) {
  Recording recording = testing::moving_recording(1600);
  for (Sample& sample : recording.samples) {
    const double turns = 2.0 * std::numbers::pi * sample.t_s();
    const double x_m = swing_m * std::sin(0.5 * turns) + tremor_m * std::sin(10.0 * turns);
    sample.arms[0].measured.p = {static_cast<float>(x_m), -0.02F, 0.03F};
  }
  return make_demonstration({1}, "Swinging", std::make_shared<const Recording>(std::move(recording))).value();
}

}  // namespace

TEST_CASE("of a tremor of 0.1 mm at 10 Hz the smoothed jerk keeps little, of a slow motion nearly all") {
  // Its own jerk is 0.0001 (2π 10)³ = 24.8 m/s³ at most.
  const JerkSummary trembling = jerk_without_tremor(swinging(0.0, 0.0001), 0);
  CHECK(trembling.mean_m_s3 < 0.5);
  // A ω³ = 0.02 π³ = 0.620 m/s³ at most, 2/π of that in the mean; the filter takes 1.2 % of it.
  const JerkSummary slow = jerk_without_tremor(swinging(0.020, 0.0), 0);
  CHECK(slow.mean_m_s3 == doctest::Approx(0.395).epsilon(0.05));
  CHECK(slow.peak_m_s3 == doctest::Approx(0.62).epsilon(0.1));
}

TEST_CASE("the smoothed jerk of a moment is none") {
  CHECK(jerk_without_tremor(testing::moving_demonstration(40), 0).peak_m_s3 == 0.0);
}

}  // namespace trocar::demonstration
