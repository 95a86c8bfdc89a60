#include "engine/demonstration/problems.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "engine/demonstration/diff.h"
#include "engine/demonstration/edits.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/quality.h"
#include "tests/support/document_samples.h"

using namespace trocar;
using namespace trocar::demonstration;
using testing::moving_demonstration;
using testing::moving_recording;

namespace {

Demonstration changed(int count, const std::function<void(std::vector<Sample>&)>& change) {
  Recording recording = moving_recording(count);
  change(recording.samples);
  return make_demonstration({1}, "Changed", std::make_shared<const Recording>(std::move(recording))).value();
}

std::vector<Problem> of_kind(const Demonstration& document, ProblemKind kind) {
  std::vector<Problem> found = problems(document, spatial::Grid());
  std::erase_if(found, [&](const Problem& problem) { return problem.kind != kind; });
  return found;
}

void hold_still(std::vector<Sample>& samples, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    const Sample still = samples[first];
    for (std::size_t arm = 0; arm < 2; ++arm) samples[i].arms[arm] = still.arms[arm];
  }
}

}  // namespace

TEST_CASE("a smooth, complete demonstration inside of the cube has no problems") {
  CHECK(problems(moving_demonstration(1000), spatial::Grid()).empty());
}

TEST_CASE("samples of segment A outside of the cube are one warning with their span, those of B are none") {
  const auto found = of_kind(changed(1000,
                                     [](std::vector<Sample>& samples) {
                                       for (std::size_t i = 100; i < 120; ++i) samples[i].arms[0].measured.p[2] = 0.0F;
                                       for (std::size_t i = 300; i < 320; ++i) samples[i].arms[0].measured.p[2] = 0.0F;
                                     }),
                             ProblemKind::kLattice);
  REQUIRE(found.size() == 1);
  CHECK(found[0].severity == Severity::kWarning);
  CHECK(found[0].begin_s == doctest::Approx(0.5));
  CHECK(found[0].end_s == doctest::Approx(0.595));
  CHECK(found[0].message == "20 samples of segment A lie outside of the learning cube, by up to 2.5 mm");
}

TEST_CASE("a gap is a warning, a long one an error") {
  const auto with_gap = [](std::int64_t ticks) {
    return of_kind(changed(100,
                           [&](std::vector<Sample>& samples) {
                             for (std::size_t i = 50; i < 100; ++i) samples[i].tick += ticks;
                           }),
                   ProblemKind::kTime);
  };
  REQUIRE(with_gap(20).size() == 1);
  CHECK(with_gap(20)[0].severity == Severity::kWarning);
  CHECK(with_gap(20)[0].message == "no sample for 25 ms where one comes every 5 ms");
  CHECK(with_gap(1000)[0].severity == Severity::kError);
}

TEST_CASE("a gap is one by the rate beside it: 30 Hz has none, nor where 200 Hz follow, and one dropped frame is one") {
  const Demonstration slow = testing::slow_demonstration(120, 30.0);
  const auto time = [](const Demonstration& document) {
    auto found = problems(document, spatial::Grid{});
    std::erase_if(found, [](const Problem& problem) { return problem.kind != ProblemKind::kTime; });
    return found;
  };
  CHECK(time(slow).empty());
  Recording recording = testing::recording_of(slow);
  const std::int64_t last = recording.samples.back().tick;
  for (int i = 1; i < 400; ++i) {
    recording.samples.push_back(recording.samples.back());
    recording.samples.back().tick = last + std::int64_t{i} * kTicksPerSample;
  }
  const auto remade = [](Recording changed) {
    return make_demonstration({1}, "Mixed", std::make_shared<const Recording>(std::move(changed))).value();
  };
  CHECK(time(remade(recording)).empty());
  recording.samples.erase(recording.samples.begin() + 61);
  const auto dropped = time(remade(recording));
  REQUIRE(dropped.size() == 1);
  CHECK(dropped[0].message == "no sample for 67 ms where one comes every 33 ms");
  CHECK(dropped[0].severity == Severity::kWarning);
}

TEST_CASE("a rotation that is not of unit length is an error") {
  const auto found = of_kind(changed(100,
                                     [](std::vector<Sample>& samples) {
                                       samples[7].arms[1].setpoint_q_wxyz = {0.5, 0, 0, 0};
                                     }),
                             ProblemKind::kQuaternion);
  REQUIRE(found.size() == 1);
  CHECK(found[0].severity == Severity::kError);
}

TEST_CASE("setpoints that no arm can follow are errors: far outside, beyond the jaws' limits, a leap") {
  const auto with = [](const std::function<void(ArmSample&)>& change) {
    return changed(1000, [&](std::vector<Sample>& samples) {
      for (std::size_t i = 500; i < 520; ++i) change(samples[i].arms[0]);
    });
  };
  const auto far = of_kind(with([](ArmSample& arm) { arm.setpoint_p[0] = 1e30; }), ProblemKind::kWorkspace);
  REQUIRE(far.size() == 1);
  CHECK(far[0].severity == Severity::kError);
  CHECK(far[0].begin_s == doctest::Approx(2.5));
  CHECK(far[0].end_s == doctest::Approx(2.595));
  const auto near = of_kind(with([](ArmSample& arm) { arm.setpoint_p[0] = 0.08; }), ProblemKind::kWorkspace);
  REQUIRE(near.size() == 1);
  CHECK(near[0].severity == Severity::kWarning);
  const auto measured = of_kind(with([](ArmSample& arm) { arm.measured.p[1] = 1.0F; }), ProblemKind::kWorkspace);
  REQUIRE(measured.size() == 1);
  CHECK(measured[0].severity == Severity::kError);
  const auto jaw = of_kind(with([](ArmSample& arm) { arm.setpoint_jaw_rad = 1e9; }), ProblemKind::kJaw);
  REQUIRE(jaw.size() > 1);  // Where it is, and how fast it got there and back.
  CHECK(std::count_if(jaw.begin(), jaw.end(), [](const Problem& p) { return p.severity == Severity::kError; }) == 1);
  const auto leap = of_kind(with([](ArmSample& arm) { arm.setpoint_p[2] += 0.006; }), ProblemKind::kSpeed);
  REQUIRE_FALSE(leap.empty());
  CHECK(leap[0].severity == Severity::kError);
  CHECK(leap[0].message.starts_with("the left tool's setpoint leaps by "));
  const auto fast = of_kind(with([](ArmSample& arm) { arm.setpoint_p[2] += 0.002; }), ProblemKind::kSpeed);
  REQUIRE_FALSE(fast.empty());
  CHECK(fast[0].severity == Severity::kWarning);
}

TEST_CASE("a leap of 100 mm within one sample is a speed, an acceleration and a jerk") {
  const Demonstration leap = changed(1000, [](std::vector<Sample>& samples) {
    for (std::size_t i = 500; i < 1000; ++i) samples[i].arms[1].measured.p[0] += 0.1F;
  });
  for (const ProblemKind kind : {ProblemKind::kSpeed, ProblemKind::kAcceleration, ProblemKind::kJerk}) {
    const auto found = of_kind(leap, kind);
    REQUIRE(found.size() == 1);
    CHECK(std::abs(found[0].begin_s - 2.5) < 0.1);
  }
}

TEST_CASE("missing segments are warnings and segments out of order an error") {
  Demonstration document = moving_demonstration(1000);
  std::swap(document.segments[0].label, document.segments[1].label);
  document.segments.pop_back();
  const auto found = of_kind(document, ProblemKind::kSegments);
  const auto has = [&](Severity severity, std::string_view message) {
    return std::any_of(found.begin(), found.end(),
                       [&](const Problem& each) { return each.severity == severity && each.message == message; });
  };
  CHECK(has(Severity::kWarning, "segment E is missing"));
  CHECK(has(Severity::kError, "segment B comes before segment A"));
}

TEST_CASE("a segment that comes again is a warning, and an error where another lies between") {
  Demonstration document = moving_demonstration(1000);
  const auto messages = [&] {
    std::vector<std::string> all;
    for (const Problem& each : of_kind(document, ProblemKind::kSegments)) all.push_back(each.message);
    return all;
  };
  REQUIRE(document.segments.size() == 5);
  CHECK(messages().empty());
  document.segments[1].label = Segment::kA;  // A A C D E
  CHECK(messages() ==
        std::vector<std::string>{"segment B is missing", "segment A comes again; only its first stretch counts"});
  document.segments[1].label = Segment::kB;
  document.segments[4].label = Segment::kC;  // A B C D C
  CHECK(messages() == std::vector<std::string>{"segment E is missing", "segment D comes before segment C",
                                               "segment C comes again; only its first stretch counts"});
}

TEST_CASE("a segment of which only rounding lies between the gates is none") {
  Demonstration document = moving_demonstration(1000);
  document.segments[4].end_s = 4.5;
  document.segments.push_back({Segment::kA, 4.5, document.end_s});
  document.end_s = 4.5 + 1e-14;
  REQUIRE(document.end_s > document.segments[5].begin_s);
  CHECK(of_kind(document, ProblemKind::kSegments).empty());
  document.end_s = 4.6;
  CHECK_FALSE(of_kind(document, ProblemKind::kSegments).empty());
}

TEST_CASE("samples at other instants than before are compared with the way between, so that a bridge moves some") {
  const Demonstration document = moving_demonstration(1000);
  std::vector<Sample> uneven;
  for (int i = 0; i < 1000; i += 6) {
    uneven.push_back(document.samples[static_cast<std::size_t>(i)]);
    if (i > 0) uneven.back().tick += i * 7 % 5 - 2;
  }
  Recording recording = testing::recording_of(document);
  recording.samples = uneven;
  const Demonstration hand =
      make_demonstration({1}, "Hand", std::make_shared<const Recording>(std::move(recording))).value();
  Bridge bridge;
  bridge.from_s = 1.0;
  bridge.to_s = 2.0;
  const Demonstration after = apply(hand, bridge, 1).value();
  const Difference found = difference(hand, after);
  CHECK(found.moved > 0);
  CHECK(found.max_deviation_m > kUnmoved_m);
  CHECK(difference(hand, hand).moved == 0);
}

TEST_CASE("a difference names the labels and notes that changed") {
  const Demonstration before = moving_demonstration(1000);
  CHECK(label_differences(before, before).empty());
  Demonstration after = before;
  after.segments[0] = {Segment::kA, 0.25, 0.5};
  after.segments.pop_back();
  after.notes.push_back({1, 0.75, 0.75, "slips", "", 0});
  after.goal = before.goal + 1;
  const std::vector<std::string> clauses = label_differences(before, after);
  REQUIRE(clauses.size() == 4);
  CHECK(clauses[0].ends_with(", is 0.25–0.50 s"));
  CHECK(clauses[1].starts_with("segment E is gone, was "));
  CHECK(clauses[2] == "the note \"slips\" at 0.75 s is new");
  CHECK(clauses[3] == "the goal was " + std::to_string(before.goal) + ", is " + std::to_string(after.goal));
}

TEST_CASE("an idle end comes with the trim that removes it, and the trim removes it") {
  Demonstration document = changed(1000, [](std::vector<Sample>& samples) { hold_still(samples, 800, 1000); });
  const auto found = of_kind(document, ProblemKind::kIdle);
  REQUIRE(found.size() == 1);
  CHECK(found[0].fix.starts_with("trim --from 0.00 --to 4.1"));
  const Demonstration trimmed = apply(document, idle_ends(document).value()).value();
  CHECK(of_kind(trimmed, ProblemKind::kIdle).empty());
  CHECK(trimmed.end_s > 4.0);
}

TEST_CASE("a hand that trembles in place is idle, wherever the gate is") {
  const Demonstration document = changed(1000, [](std::vector<Sample>& samples) {
    hold_still(samples, 0, 600);
    for (std::size_t i = 0; i < 600; ++i) {
      const double phase = 2.0 * 3.14159265358979 * 9.0 * samples[i].t_s();
      samples[i].arms[0].measured.p[0] += static_cast<float>(1e-4 * std::sin(phase));
    }
  });
  for (const double gate_s : {0.0, 0.333, 1.0}) {
    const Demonstration gated = apply(document, Trim{gate_s, 4.9}).value();
    const auto trim = idle_ends(gated);
    REQUIRE(trim.has_value());
    CHECK(trim->from_s == doctest::Approx(3.0 - kIdleMargin_s).epsilon(0.03));
  }
}

TEST_CASE("a pause of less than 0.3 s at the end is left alone") {
  const Demonstration document = changed(1000, [](std::vector<Sample>& samples) { hold_still(samples, 950, 1000); });
  CHECK_FALSE(idle_ends(document));
}

TEST_CASE("a gripper that closes far from every block is a warning") {
  const auto closing = [](bool block) {
    return changed(1000, [block](std::vector<Sample>& samples) {
      // At 6 rad/s, as fast as jaws may go.
      for (int i = 0; i < 1000; ++i) {
        Sample& sample = samples[static_cast<std::size_t>(i)];
        sample.arms[0].setpoint_jaw_rad = std::clamp(0.6 - 0.03 * (i - 500), 0.0, 0.6);
        if (block) sample.blocks[2].p = {0.0F, 0.2F, 0.0F};
      }
    });
  };
  const auto found = of_kind(closing(true), ProblemKind::kJaw);
  REQUIRE(found.size() == 1);
  CHECK(found[0].begin_s == doctest::Approx(2.585));
  // Where nobody recorded the blocks, nobody knows.
  CHECK(of_kind(closing(false), ProblemKind::kJaw).empty());
}

TEST_CASE("a hand-over needs a moment in which both arms hold the block") {
  const auto hand_over = [](std::size_t left_until) {
    return of_kind(changed(1000,
                           [&](std::vector<Sample>& samples) {
                             for (std::size_t i = 300; i < left_until; ++i) samples[i].flags |= kLeftHolds;
                             for (std::size_t i = 600; i < 900; ++i) samples[i].flags |= kRightHolds;
                           }),
                   ProblemKind::kJaw);
  };
  CHECK(hand_over(620).empty());
  CHECK(hand_over(590).size() == 1);
}

TEST_CASE("a number that is not finite is reported and does not stop the other checks") {
  Demonstration document = moving_demonstration(1000);
  std::vector<Sample> samples = document.samples.to_vector();
  samples[10].arms[0].measured.p[0] = std::numeric_limits<float>::quiet_NaN();
  document.samples = SampleTrack(std::move(samples));
  document.segments.pop_back();
  const auto found = problems(document, spatial::Grid());
  CHECK(found[0].severity != Severity::kInfo);
  CHECK(of_kind(document, ProblemKind::kNotFinite).size() == 1);
  CHECK_FALSE(of_kind(document, ProblemKind::kSegments).empty());
}

TEST_CASE("quality measures a straight motion at constant speed exactly") {
  const Demonstration document = changed(1000, [](std::vector<Sample>& samples) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      samples[i].arms[0].measured = CompactPose::from(spatial::Pose::translation({1e-4 * double(i), 0.0, 0.0}));
      samples[i].arms[1].measured = CompactPose{};
    }
  });
  const Quality measured = quality(document);
  CHECK(measured.path_length_m[0] == doctest::Approx(0.0999).epsilon(1e-5));
  CHECK(measured.path_length_m[1] == 0.0);
  CHECK(measured.mean_speed_m_s[0] == doctest::Approx(0.02).epsilon(1e-5));
  CHECK(measured.peak_speed_m_s[0] == doctest::Approx(0.02).epsilon(1e-3));
  CHECK(measured.mean_jerk_m_s3[0].value() < 0.01);
  CHECK(measured.rate_hz == doctest::Approx(200.0));
  CHECK(measured.idle_share == 0.0);
}

TEST_CASE("a trim removes samples and moves none") {
  const Demonstration document = moving_demonstration(1000);
  const Demonstration trimmed = apply(document, Trim{1.0, 2.0}).value();
  const Difference found = difference(document, trimmed);
  CHECK(found.removed == 799);
  CHECK(found.added == 0);
  CHECK(found.moved == 0);
  CHECK(found.max_deviation_m == 0.0);
  CHECK(found.duration_change_s == doctest::Approx(-3.995));
  CHECK(difference(trimmed, original_of(trimmed)).added == 799);
}

TEST_CASE("two recordings are compared at equal times since their begin") {
  const Demonstration document = moving_demonstration(1000);
  const Demonstration other = changed(900, [](std::vector<Sample>& samples) {
    for (Sample& sample : samples) {
      sample.tick += 5000;
      sample.arms[0].measured.p[1] += 0.003F;
    }
  });
  const Difference found = difference(document, other);
  CHECK(found.removed == 100);
  CHECK(found.moved == 900);
  CHECK(found.max_deviation_m == doctest::Approx(0.003).epsilon(1e-4));
  CHECK(found.rms_deviation_m == doctest::Approx(0.003 / std::sqrt(2.0)).epsilon(1e-4));
}
