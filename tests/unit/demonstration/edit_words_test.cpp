#include "engine/demonstration/edit_words.h"

#include <doctest/doctest.h>
#include <fmt/ranges.h>
#include <rapidcheck.h>

#include "tests/support/random_edits.h"

using namespace trocar;
using namespace trocar::demonstration;

namespace {

std::string error_of(const std::string& line) {
  const Result<Edit> edit = edit_from_words(split_words(line).value());
  REQUIRE_FALSE(edit);
  return edit.error().text();
}

}  // namespace

TEST_CASE("every edit reads back from its words and from its JSON") {
  CHECK(rc::check([](std::uint64_t seed) {
    Random random(seed);
    const Edit edit = testing::random_edit(random, 10.0);
    const Result<Edit> typed = edit_from_words(to_words(edit));
    RC_ASSERT(typed.has_value());
    RC_ASSERT(to_words(*typed) == to_words(edit));
    // To the bit: the JSON has the shortest text of each number.
    const Edit rounded = as_typed(edit);
    const Result<Edit> again = edit_from_words(to_words(rounded), rounded);
    RC_ASSERT(again.has_value());
    RC_ASSERT(to_json(*again) == to_json(rounded));
    RC_ASSERT(to_json(as_typed(rounded)) == to_json(rounded));
    const Result<Edit> stored = edit_from_json(name_of(edit), to_json(edit));
    RC_ASSERT(stored.has_value());
    RC_ASSERT(to_json(*stored) == to_json(edit));
  }));
}

TEST_CASE("lengths are typed in millimetres, angles in degrees, points with commas") {
  const Edit edit = edit_from_words(split_words("move --at 2.5 --by-mm 2.5,0,-1 --arms right").value()).value();
  const auto& move = std::get<MoveTool>(edit);
  CHECK(move.by_m == Eigen::Vector3d(0.0025, 0.0, -0.001));
  CHECK(move.arms == Arms::kRight);
  CHECK(move.at_s == 2.5);
  CHECK(move.radius_s == MoveTool().radius_s);
  const Edit jaw = edit_from_words(split_words("jaw --from 1 --to 2 --jaw-deg 30").value()).value();
  CHECK(std::get<SetJaw>(jaw).jaw_rad == doctest::Approx(0.5235987756));
}

TEST_CASE("a drag of any length gives the edit that its words give, to the bit") {
  CHECK(rc::check([](std::uint64_t seed) {
    Random random(seed);
    MoveTool move;
    move.at_s = random.uniform(0.0, 40.0);
    move.by_m = {random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)};
    const auto made = std::get<MoveTool>(as_typed(move));
    const auto typed = std::get<MoveTool>(edit_from_words(to_words(move)).value());
    RC_ASSERT(made.by_m == typed.by_m);
    RC_ASSERT(made.at_s == typed.at_s);
    RC_ASSERT((made.by_m - move.by_m).norm() < 1e-12);
    RotateTool turn;
    turn.by_rad = {random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)};
    RC_ASSERT(std::get<RotateTool>(as_typed(turn)).by_rad ==
              std::get<RotateTool>(edit_from_words(to_words(turn)).value()).by_rad);
  }));
}

TEST_CASE("quoted words keep their blanks") {
  const Edit edit = edit_from_words(split_words("note 'hesitates here' --from 1 --to 2").value()).value();
  CHECK(std::get<AddNote>(edit).text == "hesitates here");
  CHECK_FALSE(split_words("note 'open"));
}

TEST_CASE("what cannot be read is said in one sentence") {
  CHECK(error_of("melt") == "no edit is named melt");
  CHECK(error_of("trim --form 1") == "trim has no option --form");
  CHECK(error_of("trim --from x") == "trim: --from must be a number, not x");
  CHECK(error_of("trim --from 1 --from 2") == "--from is given twice");
  CHECK(error_of("rename") == "rename: it needs a word: The new name");
  CHECK(error_of("move --by-mm 1,2") == "move: --by-mm must be three numbers separated by commas, not 1,2");
  CHECK(error_of("smooth --arms up") == "smooth: --arms must be one of left, right, both, not up");
  CHECK(error_of("mirror now") == "mirror does not know what to do with now");
}
