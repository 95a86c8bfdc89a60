#include "engine/peg_board/peg_board.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace trocar::peg_board;

namespace {

std::vector<Eigen::Vector3d> all_pegs() {
  std::vector<Eigen::Vector3d> pegs;
  for (int i = 0; i < kBlockCount; ++i) pegs.push_back(start_peg(i));
  for (int i = 0; i < kBlockCount; ++i) pegs.push_back(goal_peg(i));
  return pegs;
}

}  // namespace

TEST_CASE("the start pegs are a regular hexagon of radius 23 mm about (-10, -27) mm") {
  for (int i = 0; i < kBlockCount; ++i) {
    const Eigen::Vector3d from_centre = start_peg(i) - Eigen::Vector3d(-0.010, -0.027, 0.0);
    CHECK(from_centre.norm() == doctest::Approx(0.023).epsilon(1e-4));
    const double turns = std::atan2(from_centre.y(), from_centre.x()) / (std::acos(-1.0) / 3.0);
    CHECK(std::abs(turns - std::round(turns)) < 1e-3);
  }
}

TEST_CASE("no two pegs are so near that their blocks would touch at every yaw, and all stand on the board") {
  const auto pegs = all_pegs();
  REQUIRE(pegs.size() == kPegCount);
  for (std::size_t i = 0; i < pegs.size(); ++i) {
    CHECK(std::abs(pegs[i].x()) < kBoardX_m / 2.0);
    CHECK(std::abs(pegs[i].y()) < kBoardY_m / 2.0);
    CHECK(pegs[i].z() == 0.0);
    // Twice the inner radius of a block: nearer pegs could not both hold one.
    for (std::size_t j = i + 1; j < pegs.size(); ++j) CHECK((pegs[i] - pegs[j]).norm() > 0.010);
  }
}

TEST_CASE("start pegs lie in the left arm's half and goal pegs in the right arm's") {
  for (int i = 0; i < kBlockCount; ++i) {
    Eigen::Vector3d at_height = start_peg(i) + Eigen::Vector3d(0, 0, 0.02);
    CHECK(wrist_workspace(true).contains(at_height));
    at_height = goal_peg(i) + Eigen::Vector3d(0, 0, 0.02);
    CHECK(wrist_workspace(false).contains(at_height));
  }
}

TEST_CASE(
    "hole, wall and circumscribed circle of a block agree: an equilateral triangle's side is half as far as its "
    "corner") {
  CHECK(kHoleApothem_m + kWallThickness_m == doctest::Approx(kBlockCircumradius_m / 2.0));
  CHECK(kBlockRest_m == doctest::Approx(kBlockHeight_m / 2.0));
}
