#include "engine/demonstration/demonstration.h"

#include <doctest/doctest.h>

#include <limits>

#include "tests/support/document_samples.h"

using namespace trocar;
using namespace trocar::demonstration;
using testing::moving_demonstration;
using testing::moving_recording;

namespace {

Result<Demonstration> made_of(Recording recording) {
  return make_demonstration({1}, "Any", std::make_shared<const Recording>(std::move(recording)));
}

}  // namespace

TEST_CASE("a new demonstration covers its recording and has the recorder's segments") {
  const Demonstration document = moving_demonstration(1000);
  CHECK(document.begin_s == 0.0);
  CHECK(document.end_s == doctest::Approx(4.995).epsilon(1e-12));
  REQUIRE(document.segments.size() == 5);
  CHECK(document.segments[1] == SegmentSpan{Segment::kB, 1.0, 2.0});
  CHECK(document.gated().size() == 1000);
}

TEST_CASE("times count from the first sample wherever the recording's ticks begin") {
  Recording recording = moving_recording(10);
  for (Sample& sample : recording.samples) sample.tick += 123456;
  const Demonstration document = made_of(recording).value();
  CHECK(document.time_of(document.samples.front()) == 0.0);
  CHECK(document.full_duration_s() == doctest::Approx(0.045).epsilon(1e-12));
}

TEST_CASE("the samples between the gates are shared with the recording") {
  const Demonstration document = moving_demonstration(100);
}

TEST_CASE("an empty recording and one of a single sample make no demonstration") {
  CHECK(made_of(moving_recording(0)).error().code() == ErrorCode::kInvalidArgument);
  CHECK(made_of(moving_recording(1)).error().code() == ErrorCode::kInvalidArgument);
  CHECK(made_of(moving_recording(2)).has_value());
}

TEST_CASE("a sample that is not finite is named in the error") {
  Recording recording = moving_recording(10);
  recording.samples[6].arms[1].measured.p[2] = std::numeric_limits<float>::quiet_NaN();
  CHECK(made_of(recording).error().text() == "sample 7 has a number that is not finite");
  recording = moving_recording(10);
  recording.samples[2].blocks[3].q_wxyz[0] = std::numeric_limits<float>::infinity();
  CHECK(made_of(recording).error().text() == "sample 3 has a number that is not finite");
}

TEST_CASE("samples out of order or at the same time are refused") {
  Recording recording = moving_recording(10);
  recording.samples[4].tick = recording.samples[3].tick;
  CHECK(made_of(recording).error().text() == "sample 5 is not later than the one before it");
}

TEST_CASE("samples outside of the workspace make a demonstration all the same") {
  Recording recording = moving_recording(10);
  recording.samples[4].arms[0].setpoint_p = {9.0, 9.0, 9.0};
  CHECK(made_of(recording).has_value());
}

TEST_CASE("the sample at a time is the last one at or before it") {
  const Demonstration document = moving_demonstration(100);
  CHECK(document.sample_at(0.010).tick == 10);
  CHECK(document.sample_at(0.0149).tick == 10);
  CHECK(document.sample_at(-1.0).tick == 0);
  CHECK(document.sample_at(99.0).tick == 495);
}

TEST_CASE("a segment is cut to the gates and gone when they leave none of it") {
  Demonstration document = moving_demonstration(1000);
  document.begin_s = 1.5;
  CHECK_FALSE(document.segment(Segment::kA));
  CHECK(document.segment(Segment::kB) == SegmentSpan{Segment::kB, 1.5, 2.0});
}

TEST_CASE("spans share no sample and leave none out") {
  const Demonstration document = moving_demonstration(1000);
  std::size_t total = 0;
  for (const SegmentSpan& span : document.segments) total += document.samples_in(span).size();
  CHECK(total == 1000);
}

TEST_CASE("the hash changes with a gate, a label and a single bit of a sample, and not with the name") {
  const Demonstration document = moving_demonstration(100);
  Demonstration other = document;
  other.name = "Other";
  CHECK(other.hash() == document.hash());
  other.end_s -= 0.005;
  CHECK(other.hash() != document.hash());
  other = document;
  other.segments[0].label = Segment::kE;
  CHECK(other.hash() != document.hash());
  Recording recording = moving_recording(100);
  recording.samples[50].arms[1].joints[5] = std::nextafter(recording.samples[50].arms[1].joints[5], 1.0F);
  CHECK(made_of(recording)->hash() != document.hash());
}

TEST_CASE("the content hash covers provenance, world and marks") {
  const Recording recording = moving_recording(10);
  Recording other = recording;
  other.provenance.seed = 2;
  CHECK(other.content_hash() != recording.content_hash());
  other = recording;
  other.initial_world += '!';
  CHECK(other.content_hash() != recording.content_hash());
  other = recording;
  other.hashes.back().hash = 2;
  CHECK(other.content_hash() != recording.content_hash());
}
