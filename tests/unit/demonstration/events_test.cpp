#include "engine/demonstration/events.h"

#include <doctest/doctest.h>

#include "engine/demonstration/clip.h"
#include "engine/demonstration/edit_spans.h"
#include "engine/demonstration/edits.h"
#include "engine/demonstration/join.h"
#include "tests/support/document_samples.h"

using namespace trocar;
using namespace trocar::demonstration;

namespace {

/// Four seconds without labels: the left gripper closes at 1 s, holds from 1.5 s until 3 s, and opens there.
Demonstration gripping() {
  Recording recording = testing::moving_recording(801);
  for (Sample& sample : recording.samples) {
    const double t_s = sample.t_s();
    sample.arms[0].setpoint_jaw_rad = t_s < 0.9 ? 0.6 : t_s < 1.0 ? 0.2 : t_s < 3.0 ? 0.0 : 0.6;
    sample.arms[1].setpoint_jaw_rad = 0.2;
    if (t_s >= 1.5 && t_s < 3.0) sample.flags |= kLeftHolds;
  }
  Demonstration made =
      make_demonstration({1}, "Gripping", std::make_shared<const Recording>(std::move(recording))).value();
  made.segments.clear();
  return made;
}

}  // namespace

TEST_CASE("a gripper's events are where it opens, closes, takes hold and lets go") {
  const std::vector<Event> found = events_within(gripping(), 0.0, 4.0);
  REQUIRE(found.size() == 4);
  CHECK(found[0] == Event{1.0, EventKind::kJawCloses, 0});
  CHECK(found[1] == Event{1.5, EventKind::kGrasp, 0});
  CHECK(found[2].t_s == 3.0);
  CHECK(found[3].t_s == 3.0);
  CHECK(found[2].kind != found[3].kind);
}

TEST_CASE("a gripper that begins to close before the span closes within it") {
  const std::vector<Event> found = events_within(gripping(), 0.95, 1.2);
  REQUIRE(found.size() == 1);
  CHECK(found[0] == Event{1.0, EventKind::kJawCloses, 0});
}

TEST_CASE("the next event is not the one at the playhead, and after the last comes the gate") {
  Demonstration document = gripping();
  CHECK(next_event(document, 0.0, 1) == 1.0);
  CHECK(next_event(document, 1.0, 1) == 1.5);
  CHECK(next_event(document, 1.5, -1) == 1.0);
  CHECK(next_event(document, 3.0, 1) == document.end_s);
  CHECK(next_event(document, 0.5, -1) == document.begin_s);
  document.notes.push_back({1, 2.0, 2.2, "look", "", 0});
  CHECK(next_event(document, 1.5, 1) == 2.0);
  CHECK(next_event(document, 2.0, 1) == 2.2);
  CHECK(next_event(document, 3.0, -1) == 2.2);
}

TEST_CASE("events are found far off, and none beyond the gate") {
  Recording recording = testing::moving_recording(8000);
  for (Sample& sample : recording.samples) sample.arms[0].setpoint_jaw_rad = sample.t_s() < 39.0 ? 0.6 : 0.0;
  Demonstration document =
      make_demonstration({1}, "Long", std::make_shared<const Recording>(std::move(recording))).value();
  document.segments.clear();
  CHECK(next_event(document, 0.0, 1) == doctest::Approx(39.0));
  document.end_s = 30.0;
  CHECK(next_event(document, 0.0, 1) == 30.0);
}

TEST_CASE("what is taken out leaves a join as far as the tools were apart") {
  const Demonstration document = testing::moving_demonstration(800);
  const DeleteSpan ripple{1.0, 2.0, true};
  const auto joins = joins_of(ripple, document, apply(document, ripple).value());
  REQUIRE(joins.size() == 1);
  CHECK(joins[0].at_s == doctest::Approx(1.0));
  CHECK(joins[0].gap_s == 0.0);
  double moved_m = 0.0;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const auto tip = [&](std::size_t i) { return document.samples[i].arms[arm].measured.pose().p; };
    moved_m = std::max(moved_m, (tip(400) - tip(199)).norm());
  }
  CHECK(joins[0].moved_m == doctest::Approx(moved_m));
  const DeleteSpan lift{1.0, 2.0, false};
  const auto gap = joins_of(lift, document, apply(document, lift).value());
  REQUIRE(gap.size() == 1);
  CHECK(gap[0].gap_s == doctest::Approx(1.0));
  CHECK(sentence_of(gap).find("over a gap of 1.00 s") != std::string::npos);
  CHECK(joins_of(Trim{0.5, 1.0}, document, document).empty());
}

TEST_CASE("an edit's span is where its samples are now, later edits before it allowed for") {
  Demonstration document = testing::moving_demonstration(1001);
  const auto edit = [&](const Edit& one, std::int64_t id) { document = apply(document, one, id).value(); };
  edit(Smooth{3.0, 4.0}, 1);
  edit(MoveTool{Arms::kLeft, 4.5, {0.001, 0.0, 0.0}, 0.25}, 2);
  edit(DeleteSpan{1.0, 2.0, true}, 3);
  Splice splice{1, 0.0, 0.495, 0.5, 0.0, Align::kAsRecorded, 0, nullptr};
  splice.clip = std::make_shared<const Clip>(clip_of(document, 0.0, 0.495).value());
  edit(splice, 4);
  edit(Trim{0.5, 4.0}, 5);
  const std::vector<EditSpan> spans = edit_spans(document);
  REQUIRE(spans.size() == 4);
  CHECK(spans[0].entry == 1);
  CHECK(spans[0].begin_s == doctest::Approx(2.5));
  CHECK(spans[0].end_s == doctest::Approx(3.5));
  CHECK(spans[1].begin_s == doctest::Approx(3.75));
  CHECK(spans[1].end_s == doctest::Approx(4.25));
  CHECK(spans[2].begin_s == doctest::Approx(1.5));
  CHECK(spans[2].end_s == doctest::Approx(1.5));
  CHECK(spans[3].begin_s == doctest::Approx(0.5));
  CHECK(spans[3].end_s == doctest::Approx(1.0));
}
