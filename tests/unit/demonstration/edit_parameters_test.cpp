// What the parameters of edits mean: eased and warped time, channels that come back, pauses that stay, ways to
// resample.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "engine/core/random.h"
#include "engine/demonstration/edit_effect.h"
#include "engine/demonstration/edits.h"
#include "engine/demonstration/events.h"
#include "engine/demonstration/idle_cuts.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/time_warp.h"
#include "tests/support/document_samples.h"

using namespace trocar;
using namespace trocar::demonstration;

namespace {

Demonstration made(const Demonstration& document, const Edit& edit) {
  Result<Demonstration> result = apply(document, edit, 7);
  REQUIRE_MESSAGE(result.has_value(), (result ? "" : result.error().text()));
  return std::move(*result);
}

std::string refusal(const Demonstration& document, const Edit& edit) {
  const Result<Demonstration> result = apply(document, edit, 7);
  return result ? "" : result.error().text();
}

Eigen::Vector3d tip_at(const Demonstration& document, double t_s, std::size_t arm = 0) {
  return measured_tip(document.sample_at(t_s), arm);
}

double speed_at(const Demonstration& document, double t_s) {
  return (tip_at(document, t_s + 0.005) - tip_at(document, t_s)).norm() / 0.005;
}

Demonstration of(Recording recording) {
  return make_demonstration({1}, "Made", std::make_shared<const Recording>(std::move(recording))).value();
}

/// Still from 0 to 1 s, from 4 to 6 s and from 9 to 10 s.
Demonstration with_pauses() {
  Recording recording = testing::moving_recording(2001);
  const auto still = [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i <= last; ++i) recording.samples[i].arms = recording.samples[first].arms;
  };
  for (std::size_t i = 0; i <= 200; ++i) recording.samples[i].arms = recording.samples[200].arms;
  still(800, 1200);
  still(1800, 2000);
  return of(std::move(recording));
}

/// The left gripper closes and opens again, slowly and with tremor.
Demonstration with_gripper() {
  Recording recording = testing::moving_recording(1001);
  for (Sample& sample : recording.samples) {
    const double t_s = sample.t_s();
    const double open = t_s < 1.0 ? 1.0 : t_s < 2.0 ? 2.0 - t_s : t_s < 3.0 ? 0.0 : t_s < 4.0 ? t_s - 3.0 : 1.0;
    const double jaw_rad = 0.05 + 0.55 * open + 0.01 * std::sin(60.0 * t_s);
    sample.arms[0].setpoint_jaw_rad = jaw_rad;
    sample.arms[0].jaw_rad = static_cast<float>(jaw_rad);
  }
  return of(std::move(recording));
}

}  // namespace

TEST_CASE("a curve through rising knots passes them and never falls") {
  CHECK(rc::check([](std::uint64_t seed) {
    Random random(seed);
    std::vector<Eigen::Vector2d> knots{{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)}};
    for (int i = 0; i < 6; ++i) {
      knots.push_back(knots.back() + Eigen::Vector2d(random.uniform(0.01, 2.0), random.uniform(0.01, 2.0)));
    }
    const MonotoneCurve curve(knots);
    for (const Eigen::Vector2d& knot : knots) RC_ASSERT(std::abs(curve.at(knot.x()) - knot.y()) < 1e-12);
    double last = curve.at(knots.front().x());
    for (int i = 1; i <= 500; ++i) {
      const double now = curve.at(knots.front().x() + i / 500.0 * (knots.back().x() - knots.front().x()));
      RC_ASSERT(now >= last - 1e-12);
      last = now;
    }
  }));
}

TEST_CASE("knots of a warp that turn back, or lie outside of the span, are refused in a sentence") {
  const auto wrong = [](const std::vector<Eigen::Vector2d>& knots) {
    const auto all = warp_knots(knots, 1.0, 3.0);
    return all ? "" : all.error().text();
  };
  CHECK(wrong({}) == "a time warp needs a knot, old time to new time, such as --knots 1.5:2");
  CHECK(wrong({{0.5, 1.0}}) == "the knot 0.5:1 is not within 1.000–3.000 s");
  CHECK(wrong({{3.0, 3.0}, {4.0, 5.0}}) == "the knot 4:5 is not within 1.000–3.000 s");
  CHECK(wrong({{2.0, 3.0}, {1.5, 4.0}}) == "old and new times must increase from knot to knot: 1.5:4 comes after 2:3");
  CHECK(wrong({{2.0, 0.5}}) == "old and new times must increase from knot to knot: 2:0.5 comes after 1:1");
  const auto whole = warp_knots({{2.0, 2.5}}, 1.0, 3.0).value();
  REQUIRE(whole.size() == 3);
  CHECK(whole.back() == Eigen::Vector2d(3.0, 3.5));
}

TEST_CASE("a warp brings what was at the old time to the new one, and labels with it") {
  Demonstration document = testing::moving_demonstration(1000);
  document.segments = {{Segment::kA, 0.0, 2.0}, {Segment::kB, 2.0, 4.0}};
  Retime warp{1.0, 3.0, RetimeTo::kWarp};
  warp.knots_s = {{2.0, 2.5}, {3.0, 3.2}};
  const Demonstration warped = made(document, warp);
  CHECK(warped.full_duration_s() == doctest::Approx(document.full_duration_s() + 0.2));
  CHECK((tip_at(warped, 2.5) - tip_at(document, 2.0)).norm() < 1e-6);
  CHECK(tip_at(warped, 3.2) == tip_at(document, 3.0));
  CHECK(tip_at(warped, 4.2) == tip_at(document, 4.0));
  CHECK(warped.segments[0].end_s == doctest::Approx(2.5).epsilon(1e-6));
  CHECK(warped.segments[1].end_s == doctest::Approx(4.2));
}

TEST_CASE("an ease begins and ends at rest, the middle keeps its speed, and the span is longer by half of both") {
  const Demonstration document = testing::moving_demonstration(1000);
  Retime ease{1.0, 3.0, RetimeTo::kScale};
  ease.ease_in_s = 0.4;
  ease.ease_out_s = 0.6;
  const Demonstration eased = made(document, ease);
  CHECK(eased.full_duration_s() == doctest::Approx(document.full_duration_s() + 0.5));
  CHECK(speed_at(eased, 1.0) < 0.05 * speed_at(document, 1.0));
  CHECK(speed_at(eased, 3.49) < 0.05 * speed_at(document, 3.0));
  // 0.2 s of the easing in have gone by for nothing.
  CHECK((tip_at(eased, 2.2) - tip_at(document, 2.0)).norm() < 1e-6);
  CHECK(tip_at(eased, 3.5) == tip_at(document, 3.0));
  Retime fixed = ease;
  fixed.mode = RetimeTo::kDuration;
  fixed.duration_s = 2.0;
  CHECK(made(document, fixed).full_duration_s() == doctest::Approx(document.full_duration_s()));
  fixed.duration_s = 0.9;
  CHECK(refusal(document, fixed) == "easing in and out takes 1.00 s, and the span would last 0.90 s");
  ease.ease_in_s = -0.1;
  CHECK(refusal(document, ease) == "an ease must be a number from 0");
}

TEST_CASE("resampling goes along a cubic, straight, or takes the nearest sample") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration coarse = made(document, Resample{10.0});
  const auto furthest = [&](ResampleBy method) {
    const Demonstration fine = made(coarse, Resample{200.0, method});
    double furthest_m = 0.0;
    for (double t_s = 0.2; t_s < 4.7; t_s += 0.005) {
      furthest_m = std::max(furthest_m, (tip_at(fine, t_s) - tip_at(document, t_s)).norm());
    }
    return furthest_m;
  };
  const double cubic_m = furthest(ResampleBy::kCubic);
  const double linear_m = furthest(ResampleBy::kLinear);
  CHECK(cubic_m < 0.1 * linear_m);
  CHECK(linear_m < 0.1 * furthest(ResampleBy::kNearest));
  const Demonstration nearest = made(document, Resample{100.0, ResampleBy::kNearest});
  CHECK(tip_at(nearest, 2.0) == tip_at(document, 2.0));
}

TEST_CASE("a rate that cannot hold the motion is remarked on, with the share that is lost") {
  Recording recording = testing::moving_recording(2000);
  for (Sample& sample : recording.samples) {
    sample.arms[0].measured.p[0] += static_cast<float>(0.001 * std::sin(2.0 * 3.14159265 * 8.0 * sample.t_s()));
  }
  const Demonstration document = of(std::move(recording));
  // The wave of 8 Hz carries nearly all of the energy; of the motion itself almost nothing is above 2 Hz.
  CHECK(energy_above(document, 6.0) > 0.5);
  CHECK(energy_above(document, 10.0) < 0.05);
  CHECK(energy_above(testing::moving_demonstration(2000), 5.0) < 0.01);
  const Resample coarse{10.0};
  const auto remarks = effect_of(coarse, document, made(document, coarse)).remarks;
  REQUIRE(remarks.size() == 1);
  CHECK(remarks.front().find("above 5 Hz") != std::string::npos);
  const Resample fine{100.0};
  CHECK(effect_of(fine, document, made(document, fine)).remarks.empty());
}

TEST_CASE("what is idle is listed, and what is to stay stays") {
  const Demonstration document = with_pauses();
  TrimIdle trim;
  trim.inside = true;
  const auto cuts = idle_cuts(document, trim).value();
  REQUIRE(cuts.size() == 3);
  CHECK(cuts[0].at_end);
  CHECK_FALSE(cuts[1].at_end);
  CHECK(cuts[1].begin_s == doctest::Approx(4.0).epsilon(0.05));
  CHECK(cuts[2].at_end);
  const double all_s = made(document, trim).duration_s();
  trim.stay_s = {5.0};
  CHECK(idle_cuts(document, trim).value()[1].stays);
  const double longer_s = made(document, trim).duration_s();
  CHECK(longer_s - all_s == doctest::Approx(cuts[1].to_s - cuts[1].from_s).epsilon(0.01));
  trim.stay_s = {0.5, 5.0};
  CHECK(made(document, trim).begin_s == 0.0);
  trim.stay_s = {0.5, 5.0, 9.8};
  CHECK(refusal(document, trim) == "all that is idle is to stay");
}

TEST_CASE("of a pause a number of samples can stay") {
  const Demonstration document = with_pauses();
  TrimIdle trim;
  trim.ends = false;
  trim.inside = true;
  trim.keep_samples = 40;
  const auto cuts = idle_cuts(document, trim).value();
  REQUIRE(cuts.size() == 1);
  CHECK(cuts[0].from_s - cuts[0].begin_s == doctest::Approx(0.2));
}

TEST_CASE("one channel of one arm comes back, and all else stays as edited") {
  const Demonstration document = with_gripper();
  Demonstration edited = made(document, Offset{Arms::kBoth, {0.002, 0.0, 0.0}});
  edited = made(edited, SetJaw{Arms::kLeft, 0.0, 4.9, 0.9, 0.0});
  edited.segments = {{Segment::kE, 0.0, 5.0}};
  const auto jaw = [](const Demonstration& shown) { return shown.sample_at(2.5).arms[0].setpoint_jaw_rad; };
  const Demonstration pose = made(edited, Revert{1.0, 4.0, Arms::kLeft, RevertWhat::kPose});
  CHECK(tip_at(pose, 2.5, 0) == tip_at(document, 2.5, 0));
  CHECK(tip_at(pose, 2.5, 1) == tip_at(edited, 2.5, 1));
  CHECK(tip_at(pose, 0.5, 0) == tip_at(edited, 0.5, 0));
  CHECK(jaw(pose) == jaw(edited));
  const Demonstration gripper = made(edited, Revert{1.0, 4.0, Arms::kBoth, RevertWhat::kJaw});
  CHECK(jaw(gripper) == jaw(document));
  CHECK(tip_at(gripper, 2.5, 0) == tip_at(edited, 2.5, 0));
  const Demonstration right = made(edited, Revert{1.0, 4.0, Arms::kRight, RevertWhat::kSamples});
  CHECK(tip_at(right, 2.5, 1) == tip_at(document, 2.5, 1));
  CHECK(jaw(right) == jaw(edited));
  const Demonstration labels = made(edited, Revert{1.5, 2.5, Arms::kBoth, RevertWhat::kLabels});
  REQUIRE(labels.segments.size() == 4);
  CHECK(labels.segments[0] == SegmentSpan{Segment::kE, 0.0, 1.5});
  CHECK(labels.segments[1].label == Segment::kB);
  CHECK(labels.segments[2].label == Segment::kC);
  CHECK(labels.segments[3].begin_s == 2.5);
  CHECK(tip_at(labels, 2.0, 0) == tip_at(edited, 2.0, 0));
}

TEST_CASE("gripper events are found and made one ramp each, between where the jaw rests") {
  const Demonstration document = with_gripper();
  const Demonstration clean = made(document, JawEvents{0.0, 5.0, Arms::kLeft, 0.2});
  const auto jaw = [&](double t_s) { return clean.sample_at(t_s).arms[0].setpoint_jaw_rad; };
  // Half of the way was at 1.5 s and at 3.5 s.
  CHECK(jaw(1.3) == doctest::Approx(0.6).epsilon(0.03));
  CHECK(jaw(1.7) == doctest::Approx(0.05).epsilon(0.3));
  CHECK(jaw(3.3) == jaw(1.7));
  CHECK(jaw(3.7) == doctest::Approx(0.6).epsilon(0.03));
  CHECK(jaw(2.0) == jaw(3.0));
  CHECK(clean.sample_at(2.0).arms[1].setpoint_jaw_rad == document.sample_at(2.0).arms[1].setpoint_jaw_rad);
  CHECK(refusal(testing::moving_demonstration(1000), JawEvents{0.0, 4.9}) ==
        "no gripper opens or closes from 0.00 to 4.90 s");
}

TEST_CASE("smoothing a recording of uneven times, with a gap or to a limit leaves it less rough, never more") {
  // 30 Hz with times that jitter by 2 ms, half a second missing, and a tremor.
  Recording recording;
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    if (i >= 100 && i < 115) continue;
    const double t_s = i / 30.0;
    Sample sample = testing::moving_sample(0);
    sample.tick = std::llround(1000.0 * (t_s + random.uniform(-0.002, 0.002)) + 10.0);
    const Eigen::Vector3d p_WT(0.04 * t_s / 10.0, 0.01 * std::sin(t_s), 0.03 + 0.005 * std::sin(2.0 * t_s));
    sample.arms[0].measured = CompactPose::from(
        spatial::Pose::translation(p_WT + 4e-4 * Eigen::Vector3d(random.normal(), random.normal(), random.normal())));
    recording.samples.push_back(sample);
  }
  const Demonstration document = of(std::move(recording));
  const auto jerk = [&](const Demonstration& shown, const Edit& edit) {
    return effect_of(edit, document, shown).after.mean_jerk_m_s3[0];
  };
  for (const Filter filter : {Filter::kSavitzkyGolay, Filter::kGaussian, Filter::kLowPass}) {
    for (const double most_m : {0.0002, 0.0005, 0.002}) {
      const Smooth smooth{0.0, 9.9, Arms::kLeft, filter, 0.3, most_m};
      CAPTURE(static_cast<int>(filter));
      CAPTURE(most_m);
      const Demonstration after = made(document, smooth);
      CHECK(jerk(after, smooth) < 0.95 * jerk(document, smooth));
      double furthest_m = 0.0;
      for (std::size_t i = 0; i < after.samples.size(); ++i) {
        const double by_m = (measured_tip(after.samples[i], 0) - measured_tip(document.samples[i], 0)).norm();
        furthest_m = std::max(furthest_m, by_m);
      }
      CHECK(furthest_m <= most_m + 1e-7);
    }
  }
}

TEST_CASE("smoothing holds still where a gripper moves, and sets in gently, only if it is asked to") {
  Recording recording = testing::recording_of(with_gripper());
  Random random(1);
  for (Sample& sample : recording.samples) {
    for (float& p : sample.arms[0].measured.p) p += static_cast<float>(2e-4 * random.normal());
    // Without tremor: only the two ramps move the jaw.
    sample.arms[0].setpoint_jaw_rad = std::round(10.0 * sample.arms[0].setpoint_jaw_rad) / 10.0;
  }
  const Demonstration document = of(std::move(recording));
  Smooth smooth{0.0, 5.0, Arms::kLeft, Filter::kGaussian, 0.2, 0.001, true};
  const auto moved_m = [&](const Demonstration& after, double from_s, double to_s) {
    double most_m = 0.0;
    for (double t_s = from_s; t_s < to_s; t_s += 0.005) {
      most_m = std::max(most_m, (tip_at(after, t_s) - tip_at(document, t_s)).norm());
    }
    return most_m;
  };
  const Demonstration plain = made(document, smooth);
  smooth.lock_jaws = true;
  const Demonstration held = made(document, smooth);
  double event_s = 0.0;
  for (const Event& event : events_within(document, 0.0, 5.0)) {
    if (event.kind == EventKind::kJawCloses) event_s = event.t_s;
  }
  REQUIRE(event_s > 1.0);
  CHECK(moved_m(plain, event_s - 0.04, event_s + 0.04) > 5e-5);
  CHECK(moved_m(held, event_s - 0.04, event_s + 0.01) < 1e-8);
  CHECK(moved_m(held, 0.4, 0.8) > 5e-5);
  smooth.lock_ends = false;
  CHECK(moved_m(made(document, smooth), 0.01, 0.03) > moved_m(held, 0.01, 0.03));
}

TEST_CASE("an edit is measured where it worked: the peak of its span, before and after") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Retime hurry{1.0, 3.0, RetimeTo::kScale, 0.01};
  const EditEffect effect = effect_of(hurry, document, made(document, hurry));
  CHECK(effect.before.from_s == 1.0);
  CHECK(effect.after.to_s == doctest::Approx(1.02));
  CHECK(effect.after.fastest_m_s() > 10.0 * effect.before.fastest_m_s());
  REQUIRE(effect.remarks.size() == 1);
  CHECK(effect.remarks.front().find("more than the 250 mm/s that it may") != std::string::npos);
}
