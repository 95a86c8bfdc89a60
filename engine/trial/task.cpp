#include "engine/trial/task.h"

#include <cmath>

#include "engine/core/check.h"

namespace trocar::trial {
namespace {

using demonstration::Outcome;
using demonstration::Segment;
using kinematics::ArmSide;

constexpr double kLift_m = 0.002;
constexpr Tick kLiftTime{100};
constexpr Tick kLostTime{100};
constexpr Tick kHandOffTime{200};
constexpr Tick kSeatedTime{100};
constexpr Tick kShutTime{200};
constexpr double kSeatedAcross_m = 0.005;
constexpr double kSeatedHeight_m = 0.004;

constexpr double kSlow_m_s = 0.010;
/// Above the block: within this distance of its axis, and of its centre's height.
constexpr double kAboveAcross_m = 0.009;
constexpr double kAboveHeight_m = 0.0235;
/// From here down the tool is going in, slow or not: the height of a peg above a resting block's centre.
constexpr double kEntering_m = peg_board::kPegHeight_m - peg_board::kBlockRest_m;
/// A block whose centre is this high clears the pegs by 3 mm.
constexpr double kClear_m = peg_board::kPegHeight_m + 0.5 * peg_board::kBlockHeight_m + 0.003;
constexpr double kAtHandOff_m = 0.005;

double across(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

}  // namespace

bool Lasting::update(bool condition, Tick now) {
  if (!condition) {
    since_.reset();
    return false;
  }
  if (!since_) since_ = now;
  return now.count - since_->count >= needed_.count;
}

Task::Task(int block, int goal)
    : block_(block),
      goal_(goal),
      lifted_(kLiftTime),
      lost_(kLostTime),
      handed_(kHandOffTime),
      seated_(kSeatedTime),
      shut_(kShutTime) {
  TROCAR_CHECK(block >= 0 && block < peg_board::kBlockCount && goal >= 0 && goal < peg_board::kBlockCount);
}

void Task::update(const simulation::WorldState& state) {
  update_outcome(state);
  update_misses(state);
  update_segment(state);
  tips_[tip_count_++ % tips_.size()] = state.arm(ArmSide::kLeft).X_WT.p;
}

void Task::decide(Outcome outcome, Tick now) {
  outcome_ = outcome;
  decided_at_ = now;
}

void Task::update_outcome(const simulation::WorldState& state) {
  const simulation::BlockState& block = state.blocks[static_cast<std::size_t>(block_)];
  const Eigen::Vector3d& p_WK = block.X_WK.p;
  const bool held = block.held_by(ArmSide::kLeft);
  const bool touched = block.touched_by(ArmSide::kLeft) || block.touched_by(ArmSide::kRight);
  const bool lifted = lifted_.update(held && p_WK.z() >= peg_board::kBlockRest_m + kLift_m, state.tick);
  if (lifted) lift_attempted_ = true;
  if (lifted && !lifting_) ++lifts_;
  lifting_ = lifted;

  if (outcome_ == Outcome::kUnfinished) {
    const bool assistant_holds = handed_.update(block.held_by(ArmSide::kRight), state.tick);
    const bool lost = lost_.update(lift_attempted_ && !touched, state.tick);
    if (lift_attempted_ && assistant_holds && !block.touched_by(ArmSide::kLeft)) {
      decide(Outcome::kSuccess, state.tick);
    } else if (lost) {
      decide(Outcome::kDropped, state.tick);
    }
  }
  const bool on_goal = across(p_WK, peg_board::goal_peg(goal_)) <= kSeatedAcross_m &&
                       std::abs(p_WK.z() - peg_board::kBlockRest_m) <= kSeatedHeight_m;
  const bool open = state.arm(ArmSide::kLeft).jaw_rad >= kOpen_rad && state.arm(ArmSide::kRight).jaw_rad >= kOpen_rad;
  placed_ = seated_.update(on_goal && open && !touched, state.tick);
}

void Task::update_misses(const simulation::WorldState& state) {
  const simulation::BlockState& block = state.blocks[static_cast<std::size_t>(block_)];
  const bool empty = state.arm(ArmSide::kLeft).jaw_rad < kClosed_rad && !block.held_by(ArmSide::kLeft);
  const bool shut = shut_.update(empty, state.tick);
  // Jaws that were shut from the beginning have missed nothing.
  if (state.arm(ArmSide::kLeft).jaw_rad >= kOpen_rad) shut_before_ = false;
  if (shut && !shut_before_) {
    ++misses_;
    shut_before_ = true;
  }
}

void Task::update_segment(const simulation::WorldState& state) {
  const Eigen::Vector3d& p_WT = state.arm(ArmSide::kLeft).X_WT.p;
  const Eigen::Vector3d& p_WK = state.blocks[static_cast<std::size_t>(block_)].X_WK.p;
  const double span_s = static_cast<double>(tips_.size()) / demonstration::kSampleRate_hz;
  const bool slow = tip_count_ >= tips_.size() && (p_WT - tips_[tip_count_ % tips_.size()]).norm() < kSlow_m_s * span_s;
  const double height_m = p_WT.z() - p_WK.z();
  switch (segment_) {
    case Segment::kA:
      if (across(p_WT, p_WK) > kAboveAcross_m || height_m > kAboveHeight_m) break;
      if (slow || height_m < kEntering_m) segment_ = Segment::kB;
      break;
    case Segment::kB:
      if (lift_attempted_ && p_WK.z() >= kClear_m && slow) segment_ = Segment::kC;
      break;
    case Segment::kC:
      if ((p_WT - peg_board::kHandOff_m).norm() < kAtHandOff_m && slow) segment_ = Segment::kD;
      break;
    case Segment::kD:
      break;
    case Segment::kE:
      return;
  }
  if (outcome_ == Outcome::kSuccess) segment_ = Segment::kE;
}

}  // namespace trocar::trial
