#include "engine/demonstration/discretise.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "tests/support/document_samples.h"

using namespace trocar;
using namespace trocar::demonstration;
using spatial::Grid;

namespace {

/// Segment A through the given points, one sample each.
Demonstration through(const std::vector<Eigen::Vector3d>& points) {
  Recording recording;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Sample sample;
    sample.tick = static_cast<std::int64_t>(i) * kTicksPerSample;
    sample.arms[0].measured = CompactPose::from(spatial::Pose::translation(points[i]));
    recording.samples.push_back(sample);
  }
  return make_demonstration({1}, "Path", std::make_shared<const Recording>(std::move(recording))).value();
}

Eigen::Vector3d centre(const Grid& grid, int x, int y, int z) {
  return grid.centre(grid.index({x, y, z}));
}

int distance(const Grid& grid, spatial::CellIndex a, spatial::CellIndex b) {
  const auto p = grid.coordinates(a);
  const auto q = grid.coordinates(b);
  return std::abs(p.x - q.x) + std::abs(p.y - q.y) + std::abs(p.z - q.z);
}

}  // namespace

TEST_CASE("a diagonal step becomes single steps along x, then y, then z") {
  const Grid grid;
  const CellPath path = discretise(through({centre(grid, 5, 5, 5), centre(grid, 6, 6, 6)}), Segment::kA, grid).value();
  const std::vector<spatial::CellIndex> expected{grid.index({5, 5, 5}), grid.index({6, 5, 5}), grid.index({6, 6, 5}),
                                                 grid.index({6, 6, 6})};
  CHECK(path.cells == expected);
  CHECK(path.max_error_m < 1e-8);  // Samples are rounded to single precision.
}

TEST_CASE("a long step follows the line between the two centres") {
  const Grid grid;
  const CellPath path = discretise(through({centre(grid, 0, 0, 0), centre(grid, 4, 2, 0)}), Segment::kA, grid).value();
  REQUIRE(path.cells.size() == 7);
  CHECK(path.cells[1] == grid.index({1, 0, 0}));
  CHECK(path.cells[2] == grid.index({1, 1, 0}));
}

TEST_CASE("every path through the lattice is legal: one action a step, never the same cell twice in a row") {
  const Grid grid;
  CHECK(rc::check([&] {
    std::vector<Eigen::Vector3d> points;
    const int count = *rc::gen::inRange(2, 30);
    for (int i = 0; i < count; ++i) {
      points.push_back(centre(grid, *rc::gen::inRange(-2, 24), *rc::gen::inRange(0, 22), *rc::gen::inRange(0, 22)));
    }
    const Result<CellPath> path = discretise(through(points), Segment::kA, grid);
    if (!path) return;
    for (std::size_t i = 1; i < path->cells.size(); ++i) {
      RC_ASSERT(distance(grid, path->cells[i - 1], path->cells[i]) == 1);
    }
  }));
}

TEST_CASE("samples outside of the lattice are counted and left out") {
  const Grid grid;
  const Eigen::Vector3d outside(1.0, 0.0, 0.0);
  const CellPath path =
      discretise(through({centre(grid, 5, 5, 5), outside, centre(grid, 5, 5, 7)}), Segment::kA, grid).value();
  CHECK(path.outside == 1);
  CHECK(path.cells.size() == 3);
}

TEST_CASE("a tool that rests on a corner of cells stays in the cell that it was in, and noise makes no moves") {
  const Grid grid;
  const Eigen::Vector3d corner = centre(grid, 5, 5, 5) + Eigen::Vector3d::Constant(0.5 * grid.cell_m);
  std::vector<Eigen::Vector3d> points{centre(grid, 5, 5, 5)};
  for (int i = 0; i < 50; ++i) {
    const double noise_m = 2e-5 * (i % 2 == 0 ? 1.0 : -1.0);
    points.push_back(corner + Eigen::Vector3d(noise_m, -noise_m, noise_m));
  }
  points.push_back(centre(grid, 5, 5, 6));
  const CellPath path = discretise(through(points), Segment::kA, grid).value();
  CHECK(path.cells == std::vector{grid.index({5, 5, 5}), grid.index({5, 5, 6})});
}

TEST_CASE("a descent that drifts over a face by less than a fifth of a cell stays in its column") {
  const Grid grid;
  const auto fallen = [&](double drift) {
    std::vector<Eigen::Vector3d> points;
    for (int k = 9; k >= 5; --k) {
      const double share = (9 - k) / 4.0;
      points.push_back(centre(grid, 5, 5, k) + Eigen::Vector3d((0.45 + drift * share) * grid.cell_m, 0.0, 0.0));
    }
    return discretise(through(points), Segment::kA, grid).value().cells;
  };
  CHECK(fallen(0.2).size() == 5);
  CHECK(fallen(0.2).back() == grid.index({5, 5, 5}));
  CHECK(fallen(0.3).back() == grid.index({6, 5, 5}));
}

TEST_CASE("no sample is farther from its cell's centre than the corner of what the cell keeps") {
  const Grid grid;
  const CellPath path = discretise(testing::moving_demonstration(2000), Segment::kA, grid).value();
  CHECK(path.max_error_m <= (0.5 + kCellHysteresis) * std::sqrt(3.0) * grid.cell_m + 1e-8);
  CHECK(path.mean_error_m > 0.0);
  CHECK(path.mean_error_m < path.max_error_m);
}

TEST_CASE("a missing segment and one that stays in its cell are errors that name it") {
  const Grid grid;
  const Demonstration still = through({centre(grid, 5, 5, 5), centre(grid, 5, 5, 5)});
  CHECK(discretise(still, Segment::kC, grid).error().text() == "Path has no segment C");
  CHECK(discretise(still, Segment::kA, grid).error().code() == ErrorCode::kInvalidArgument);
}
