#include "engine/learning/start_set.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>

#include "engine/core/random.h"
#include "engine/learning/rollout.h"
#include "engine/learning/training_input.h"
#include "tests/support/lattice_demonstrations.h"

using namespace trocar;
using namespace trocar::learning;

namespace {

const Model& starting_model() {
  static const Model made = untrained_model(spatial::Grid{}, {testing::sample_demonstrations()[0]}, TrainOptions{});
  return made;
}

std::vector<spatial::CellIndex> started(std::string_view text) {
  return starts_from(text, starting_model()).value();
}

}  // namespace

TEST_CASE("each form gives the cells that it names") {
  CHECK(started("all").size() == 10648);
  CHECK(started("around:3") == starts_around(starting_model(), 3));
  CHECK(started("around:0") == std::vector{starting_model().start});
  CHECK(started("box:3-7,0-21,10").size() == 5 * 22);
  CHECK(started("box:3,4,5") == std::vector{starting_model().grid.index({3, 4, 5})});
  CHECK(started("face:z1").size() == 22 * 22);
  for (const spatial::CellIndex cell : started("face:z1")) CHECK(starting_model().grid.coordinates(cell).z == 21);
  CHECK(started("face:x0").front().value == 0);
  CHECK(started("sphere:11,12,19,1").size() == 7);
  CHECK(started("sphere:11,12,19,0").size() == 1);
  CHECK(started("cells:7,3-5,4") == std::vector<spatial::CellIndex>{{3}, {4}, {5}, {7}});
}

TEST_CASE("normal draws are as many and as wide as asked for, and the same for a seed") {
  const auto drawn = started("gaussian:5,2000,7");
  REQUIRE(drawn.size() == 2000);
  CHECK(drawn == started("gaussian:5,2000,7"));
  CHECK(drawn != started("gaussian:5,2000,8"));
  double sum = 0.0;
  const Eigen::Vector3d middle = starting_model().grid.centre(starting_model().start);
  for (const spatial::CellIndex cell : drawn) {
    const double y = starting_model().grid.centre(cell).y() - middle.y();
    sum += y * y;
  }
  CHECK(std::sqrt(sum / 2000.0) == doctest::Approx(0.005).epsilon(0.1));
}

TEST_CASE("a Latin hypercube draws once from each part of every axis, in the lattice or near the start") {
  const auto drawn = started("latin:22,5");
  REQUIRE(drawn.size() == 22);
  CHECK(drawn == started("latin:22,5"));
  CHECK(drawn != started("latin:22,6"));
  std::array<std::set<int>, 3> seen;
  for (const spatial::CellIndex cell : drawn) {
    const spatial::CellCoordinates c = starting_model().grid.coordinates(cell);
    seen[0].insert(c.x);
    seen[1].insert(c.y);
    seen[2].insert(c.z);
  }
  // As many parts as cells: every row of every axis, and not along a diagonal.
  for (const auto& axis : seen) CHECK(axis.size() == 22);
  const auto near = started("latin:500,1,2");
  const auto around = starts_around(starting_model(), 2);
  for (const spatial::CellIndex cell : near) REQUIRE(std::find(around.begin(), around.end(), cell) != around.end());
  std::set<std::int32_t> cells;
  for (const spatial::CellIndex cell : near) cells.insert(cell.value);
  CHECK(cells.size() > 60);
}

TEST_CASE("a painted region is written in runs and read back") {
  CHECK(start_text({{9}, {3}, {4}, {5}, {4}}) == "cells:3-5,9");
  CHECK(rc::check([](std::uint64_t seed) {
    Random random(seed);
    std::vector<spatial::CellIndex> cells;
    for (std::int32_t cell = 0; cell < 10648; ++cell) {
      if (random.below(7) == 0) cells.push_back({cell});
    }
    RC_ASSERT(starts_from(start_text(cells), starting_model()).value() == cells);
  }));
}

TEST_CASE("what names no starts is refused in one sentence") {
  for (const char* text : {"",
                           "some",
                           "around:",
                           "around:22",
                           "around:-1",
                           "around:x",
                           "box:1,2",
                           "box:5-3,0,0",
                           "box:0,0,22",
                           "face:w0",
                           "face:x2",
                           "face:",
                           "sphere:1,2,3",
                           "sphere:1,2,3,-1",
                           "sphere:nan,0,0,1",
                           "sphere:500,0,0,1",
                           "gaussian:5,10",
                           "gaussian:0,10,1",
                           "gaussian:5,0,1",
                           "gaussian:nan,10,1",
                           "gaussian:5,2000000,1",
                           "latin:10",
                           "latin:0,1",
                           "latin:10,1,23",
                           "latin:10,x",
                           "latin:2000000,1",
                           "cells:",
                           "cells:1-",
                           "cells:10648",
                           "cells:a"}) {
    CAPTURE(text);
    const auto read = starts_from(text, starting_model());
    REQUIRE_FALSE(read);
    CHECK(read.error().code() == ErrorCode::kInvalidArgument);
    CHECK_FALSE(read.error().text().empty());
  }
}
