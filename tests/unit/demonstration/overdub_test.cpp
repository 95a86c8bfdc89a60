#include <doctest/doctest.h>

#include "engine/demonstration/clip.h"
#include "engine/demonstration/edits.h"
#include "engine/demonstration/motion.h"
#include "engine/demonstration/sampling_rate.h"
#include "tests/support/document_samples.h"

using namespace trocar;
using namespace trocar::demonstration;

namespace {

/// The moving demonstration, both tools 20 mm higher.
Demonstration higher() {
  const Demonstration document = testing::moving_demonstration(1000);
  return apply(document, Offset{Arms::kBoth, {0.0, 0.0, 0.02}}, 1).value();
}

Overdub overdub_of(const Demonstration& source, double from_s, double to_s, double at_s, Arms arms, double ease_s) {
  Overdub edit{source.id.value, from_s, to_s, at_s, arms, ease_s, 0, nullptr};
  edit.clip = std::make_shared<const Clip>(clip_of(source, from_s, to_s).value());
  return edit;
}

double apart_m(const Demonstration& a, const Demonstration& b, double t_s, std::size_t arm) {
  return (measured_tip(a.sample_at(t_s), arm) - measured_tip(b.sample_at(t_s), arm)).norm();
}

}  // namespace

TEST_CASE("an overdub replaces one arm and moves nothing in time: the other arm, labels, gates and length stay") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration edited = apply(document, overdub_of(higher(), 1.0, 1.8, 1.0, Arms::kLeft, 0.5), 3).value();
  REQUIRE(edited.samples.size() == document.samples.size());
  CHECK(edited.segments == document.segments);
  CHECK(edited.end_s == document.end_s);
  for (std::size_t i = 0; i < document.samples.size(); ++i) {
    REQUIRE(edited.samples.tick(i) == document.samples.tick(i));
    REQUIRE(edited.samples[i].arms[1].setpoint_p == document.samples[i].arms[1].setpoint_p);
    REQUIRE(edited.samples[i].arms[1].measured.p == document.samples[i].arms[1].measured.p);
  }
  CHECK(apart_m(edited, document, 0.995, 0) == 0.0);
  CHECK(apart_m(edited, document, 1.0, 0) == doctest::Approx(0.02).epsilon(1e-4));
  CHECK(apart_m(edited, document, 1.8, 0) == doctest::Approx(0.02).epsilon(1e-4));
  // Half of the way back is half of the lead, and after it there is none.
  CHECK(apart_m(edited, document, 2.05, 0) == doctest::Approx(0.01).epsilon(1e-3));
  CHECK(apart_m(edited, document, 2.3, 0) < 1e-7);
  CHECK(apart_m(edited, document, 2.305, 0) == 0.0);
  CHECK(check_samples(edited.samples.to_vector()).has_value());
}

TEST_CASE("an overdub without a way back jumps, and what lies beyond the end is left out") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration jumps = apply(document, overdub_of(higher(), 1.0, 1.8, 1.0, Arms::kBoth, 0.0), 3).value();
  CHECK(apart_m(jumps, document, 1.805, 0) == 0.0);
  CHECK(apart_m(jumps, document, 1.8, 1) == doctest::Approx(0.02).epsilon(1e-4));
  const Demonstration late = apply(document, overdub_of(higher(), 1.0, 3.0, 4.5, Arms::kLeft, 0.5), 3).value();
  CHECK(late.full_duration_s() == document.full_duration_s());
  CHECK(late.samples.size() == document.samples.size());
  CHECK(apply(document, overdub_of(higher(), 1.0, 3.0, 9.0, Arms::kLeft, 0.5), 3).error().text() ==
        "there is nothing at 9.000 s that could be replaced");
  Overdub empty;
  CHECK(apply(document, empty, 3).error().text() == "there is no clip to put in");
}

TEST_CASE("an overdub fills what was lifted, the other arm going straight over it") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration lifted = apply(document, DeleteSpan{1.2, 1.6, false}, 2).value();
  CHECK(sample_gaps(lifted.samples).size() == 1);
  const Demonstration edited = apply(lifted, overdub_of(higher(), 1.0, 1.8, 1.0, Arms::kLeft, 0.5), 3).value();
  CHECK(sample_gaps(edited.samples).empty());
  CHECK(edited.samples.size() == document.samples.size());
  CHECK(apart_m(edited, document, 1.4, 0) == doctest::Approx(0.02).epsilon(1e-4));
}

TEST_CASE("how a transfer ended is no longer said once its motion is another, and is again when that is undone") {
  Recording recording = testing::moving_recording(1000);
  recording.outcome = Outcome::kSuccess;
  recording.placed = true;
  const auto document =
      make_demonstration({1}, "Done", std::make_shared<const Recording>(std::move(recording))).value();
  CHECK(document.outcome() == Outcome::kSuccess);
  const Demonstration trimmed = apply(document, Trim{1.0, 4.5}, 2).value();
  CHECK(trimmed.outcome() == Outcome::kSuccess);
  CHECK(trimmed.placed());
  const Demonstration edited = apply(document, overdub_of(higher(), 1.0, 1.8, 1.0, Arms::kLeft, 0.5), 3).value();
  CHECK(edited.outcome() == Outcome::kUnknown);
  CHECK_FALSE(edited.placed());
  CHECK(with_stack(edited, {}).outcome() == Outcome::kSuccess);
}

TEST_CASE("gates that leave out how a transfer ended make that unknown, and others do not") {
  Recording recording = testing::moving_recording(1000);
  recording.outcome = Outcome::kSuccess;
  recording.placed = true;
  recording.provenance.block = 2;
  // Handed over at 4 s, let go of at 4.4 s, at rest from 4.6 s on.
  for (Sample& sample : recording.samples) {
    if (sample.tick < 4400) sample.flags |= kRightHolds;
    sample.blocks[2].p[2] = sample.tick < 4600 ? 0.02F : 0.0F;
  }
  const auto document =
      make_demonstration({1}, "Done", std::make_shared<const Recording>(std::move(recording))).value();
  const auto trimmed = [&](double from_s, double to_s) { return apply(document, Trim{from_s, to_s}, 2).value(); };
  CHECK(document.outcome_doubt().empty());
  CHECK(trimmed(1.0, 4.7).outcome() == Outcome::kSuccess);
  CHECK(trimmed(1.0, 4.7).placed());
  for (const Demonstration& cut : {trimmed(0.0, 4.65), trimmed(0.0, 3.0), trimmed(4.8, 4.99)}) {
    CHECK(cut.outcome() == Outcome::kUnknown);
    CHECK_FALSE(cut.placed());
    CHECK(cut.outcome_doubt() == "the gates leave out how it ended");
  }
  CHECK(apply(trimmed(0.0, 3.0), Trim{0.0, 4.99}, 3).value().outcome() == Outcome::kSuccess);
}

TEST_CASE("gates that leave out how a block was dropped make that unknown") {
  Recording recording = testing::moving_recording(1000);
  recording.outcome = Outcome::kDropped;
  for (Sample& sample : recording.samples) {
    if (sample.tick < 3000) sample.flags |= kLeftHolds;
  }
  const auto document =
      make_demonstration({1}, "Lost", std::make_shared<const Recording>(std::move(recording))).value();
  CHECK(apply(document, Trim{0.0, 3.2}, 2).value().outcome() == Outcome::kDropped);
  CHECK(apply(document, Trim{0.0, 2.9}, 2).value().outcome() == Outcome::kUnknown);
}
