#include "engine/peg_board/obstacles.h"

#include <doctest/doctest.h>

#include "engine/peg_board/peg_board.h"

using namespace trocar;
using namespace trocar::peg_board;

TEST_CASE("the clearance of a point is its distance from the nearest peg or the board") {
  const Eigen::Vector3d foot = start_peg(0);
  CHECK(clearance_m(foot + Eigen::Vector3d(kPegRadius_m + 0.001, 0.0, 0.010)) == doctest::Approx(0.001));
  CHECK(clearance_m(foot + Eigen::Vector3d(0.0, 0.0, kPegHeight_m + 0.003)) == doctest::Approx(0.003));
  CHECK(clearance_m(foot + Eigen::Vector3d(0.0, 0.0, 0.010)) == doctest::Approx(-kPegRadius_m));
  CHECK(clearance_m(foot + Eigen::Vector3d(kPegRadius_m + 0.003, 0.0, kPegHeight_m + 0.004)) == doctest::Approx(0.005));
  CHECK(clearance_m(foot + Eigen::Vector3d(0.004, 0.0, 0.001)) == doctest::Approx(0.001));
}

TEST_CASE("each cell has the clearance of its middle") {
  const spatial::Grid grid;
  const auto all = clearances_m(grid);
  REQUIRE(all.size() == static_cast<std::size_t>(grid.cell_count()));
  CHECK(all[1234] == clearance_m(grid.centre({1234})));
}
