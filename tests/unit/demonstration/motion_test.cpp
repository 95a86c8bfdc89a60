#include "engine/demonstration/motion.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "engine/demonstration/quality.h"
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
  const JerkSummary trembling = jerk_without_tremor(swinging(0.0, 0.0001), 0).value();
  CHECK(trembling.mean_m_s3 < 0.5);
  // A ω³ = 0.02 π³ = 0.620 m/s³ at most, 2/π of that in the mean; the filter takes 1.2 % of it.
  const JerkSummary slow = jerk_without_tremor(swinging(0.020, 0.0), 0).value();
  CHECK(slow.mean_m_s3 == doctest::Approx(0.395).epsilon(0.05));
  CHECK(slow.peak_m_s3 == doctest::Approx(0.62).epsilon(0.1));
}

TEST_CASE("the smoothed jerk of a moment is none") {
  CHECK_FALSE(jerk_without_tremor(testing::moving_demonstration(40), 0));
}

TEST_CASE("at 8 Hz there is a jerk and what moves is not idle; at 2 Hz the jerk cannot be told") {
  // Of the motion in `moving_sample` the fastest part is 0.012 m · (0.9 / s)³ = 0.0087 m/s³.
  const Demonstration rare = testing::slow_demonstration(80, 8.0);
  const std::optional<JerkSummary> jerk = jerk_without_tremor(rare, 0);
  REQUIRE(jerk);
  CHECK(jerk->mean_m_s3 > 0.002);
  CHECK(jerk->peak_m_s3 < 0.03);
  CHECK(quality(rare).mean_jerk_m_s3[0].has_value());
  CHECK(idle_share(rare).value() < 0.1);
  const Demonstration rarer = testing::slow_demonstration(40, 2.0);
  CHECK_FALSE(jerk_without_tremor(rarer, 0));
  CHECK_FALSE(quality(rarer).mean_jerk_m_s3[0]);
  CHECK(idle_share(rarer).value() < 0.2);
  CHECK_FALSE(idle_share(testing::slow_demonstration(2, 2.0)));
}

}  // namespace trocar::demonstration
