#include "engine/simulation/board.h"

namespace trocar::simulation {

using namespace peg_board;

Board make_board() {
  Board board;
  board.table.reset(dCreatePlane(nullptr, 0.0, 0.0, 1.0, kTableZ_m * kOdeLength));
  board.board.reset(dCreateBox(nullptr, kBoardX_m * kOdeLength, kBoardY_m * kOdeLength, kBoardZ_m * kOdeLength));
  set_pose(board.board.get(), spatial::Pose::translation({0.0, 0.0, -kBoardZ_m / 2.0}));
  for (int i = 0; i < kPegCount; ++i) {
    const auto k = static_cast<std::size_t>(i);
    board.feet[k] = i < kBlockCount ? start_peg(i) : goal_peg(i - kBlockCount);
    board.pegs[k].reset(dCreateCylinder(nullptr, kPegRadius_m * kOdeLength, kPegHeight_m * kOdeLength));
    set_pose(board.pegs[k].get(),
             spatial::Pose::translation(board.feet[k] + Eigen::Vector3d(0.0, 0.0, kPegHeight_m / 2.0)));
  }
  return board;
}

}  // namespace trocar::simulation
