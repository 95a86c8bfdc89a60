#include "engine/spatial/grid.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <limits>

using namespace trocar::spatial;

TEST_CASE("the lattice has the paper's 10,648 states of 2.5 mm") {  // Table I
  const Grid grid;
  CHECK(grid.cell_count() == 10648);
  CHECK(grid.cell_m == 0.0025);
}

TEST_CASE("the low face belongs to the cube and the high face does not") {
  Grid grid;
  grid.p_WGo.setZero();
  CHECK(grid.cell_at({0.0, 0.0, 0.0}).value() == CellIndex{0});
  CHECK_FALSE(grid.cell_at({0.0, 0.0, grid.n * grid.cell_m}).has_value());
}

TEST_CASE("a point that is not finite is an invalid argument, one outside is out of reach") {
  const Grid grid;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(grid.cell_at({nan, 0.0, 0.0}).error().code() == trocar::ErrorCode::kInvalidArgument);
  CHECK(grid.cell_at({1.0, 0.0, 0.0}).error().code() == trocar::ErrorCode::kOutOfReach);
}

TEST_CASE("a cell's centre lies in that cell, and its coordinates give its index") {
  CHECK(rc::check([] {
    const Grid grid = Grid::with_cells(*rc::gen::inRange(1, 60));
    const CellIndex cell{*rc::gen::inRange(0, grid.cell_count())};
    RC_ASSERT(grid.cell_at(grid.centre(cell)).value() == cell);
    RC_ASSERT(grid.index(grid.coordinates(cell)) == cell);
  }));
}

TEST_CASE("a step and its opposite lead back, and the lattice ends at its faces") {
  CHECK(rc::check([] {
    const Grid grid;
    const CellIndex cell{*rc::gen::inRange(0, grid.cell_count())};
    const int a = *rc::gen::inRange(0, kActionCount);
    const auto next = grid.neighbour(cell, static_cast<Action>(a));
    if (next) RC_ASSERT(grid.neighbour(*next, static_cast<Action>(a ^ 1)) == cell);
  }));
  const Grid grid;
  CHECK_FALSE(grid.neighbour(CellIndex{0}, Action::kMinusX));
  CHECK_FALSE(grid.neighbour(CellIndex{grid.cell_count() - 1}, Action::kPlusZ));
}

TEST_CASE("the cells within radius 1 of a corner are 8, of an inner cell 27") {
  const Grid grid;
  CHECK(cells_within(grid, {CellIndex{0}}, 1).count() == 8);
  CHECK(cells_within(grid, {grid.index({5, 5, 5})}, 1).count() == 27);
}
