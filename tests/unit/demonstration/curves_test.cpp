#include "engine/demonstration/curves.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/demonstration/motion.h"
#include "engine/demonstration/quality.h"
#include "tests/support/document_samples.h"

using namespace trocar;
using namespace trocar::demonstration;

namespace {

/// The left tool goes along a cubic, 200 times a second: x = 3 t³ − 2 t² + 0.1 t, in tenths of a metre.
SampleTrack cubic(int count) {
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) {
    Sample sample = testing::moving_sample(i);
    const double t = sample.t_s();
    const double x = 0.1 * (3.0 * t * t * t - 2.0 * t * t + 0.1 * t);
    sample.arms[0].measured = CompactPose::from({{x, 0.0, 0.0}, Eigen::Quaterniond::Identity()});
    samples.push_back(sample);
  }
  return SampleTrack(std::move(samples));
}

}  // namespace

TEST_CASE("jerk and acceleration of a cubic are those of its formula") {
  // Positions up to 0.11 m are rounded to 4e-9 m; third differences of them over 8e-6 s³ stand for 0.004 m/s³.
  const SampleTrack track = cubic(200);
  const MotionCurve jerk = curve_of(track, 0, CurveKind::kJerk, 0);
  REQUIRE(jerk.values.size() > 40);
  for (const double value : jerk.values) CHECK(value == doctest::Approx(1.8).epsilon(0.004));
  const MotionCurve acceleration = curve_of(track, 0, CurveKind::kAcceleration, 0);
  for (std::size_t i = 0; i < acceleration.values.size(); ++i) {
    CHECK(acceleration.values[i] == doctest::Approx(std::abs(1.8 * acceleration.t_s[i] - 0.4)).epsilon(1e-3));
  }
  const MotionCurve speed = curve_of(track, 0, CurveKind::kSpeed, 0);
  for (std::size_t i = 0; i < speed.values.size(); ++i) {
    const double t = speed.t_s[i];
    // A mean over h is off by jerk · h² / 24.
    CHECK(speed.values[i] == doctest::Approx(std::abs(0.9 * t * t - 0.4 * t + 0.01)).epsilon(1e-4 + 3e-5));
  }
}

TEST_CASE("positions and jaws are those of the samples, at their times") {
  const Demonstration document = testing::moving_demonstration(400);
  const MotionCurve y = curve_of(document.samples, document.first_tick(), CurveKind::kY, 1);
  const MotionCurve jaw = curve_of(document.samples, document.first_tick(), CurveKind::kJaw, 0);
  REQUIRE(y.values.size() == 400);
  for (const std::size_t i : {0, 123, 399}) {
    const Sample sample = document.samples[i];
    CHECK(y.t_s[i] == document.time_of(sample));
    CHECK(y.values[i] == measured_tip(sample, 1).y());
    CHECK(jaw.values[i] == static_cast<double>(sample.arms[0].jaw_rad));
  }
}

TEST_CASE("a gap of more than a tenth of a second is a gap in every curve, and no motion is taken across it") {
  const SampleTrack whole = cubic(400);
  const SampleTrack gap = SampleTrack::joined({whole.slice(0, 150), whole.slice(200, 200)});
  for (const CurveKind kind : kCurveKinds) {
    if (kind == CurveKind::kClearance) continue;
    CAPTURE(to_string(kind));
    const MotionCurve curve = curve_of(gap, 0, kind, 0);
    int gaps = 0;
    for (std::size_t i = 0; i < curve.values.size(); ++i) {
      if (std::isfinite(curve.values[i])) continue;
      ++gaps;
      CHECK(curve.t_s[i] > 0.7);
      CHECK(curve.t_s[i] < 1.05);
    }
    CHECK(gaps == 1);
  }
}

TEST_CASE("between open gates the curve has the mean jerk and the peak speed that the quality tells") {
  const Demonstration document = testing::moving_demonstration(600);
  const Quality told = quality(document);
  double sum = 0.0;
  const MotionCurve jerk = curve_of(document.samples, document.first_tick(), CurveKind::kJerk, 1);
  for (const double value : jerk.values) sum += value;
  CHECK(sum / static_cast<double>(jerk.values.size()) == doctest::Approx(told.mean_jerk_m_s3[1].value()));
  double peak = 0.0;
  for (const double value : curve_of(document.samples, document.first_tick(), CurveKind::kSpeed, 0).values) {
    peak = std::max(peak, value);
  }
  CHECK(peak == told.peak_speed_m_s[0]);
}

TEST_CASE("every curve is found by its name, and an unknown name lists those that there are") {
  for (const CurveKind kind : kCurveKinds) CHECK(curve_kind_from(to_string(kind)) == kind);
  const auto unknown = curve_kind_from("sped");
  REQUIRE_FALSE(unknown);
  CHECK(unknown.error().text() ==
        "there is no curve 'sped'; there are x, y, z, speed, acceleration, jerk, jaw, clearance");
}
