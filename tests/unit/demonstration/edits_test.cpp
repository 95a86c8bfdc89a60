#include "engine/demonstration/edits.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <limits>

#include "tests/support/document_samples.h"

using namespace trocar;
using namespace trocar::demonstration;
using testing::moving_demonstration;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string error_of(const Demonstration& document, const Edit& edit) {
  const Result<Demonstration> result = apply(document, edit);
  return result ? "" : result.error().text();
}

}  // namespace

TEST_CASE("a trim moves the gates, keeps every sample and leaves the document alone") {
  const Demonstration document = moving_demonstration(1000);
  const Demonstration trimmed = apply(document, Trim{1.0, 2.0}).value();
  CHECK(trimmed.gated().size() == 201);
  CHECK(trimmed.samples.same_pieces(document.samples));
  CHECK(document.gated().size() == 1000);
}

TEST_CASE("a trim beyond the recording ends at its ends") {
  const Demonstration trimmed = apply(moving_demonstration(1000), Trim{-5.0, 99.0}).value();
  CHECK(trimmed.begin_s == 0.0);
  CHECK(trimmed.gated().size() == 1000);
}

TEST_CASE("a trim that leaves nothing, goes backwards or is not a number says so") {
  const Demonstration document = moving_demonstration(1000);
  CHECK(error_of(document, Trim{1.0, 1.001}) == "the trim to 1–1.001 s leaves fewer than 2 samples");
  CHECK(error_of(document, Trim{2.0, 1.0}) == "the end (1 s) must be after the begin (2 s)");
  CHECK(error_of(document, Trim{kNan, 1.0}) == "the begin and the end must be finite numbers");
  CHECK(error_of(document, Trim{50.0, 60.0}) != "");
}

TEST_CASE("a name must be text that can be shown") {
  const Demonstration document = moving_demonstration(10);
  CHECK(apply(document, Rename{"Grasp über peg 3"})->name == "Grasp über peg 3");
  CHECK(error_of(document, Rename{""}) == "a name must not be empty");
  CHECK(error_of(document, Rename{"   "}) == "a name must not be empty");
  CHECK(error_of(document, Rename{"a\nb"}) == "a name must not have control characters");
  CHECK(error_of(document, Rename{"\xC3("}) == "a name must be UTF-8 text");
  CHECK(error_of(document, Rename{"\xED\xA0\x80"}) == "a name must be UTF-8 text");
  CHECK(error_of(document, Rename{std::string(201, 'x')}) == "a name must not be longer than 200 bytes");
}

TEST_CASE("a label inside a span splits it in two") {
  Demonstration document = moving_demonstration(1000);
  document.segments = {{Segment::kA, 0.0, 4.0}};
  const Demonstration labelled = apply(document, LabelSegment{Segment::kC, 1.0, 2.0}).value();
  const std::vector<SegmentSpan> expected{{Segment::kA, 0.0, 1.0}, {Segment::kC, 1.0, 2.0}, {Segment::kA, 2.0, 4.0}};
  CHECK(labelled.segments == expected);
}

TEST_CASE("a label that covers a span replaces it, and touching spans of one label become one") {
  const Demonstration document = moving_demonstration(1000);
  const Demonstration labelled = apply(document, LabelSegment{Segment::kA, 0.5, 2.5}).value();
  CHECK(labelled.segments[0] == SegmentSpan{Segment::kA, 0.0, 2.5});
  CHECK(labelled.segments[1] == SegmentSpan{Segment::kC, 2.5, 3.0});
}

TEST_CASE("labels never overlap and stay within the recording, whatever is labelled in whatever order") {
  const Demonstration original = moving_demonstration(200);
  CHECK(rc::check([&] {
    Demonstration document = original;
    const int count = *rc::gen::inRange(1, 12);
    for (int i = 0; i < count; ++i) {
      const double from_s = 0.001 * *rc::gen::inRange(-100, 1100);
      const double length_s = 0.001 * *rc::gen::inRange(1, 500);
      const auto label = static_cast<Segment>(*rc::gen::inRange(0, kSegmentCount));
      if (auto edited = apply(document, LabelSegment{label, from_s, from_s + length_s})) document = *edited;
    }
    double end_s = 0.0;
    for (const SegmentSpan& span : document.segments) {
      RC_ASSERT(span.begin_s >= end_s);
      RC_ASSERT(span.begin_s < span.end_s);
      end_s = span.end_s;
    }
    RC_ASSERT(end_s <= document.full_duration_s());
  }));
}

TEST_CASE("an edit that is written as JSON reads back as the same edit") {
  CHECK(rc::check([] {
    const double from_s = *rc::gen::arbitrary<double>();
    const double to_s = *rc::gen::arbitrary<double>();
    const std::string name = *rc::gen::container<std::string>(rc::gen::inRange('\x20', '\x7E'));
    const std::vector<Edit> edits{Trim{from_s, to_s}, Rename{name}, LabelSegment{Segment::kD, from_s, to_s}};
    for (const Edit& edit : edits) {
      const Result<Edit> read = edit_from_json(name_of(edit), to_json(edit));
      RC_ASSERT(read.has_value());
      RC_ASSERT(to_json(*read) == to_json(edit));
    }
  }));
}

TEST_CASE("an unknown edit, a missing key, a foreign key and a wrong type are refused") {
  const auto text = [](std::string_view name, std::string_view json) {
    const Result<Edit> read = edit_from_json(name, json);
    REQUIRE_FALSE(read);
    CHECK(read.error().code() == ErrorCode::kCorrupt);
    return read.error().text();
  };
  CHECK(text("melt", "{}") == "no edit is named melt");
  CHECK(text("trim", R"({"from_s":1})") == "the parameter to_s must be there and be a number");
  CHECK(text("trim", R"({"from_s":1,"to_s":2,"by":3})") == "the edit has a parameter that is not known");
  CHECK(text("trim", R"({"from_s":"1","to_s":2})") == "the parameter from_s must be there and be a number");
  CHECK(text("label", R"({"label":"F","from_s":1,"to_s":2})") ==
        "the parameter label must be there and be one of A, B, C, D, E");
  CHECK(text("trim", "[1,2") == "the parameters of an edit must be a JSON object");
}
