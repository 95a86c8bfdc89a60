#include "engine/review/resimulation.h"

#include <doctest/doctest.h>

#include "engine/demonstration/edits.h"
#include "tests/support/document_samples.h"
#include "tests/support/recorded_transfer.h"

using namespace trocar;
using namespace trocar::review;
using namespace trocar::demonstration;
using trocar::testing::transfer;

namespace {

Resimulation simulated(const Demonstration& document) {
  Progress progress;
  return resimulate(document, progress).value();
}

}  // namespace

TEST_CASE("a transfer as it was recorded is a transfer in the simulator too, also when its idle begin is trimmed") {
  const Demonstration document = transfer(1);
  const Resimulation found = simulated(document);
  CHECK(found.transferred());
  CHECK(found.refused == 0);
  CHECK(found.from_goal_m < 0.005);
  const Demonstration trimmed = apply(document, Trim{1.0, document.end_s}).value();
  CHECK(simulated(trimmed).transferred());
}

TEST_CASE("a transfer is one of another block to another peg too, once it is retargeted") {
  const Demonstration document = transfer(1);
  for (const int number : {2, 4}) {
    CAPTURE(number);
    CHECK(simulated(apply(document, Retarget{number, number}).value()).transferred());
  }
}

TEST_CASE("jaws that open on the way drop the block there and then") {
  const Demonstration document = transfer(1);
  const auto carried = document.segment(Segment::kC).value();
  SetJaw open;
  open.from_s = 0.5 * (carried.begin_s + carried.end_s);
  open.to_s = open.from_s + 0.6;
  open.jaw_rad = 1.0;
  open.ramp_s = 0.1;
  const Resimulation found = simulated(apply(document, open).value());
  CHECK(found.outcome == Outcome::kDropped);
  CHECK_FALSE(found.transferred());
  CHECK(found.last_arm == 0);
  CHECK(found.last_touch_s > open.from_s);
  CHECK(found.last_touch_s < open.from_s + 0.4);
  CHECK(found.last_p_WK.z() > 0.02);
  CHECK(found.sentence.find("is dropped: the left arm loses it at") != std::string::npos);
}

TEST_CASE("a tool that never comes down never lifts the block") {
  const Demonstration document = transfer(1);
  Offset up;
  up.arms = Arms::kLeft;
  up.by_m = {0.0, 0.0, 0.030};
  const Resimulation found = simulated(apply(document, up).value());
  CHECK(found.outcome == Outcome::kUnfinished);
  CHECK_FALSE(found.lifted);
  CHECK(found.sentence.find("is never touched") != std::string::npos);
}

TEST_CASE("what has no initial world cannot be simulated, and that is said") {
  Recording recording = testing::recording_of(transfer(1));
  recording.initial_world.clear();
  const auto document = make_demonstration({1}, "Import", std::make_shared<const Recording>(recording)).value();
  Progress progress;
  const auto found = resimulate(document, progress);
  REQUIRE_FALSE(found.has_value());
  CHECK(found.error().code() == ErrorCode::kInvalidArgument);
  CHECK(found.error().text().find("cannot be simulated") != std::string::npos);
}
