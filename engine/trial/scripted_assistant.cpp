#include "engine/trial/scripted_assistant.h"

#include "engine/peg_board/peg_board.h"
#include "engine/simulation/grasp.h"

namespace trocar::trial {
namespace {

using kinematics::ArmSide;

constexpr double kPresentedWithin_m = 0.006;
constexpr double kPresentedSpeed_m_s = 0.006;
constexpr double kAboveGrasp_m = 0.014;
/// A block lower than this is held by nobody.
constexpr double kDroppedBelow_m = 0.025;
constexpr double kUserGone_m = 0.010;
/// The block's bottom passes this far over the peg's top.
constexpr double kOverPeg_m = 0.004;
/// The block is let go this far above its rest.
constexpr double kRelease_m = 0.0006;
constexpr double kAwayUp_m = 0.022;
/// At the hand-off there is no peg in the hole, so the jaws may straddle the wall with more room.
constexpr double kWider_rad = 0.08;
constexpr double kAssistantGivesUp_s = 1.0;

}  // namespace

ScriptedAssistant::ScriptedAssistant(const Assignment& assignment, const Random& random)
    : ScriptedOperator(ArmSide::kRight, assignment, random) {}

void ScriptedAssistant::go(Step step) {
  step_ = step;
  pause_s_ = hesitation_s();
  begin_step();
}

spatial::Pose ScriptedAssistant::judge_grasp(const Glimpse& seen) const {
  const spatial::Pose& X_WK = seen.block.X_WK;
  const Eigen::Vector3d& p_user = seen.tool(ArmSide::kLeft).p;
  spatial::Pose best;
  for (const int wall : simulation::walls_by_preference(ArmSide::kRight, X_WK)) {
    best = simulation::grasp_pose(X_WK, wall);
    if ((best.p - p_user).norm() > peg_board::kWallMid_m) break;
  }
  return judged(best);
}

spatial::Pose ScriptedAssistant::carrying(const Glimpse& seen, const Eigen::Vector3d& p_WK) const {
  return shifted(seen.tool(ArmSide::kRight), p_WK - seen.block.X_WK.p);
}

void ScriptedAssistant::give_up(const Glimpse& seen) {
  away_ = shifted(seen.tool(side()), {0.0, 0.0, kAwayUp_m});
  go(Step::kUp);
}

void ScriptedAssistant::think(const Glimpse& seen) {
  if (step_ < Step::kOverPeg) {
    think_of_taking(seen);
  } else {
    think_of_placing(seen);
  }
}

void ScriptedAssistant::think_of_taking(const Glimpse& seen) {
  const double tolerance_m = skill().tolerance_m;
  switch (step_) {
    case Step::kWatch: {
      const bool presented = seen.block.held_by(ArmSide::kLeft) &&
                             (seen.tool(ArmSide::kLeft).p - peg_board::kHandOff_m).norm() < kPresentedWithin_m &&
                             eyes().tool_speed_m_s(ArmSide::kLeft) < kPresentedSpeed_m_s;
      if (!presented) begin_step();
      if (!waited(skill().reaction_s + pause_s_)) return;
      judge_anew();
      grip(draw_opening() + kWider_rad, kGripTime_s);
      return go(Step::kAbove);
    }
    case Step::kAbove:
      if (seen.block.X_WK.p.z() < kDroppedBelow_m) return give_up(seen);
      grasp_ = judge_grasp(seen);
      if (reach(seen, {shifted(grasp_, {0.0, 0.0, kAboveGrasp_m}), tolerance_m, 0.06, 1.0})) go(Step::kDescend);
      return;
    case Step::kDescend:
      if (!reach(seen, {grasp_, 1.5 * tolerance_m, 0.08, 1.5})) return;
      grip(draw_grip(), kGripTime_s);
      return go(Step::kClose);
    case Step::kClose: {
      const bool holds = seen.block.held_by(ArmSide::kRight);
      if (hand_busy() || !waited(kGripTime_s + (holds ? kFeel_s : kAssistantGivesUp_s))) return;
      if (!holds) {
        judge_anew();
        grip(draw_opening() + kWider_rad, kGripTime_s);
        return go(Step::kAbove);
      }
      const bool user_gone = !seen.block.touched_by(ArmSide::kLeft) &&
                             (seen.tool(ArmSide::kLeft).p - seen.tool(ArmSide::kRight).p).norm() > kUserGone_m;
      if (user_gone) go(Step::kOverPeg);
      return;
    }
    default:
      return;
  }
}

void ScriptedAssistant::think_of_placing(const Glimpse& seen) {
  const double tolerance_m = skill().tolerance_m;
  const Eigen::Vector3d foot = peg_board::goal_peg(assignment().goal);
  if (step_ < Step::kOpen && !seen.block.touched_by(side())) return give_up(seen);
  const double carry_m = peg_board::kPegHeight_m + 0.5 * peg_board::kBlockHeight_m + kOverPeg_m;
  switch (step_) {
    case Step::kOverPeg:
      if (!waited(pause_s_)) return;
      if (reach(seen, {carrying(seen, foot + Eigen::Vector3d(0.0, 0.0, carry_m)), 1.5 * tolerance_m, 0.1, 1.1})) {
        go(Step::kLower);
      }
      return;
    case Step::kLower:
      if (!reach(seen, {carrying(seen, foot + Eigen::Vector3d(0.0, 0.0, peg_board::kBlockRest_m + kRelease_m)),
                        2.0 * tolerance_m, 0.1, 1.4})) {
        return;
      }
      grip(draw_opening(), kGripTime_s);
      return go(Step::kOpen);
    case Step::kOpen:
      if (hand_busy() || !waited(kGripTime_s + loop_s())) return;
      away_ = shifted(seen.tool(side()), {0.0, 0.0, kAwayUp_m});
      return go(Step::kUp);
    case Step::kUp:
      if (reach(seen, {away_, 4.0 * tolerance_m, 0.15, 1.2})) go(Step::kRetreat);
      return;
    case Step::kRetreat:
      if (reach(seen, {{kinematics::ready_pose(ArmSide::kRight).p, away_.q}, 8.0 * tolerance_m, 0.3, 1.0})) {
        go(Step::kRest);
      }
      return;
    default:
      return;
  }
}

}  // namespace trocar::trial
