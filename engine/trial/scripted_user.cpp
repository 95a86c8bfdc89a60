#include "engine/trial/scripted_user.h"

#include <cmath>

#include "engine/peg_board/peg_board.h"
#include "engine/simulation/grasp.h"
#include "engine/spatial/grid.h"

namespace trocar::trial {
namespace {

using kinematics::ArmSide;

/// z of the tip before it comes down on the block: people go over it, then down.
constexpr double kOverTip_m = 0.048;
constexpr double kAboveTip_m = 0.028;   ///< z of the tip at the end of A.
constexpr double kFreeTip_m = 0.022;    ///< From here up the tip is free to move sideways.
constexpr double kLiftedTip_m = 0.045;  ///< z of the tip at the end of B.
constexpr double kHoverOverTop_m = 0.0025;
constexpr double kRetreatUp_m = 0.012;
constexpr double kFirstLook_s = 0.6;
constexpr double kUserGivesUp_s = 0.8;
constexpr double kRelaxTime_s = 1.5;
/// A block that moved or turned by more on the way down was pushed by a jaw.
constexpr double kPushed_m = 0.0020;
constexpr double kPushed_rad = 0.25;
constexpr double kAssistantHolds_s = 0.25;
/// Where the agent's way is taken to have ended: across from the grasp, and from the hand-off.
constexpr double kLedThere_m = 0.012;
constexpr double kPresentable_m = 0.005;
/// So long people wait for an agent that does not begin, and so long they watch one that has come to rest.
constexpr double kAgentBegins_s = 0.5;
constexpr double kResting_m_s = 0.003;
constexpr int kResting_samples = 40;
/// A grasp nearer to the lattice's faces than this is avoided if there is another.
constexpr double kLatticeMargin_m = 0.0004;

Eigen::Vector3d at_height(const Eigen::Vector3d& p, double z_m) {
  return {p.x(), p.y(), z_m};
}

bool inside_lattice(const Eigen::Vector3d& p_W) {
  const spatial::Grid grid;
  const Eigen::Vector3d side = Eigen::Vector3d::Constant(grid.cell_m * grid.n);
  const Eigen::Vector3d margin{kLatticeMargin_m, kLatticeMargin_m, 0.0};
  const Eigen::Vector3d low = grid.p_WGo + margin;
  const Eigen::Vector3d high = grid.p_WGo + side - margin;
  return (p_W.array() >= low.array()).all() && (p_W.array() <= high.array()).all();
}

}  // namespace

ScriptedUser::ScriptedUser(const Assignment& assignment, const Random& random)
    : ScriptedOperator(ArmSide::kLeft, assignment, random) {
  pause_s_ = kFirstLook_s + 2.0 * hesitation_s();
}

void ScriptedUser::go(Step step) {
  step_ = step;
  pause_s_ = hesitation_s();
  foot_up_ = false;
  still_ = 0;
  begin_step();
}

void ScriptedUser::choose_grasp(const Glimpse& seen) {
  judge_anew();
  const spatial::Pose& X_WK = seen.block.X_WK;
  const std::array<int, 3> walls = simulation::walls_by_preference(ArmSide::kLeft, X_WK);
  int wall = walls[0];
  if (!inside_lattice(simulation::grasp_pose(X_WK, walls[0]).p) &&
      inside_lattice(simulation::grasp_pose(X_WK, walls[1]).p)) {
    wall = walls[1];
  }
  grasp_ = judged(simulation::grasp_pose(X_WK, wall));
  block_before_ = X_WK;
}

void ScriptedUser::try_again(const Glimpse& seen) {
  grip(draw_opening(), kGripTime_s);
  choose_grasp(seen);
  go(Step::kAbove);
}

bool ScriptedUser::pushed(const Glimpse& seen) const {
  return (seen.block.X_WK.p - block_before_.p).norm() > kPushed_m ||
         spatial::angle_between(seen.block.X_WK.q, block_before_.q) > kPushed_rad;
}

void ScriptedUser::think(const Glimpse& seen) {
  if (step_ < Step::kClose) {
    think_of_approach(seen);
  } else if (step_ < Step::kAgentC) {
    think_of_lift(seen);
  } else {
    think_of_transfer(seen);
  }
}

bool ScriptedUser::agent_has_done() {
  if (foot_up_) return waited(skill().reaction_s);
  press_agent_pedal(true);
  still_ = eyes().tool_speed_m_s(side()) < kResting_m_s ? still_ + 1 : 0;
  if (!waited(kAgentBegins_s + loop_s()) || still_ < kResting_samples) return false;
  press_agent_pedal(false);
  foot_up_ = true;
  begin_step();
  return false;
}

Aim ScriptedUser::above(const Glimpse& seen) const {
  // From a failed grasp the jaws first come straight up: sideways they would sweep the block away.
  const Eigen::Vector3d& p_WT = seen.tool(side()).p;
  const Eigen::Vector3d& over = p_WT.z() < kFreeTip_m ? p_WT : grasp_.p;
  return {{at_height(over, kAboveTip_m), grasp_.q}, 4.0 * skill().tolerance_m, 0.12, 1.0};
}

void ScriptedUser::think_of_approach(const Glimpse& seen) {
  const double tolerance_m = skill().tolerance_m;
  const double top_m = seen.block.X_WK.p.z() + 0.5 * peg_board::kBlockHeight_m;
  switch (step_) {
    case Step::kIdle:
      if (!waited(pause_s_)) return;
      choose_grasp(seen);
      return go(assignment().shares_control ? Step::kAgentA : Step::kOver);
    case Step::kAgentA: {
      if (!agent_has_done()) return;
      const Eigen::Vector3d& p_WT = seen.tool(side()).p;
      const bool over = std::hypot(p_WT.x() - grasp_.p.x(), p_WT.y() - grasp_.p.y()) < kLedThere_m;
      return go(over ? Step::kAbove : Step::kOver);
    }
    case Step::kOver:
      if (reach(seen, {{at_height(grasp_.p, kOverTip_m), grasp_.q}, 3.0 * tolerance_m, 0.12, 1.0})) go(Step::kAbove);
      return;
    case Step::kAbove:
      if (!reach(seen, above(seen))) return;
      grip(draw_opening(), kGripTime_s);
      return go(Step::kAlign);
    case Step::kAlign:
      if (hand_busy() || !waited(pause_s_)) return;
      if (reach(seen, {{at_height(grasp_.p, kAboveTip_m), grasp_.q}, tolerance_m, 0.06, 1.0})) go(Step::kHover);
      return;
    case Step::kHover:
      if (reach(seen, {{at_height(grasp_.p, top_m + kHoverOverTop_m), grasp_.q}, tolerance_m, 0.06, 1.4})) {
        go(Step::kDescend);
      }
      return;
    case Step::kDescend:
      if (pushed(seen) && !hand_busy()) return try_again(seen);
      if (!reach(seen, {grasp_, 1.5 * tolerance_m, 0.10, 1.5}) || !waited(pause_s_)) return;
      grip_rad_ = draw_grip();
      grip(grip_rad_, kGripTime_s);
      return go(Step::kClose);
    default:
      return;
  }
}

void ScriptedUser::think_of_lift(const Glimpse& seen) {
  switch (step_) {
    case Step::kClose: {
      const bool feels = seen.block.held_by(ArmSide::kLeft);
      if (hand_busy() || !waited(kGripTime_s + (feels ? kFeel_s : kUserGivesUp_s))) return;
      return go(Step::kLift);
    }
    case Step::kLift: {
      if (!reach(seen, {{at_height(grasp_.p, kLiftedTip_m), grasp_.q}, 5.0 * skill().tolerance_m, 0.15, 1.3})) return;
      const bool lifted = seen.block.X_WK.p.z() > block_before_.p.z() + 0.5 * (kLiftedTip_m - grasp_.p.z());
      if (!lifted) return try_again(seen);
      grip(grip_rad_ + skill().relaxing_rad * std::abs(random().normal()), kRelaxTime_s);
      hasty_ = random().uniform() < skill().haste;
      return go(assignment().shares_control ? Step::kAgentC : Step::kCarry);
    }
    default:
      return;
  }
}

void ScriptedUser::think_of_transfer(const Glimpse& seen) {
  const double tolerance_m = skill().tolerance_m;
  const spatial::Pose hand_off{peg_board::kHandOff_m, grasp_.q};
  switch (step_) {
    case Step::kAgentC: {
      if (!agent_has_done()) return;
      const bool there = (seen.tool(side()).p - peg_board::kHandOff_m).norm() < kPresentable_m;
      return go(there ? Step::kPresent : Step::kCarry);
    }
    case Step::kCarry:
      if (waited(pause_s_) && reach(seen, {hand_off, 6.0 * tolerance_m, 0.15, 1.2})) go(Step::kPresent);
      return;
    case Step::kPresent:
      if (hasty_) {
        if (!seen.block.touched_by(ArmSide::kRight)) return;
      } else {
        if (!seen.block.held_by(ArmSide::kRight)) begin_step();
        if (!waited(kAssistantHolds_s + pause_s_ + skill().reaction_s)) return;
      }
      grip(draw_opening(), kGripTime_s);
      return go(Step::kOpen);
    case Step::kOpen:
      if (hand_busy() || !waited(kGripTime_s + loop_s())) return;
      grasp_ = shifted(seen.tool(side()), {0.0, 0.0, kRetreatUp_m});
      return go(Step::kUp);
    case Step::kUp:
      if (reach(seen, {grasp_, 4.0 * tolerance_m, 0.15, 1.2})) go(Step::kRetreat);
      return;
    case Step::kRetreat:
      if (reach(seen, {{kinematics::ready_pose(ArmSide::kLeft).p, grasp_.q}, 8.0 * tolerance_m, 0.3, 1.0})) {
        go(Step::kRest);
      }
      return;
    default:
      return;
  }
}

}  // namespace trocar::trial
