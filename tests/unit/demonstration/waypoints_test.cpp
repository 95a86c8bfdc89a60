#include "engine/demonstration/waypoints.h"

#include <doctest/doctest.h>

#include "engine/demonstration/edits.h"
#include "tests/support/document_samples.h"

namespace trocar::demonstration {
namespace {

Demonstration edited(const Demonstration& document, const Edit& edit, std::int64_t id) {
  return apply(document, edit, id).value();
}

MoveTool move_at(double at_s) {
  return {Arms::kLeft, at_s, {0.001, 0.0, 0.0}, 0.3, Falloff::kSmooth};
}

}  // namespace

TEST_CASE("where a tool was moved or turned there is a waypoint, and waypoints are by time") {
  Demonstration document = testing::moving_demonstration(800);
  CHECK(waypoints_of(document).empty());
  document = edited(document, move_at(3.0), 7);
  document = edited(document, RotateTool{Arms::kRight, 1.0, {0.1, 0.0, 0.0}, TurnFrame::kTool, 0.2}, 8);
  const auto list = waypoints_of(document);
  REQUIRE(list.size() == 2);
  CHECK(list[0].entry == 8);
  CHECK(list[0].arms == Arms::kRight);
  CHECK(list[1].entry == 7);
  CHECK(list[1].at_s == 3.0);
}

TEST_CASE("a waypoint is found again at its instant, for its arms and its kind only") {
  const Demonstration document = edited(testing::moving_demonstration(800), move_at(3.0), 7);
  REQUIRE(waypoint_at(document, move_at(3.001)));
  CHECK(waypoint_at(document, move_at(3.001))->entry == 7);
  CHECK_FALSE(waypoint_at(document, move_at(3.01)));
  CHECK_FALSE(waypoint_at(document, RotateTool{Arms::kLeft, 3.0}));
  MoveTool other = move_at(3.0);
  other.arms = Arms::kBoth;
  CHECK_FALSE(waypoint_at(document, other));
}

TEST_CASE("a waypoint whose instant has moved since, or whose edit is switched off, is none") {
  Demonstration document = edited(testing::moving_demonstration(800), move_at(3.0), 7);
  const Demonstration cut = edited(document, DeleteSpan{0.5, 1.0, true}, 8);
  CHECK(waypoints_of(cut).empty());
  // Set after the cut it is where it says.
  CHECK(waypoints_of(edited(cut, move_at(2.0), 9)).size() == 1);
  CHECK(waypoints_of(edited(document, Mirror{}, 8)).empty());
  CHECK(waypoints_of(edited(document, DeleteSpan{0.5, 1.0, false}, 8)).size() == 1);
  CHECK(waypoints_of(edited(document, Trim{0.0, 2.0}, 8)).empty());
  document = with_stack(document, entry_enabled(*document.stack, 7, false).value());
  CHECK(waypoints_of(document).empty());
}

}  // namespace trocar::demonstration
