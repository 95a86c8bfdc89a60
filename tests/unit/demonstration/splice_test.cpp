#include <doctest/doctest.h>

#include "engine/demonstration/clip.h"
#include "engine/demonstration/edits.h"
#include "engine/demonstration/motion.h"
#include "engine/peg_board/peg_board.h"
#include "tests/support/document_samples.h"

using namespace trocar;
using namespace trocar::demonstration;

namespace {

Splice splice_of(const Demonstration& source, double from_s, double to_s, double at_s, Align align) {
  Splice splice{source.id.value, from_s, to_s, at_s, 0.0, align, 0, nullptr};
  splice.clip = std::make_shared<const Clip>(clip_of(source, from_s, to_s).value());
  return splice;
}

Demonstration spliced(const Demonstration& document, const Splice& splice) {
  Result<Demonstration> result = apply(document, splice, 3);
  REQUIRE_MESSAGE(result.has_value(), (result ? "" : result.error().text()));
  return std::move(*result);
}

std::string refusal(const Demonstration& document, const Splice& splice) {
  const Result<Demonstration> result = apply(document, splice, 3);
  REQUIRE_FALSE(result.has_value());
  return result.error().text();
}

}  // namespace

TEST_CASE("a clip put in is there sample by sample, and what follows comes later") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration edited = spliced(document, splice_of(document, 1.0, 1.495, 3.0, Align::kAsRecorded));
  CHECK(edited.samples.size() == 1100);
  CHECK(edited.full_duration_s() == doctest::Approx(document.full_duration_s() + 0.5));
  for (std::size_t i = 0; i < 100; ++i) {
    CHECK(measured_tip(edited.samples[600 + i], 0) == measured_tip(document.samples[200 + i], 0));
  }
  CHECK(edited.samples.tick(600) == document.samples.tick(600));
  CHECK(measured_tip(edited.samples[700], 1) == measured_tip(document.samples[600], 1));
  CHECK(edited.end_s == doctest::Approx(document.end_s + 0.5));
  CHECK(check_samples(edited.samples.to_vector()).has_value());
}

TEST_CASE("a clip that meets goes on from where each tool is") {
  const Demonstration document = testing::moving_demonstration(1000);
  const Demonstration edited = spliced(document, splice_of(document, 0.5, 0.9, 3.0, Align::kMeet));
  for (std::size_t arm = 0; arm < 2; ++arm) {
    CHECK((measured_tip(edited.samples[600], arm) - measured_tip(document.samples[599], arm)).norm() < 1e-6);
    const Eigen::Vector3d way = measured_tip(edited.samples[640], arm) - measured_tip(edited.samples[600], arm);
    const Eigen::Vector3d recorded =
        measured_tip(document.samples[140], arm) - measured_tip(document.samples[100], arm);
    CHECK((way - recorded).norm() < 1e-6);
  }
}

TEST_CASE("a clip for another peg is moved from the one to the other") {
  Demonstration document = testing::moving_demonstration(1000);
  Demonstration source = document;
  document.block = 2;
  source.block = 5;
  const Demonstration edited = spliced(document, splice_of(source, 1.0, 1.2, 3.0, Align::kPeg));
  const Eigen::Vector3d by = peg_board::start_peg(2) - peg_board::start_peg(5);
  CHECK((measured_tip(edited.samples[600], 0) - measured_tip(source.samples[200], 0) - by).norm() < 1e-6);
  source.block = kUnknownPlace;
  CHECK(refusal(document, splice_of(source, 1.0, 1.2, 3.0, Align::kPeg)) ==
        "it is not known which block was carried, so no peg can be met");
}

TEST_CASE("a clip takes the place of a span, and brings its labels") {
  const Demonstration document = testing::moving_demonstration(1000);
  Splice splice = splice_of(document, 0.0, 0.5, 3.0, Align::kAsRecorded);
  splice.until_s = 4.0;
  const Demonstration edited = spliced(document, splice);
  CHECK(edited.samples.size() == 1000 - 200 + 101);
  CHECK(measured_tip(edited.samples[701], 0) == measured_tip(document.samples[800], 0));
  const auto label_at = [](const Demonstration& of, double t_s) {
    for (const SegmentSpan& span : of.segments) {
      if (t_s >= span.begin_s && t_s < span.end_s) return letter(span.label);
    }
    return '-';
  };
  CHECK(label_at(edited, 3.2) == label_at(document, 0.2));
  CHECK(label_at(edited, 3.2) != label_at(document, 3.2));
}

TEST_CASE("a clip put at the very begin and at the very end stays between the gates") {
  const Demonstration document = testing::moving_demonstration(400);
  const Demonstration first = spliced(document, splice_of(document, 1.0, 1.495, 0.0, Align::kMeet));
  CHECK(first.samples.tick(0) == document.samples.tick(0));
  CHECK(first.gated().size() == 500);
  const Demonstration last = spliced(document, splice_of(document, 0.0, 0.495, 2.0, Align::kAsRecorded));
  CHECK(last.gated().size() == 500);
  CHECK(measured_tip(last.gated().back(), 0) == measured_tip(document.samples[99], 0));
}

TEST_CASE("a splice that cannot be made says why") {
  const Demonstration document = testing::moving_demonstration(400);
  CHECK(refusal(document, Splice{}) == "there is no clip to put in");
  Splice splice = splice_of(document, 0.5, 1.0, 1.5, Align::kMeet);
  splice.until_s = 1.0;
  CHECK(refusal(document, splice) == "what the clip replaces must end after it begins");
  splice.until_s = 0.0;
  splice.at_s = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal(document, splice) == "the times must be finite");
  CHECK_FALSE(clip_of(document, 50.0, 60.0).has_value());
  CHECK_FALSE(clip_of(document, 1.0, 0.5).has_value());
}
