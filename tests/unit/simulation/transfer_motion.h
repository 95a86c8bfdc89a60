/// Hand-made motions for tests and benchmarks: minimum-jerk moves of the tools, commanded tick by tick.
#pragma once

#include <functional>

#include "engine/peg_board/peg_board.h"
#include "engine/simulation/grasp.h"
#include "engine/simulation/world.h"

namespace trocar::simulation {

using EachTick = std::function<void(World&)>;

/// Where an arm is to be after `duration_s` more.
struct Waypoint {
  kinematics::ArmSide side;
  spatial::Pose X_WT;
  double jaw_rad;
  double duration_s;
};

/// Commands the waypoint along a minimum-jerk profile; the other arm holds. `step` advances the world by one tick.
inline Status follow(World& world, const Waypoint& goal, const EachTick& step = &World::step) {
  const ArmCommand from = world.state().arm(goal.side).setpoint;
  const int ticks = static_cast<int>(goal.duration_s * world.options().ticks_per_second);
  for (int i = 1; i <= ticks; ++i) {
    const double s = static_cast<double>(i) / ticks;
    const double blend = s * s * s * (10.0 + s * (6.0 * s - 15.0));
    const spatial::Pose X_WT = spatial::interpolate(from.X_WT, goal.X_WT, blend);
    const double jaw_rad = from.jaw_rad + blend * (goal.jaw_rad - from.jaw_rad);
    TROCAR_RETURN_IF_ERROR(world.command(goal.side, {X_WT, jaw_rad}));
    step(world);
  }
  return {};
}

inline spatial::Pose raised(spatial::Pose pose, double z_m) {
  pose.p.z() += z_m;
  return pose;
}

/// Opens, comes down on the wall from above, and closes; the aim is off by `error_m`.
inline Status take(World& world, kinematics::ArmSide side, int block, int wall, const EachTick& step = &World::step,
                   const Eigen::Vector3d& error_m = Eigen::Vector3d::Zero()) {
  spatial::Pose grasp = grasp_pose(world.state().blocks[static_cast<std::size_t>(block)].X_WK, wall);
  grasp.p += error_m;
  TROCAR_RETURN_IF_ERROR(follow(world, {side, raised(grasp, 0.018), kApproachOpening_rad, 1.2}, step));
  TROCAR_RETURN_IF_ERROR(follow(world, {side, grasp, kApproachOpening_rad, 0.6}, step));
  return follow(world, {side, grasp, kGripCommand_rad, 0.4}, step);
}

/// Carries the held block so that its centre gets to `p_WK`, without turning it.
inline Status carry(World& world, kinematics::ArmSide side, int block, const Eigen::Vector3d& p_WK, double duration_s,
                    const EachTick& step = &World::step) {
  spatial::Pose X_WT = world.state().arm(side).setpoint.X_WT;
  X_WT.p += p_WK - world.state().blocks[static_cast<std::size_t>(block)].X_WK.p;
  return follow(world, {side, X_WT, kGripCommand_rad, duration_s}, step);
}

/// Opens and goes up.
inline Status let_go(World& world, kinematics::ArmSide side, const EachTick& step = &World::step) {
  const spatial::Pose X_WT = world.state().arm(side).setpoint.X_WT;
  TROCAR_RETURN_IF_ERROR(follow(world, {side, X_WT, kApproachOpening_rad, 0.3}, step));
  return follow(world, {side, raised(X_WT, 0.012), kApproachOpening_rad, 0.5}, step);
}

/// The whole job: the left arm takes the block from its start peg and carries it to the hand-off, the right arm takes
/// it by another wall and puts it on the goal peg. `error_m` is added to both aims.
inline Status transfer(World& world, int block, int goal, const EachTick& step = &World::step,
                       const Eigen::Vector3d& error_m = Eigen::Vector3d::Zero()) {
  using kinematics::ArmSide;
  const BlockState& moved = world.state().blocks[static_cast<std::size_t>(block)];
  const Eigen::Vector3d up(0.0, 0.0, 0.035);
  TROCAR_RETURN_IF_ERROR(
      take(world, ArmSide::kLeft, block, walls_by_preference(ArmSide::kLeft, moved.X_WK)[0], step, error_m));
  TROCAR_RETURN_IF_ERROR(carry(world, ArmSide::kLeft, block, moved.X_WK.p + up, 1.0, step));
  spatial::Pose at_hand_off = world.state().arm(ArmSide::kLeft).setpoint.X_WT;
  at_hand_off.p = peg_board::kHandOff_m;
  TROCAR_RETURN_IF_ERROR(follow(world, {ArmSide::kLeft, at_hand_off, kGripCommand_rad, 1.5}, step));
  TROCAR_RETURN_IF_ERROR(
      take(world, ArmSide::kRight, block, walls_by_preference(ArmSide::kRight, moved.X_WK)[0], step, error_m));
  TROCAR_RETURN_IF_ERROR(let_go(world, ArmSide::kLeft, step));
  TROCAR_RETURN_IF_ERROR(
      follow(world, {ArmSide::kLeft, kinematics::ready_pose(ArmSide::kLeft), kApproachOpening_rad, 1.0}, step));
  const Eigen::Vector3d seat = peg_board::goal_peg(goal) + Eigen::Vector3d(0.0, 0.0, peg_board::kBlockRest_m);
  TROCAR_RETURN_IF_ERROR(carry(world, ArmSide::kRight, block, seat + up, 1.5, step));
  TROCAR_RETURN_IF_ERROR(carry(world, ArmSide::kRight, block, seat + Eigen::Vector3d(0, 0, 0.0005), 1.0, step));
  TROCAR_RETURN_IF_ERROR(let_go(world, ArmSide::kRight, step));
  return follow(world, {ArmSide::kRight, kinematics::ready_pose(ArmSide::kRight), 0.0, 1.0}, step);
}

/// Where the block is from its seat on the goal peg.
inline Eigen::Vector3d miss(const World& world, int block, int goal) {
  return world.state().blocks[static_cast<std::size_t>(block)].X_WK.p - peg_board::goal_peg(goal) -
         Eigen::Vector3d(0.0, 0.0, peg_board::kBlockRest_m);
}

/// Within 5 mm in xy and 4 mm in z of its seat, and no jaw on it.
inline bool placed(const World& world, int block, int goal) {
  const Eigen::Vector3d off = miss(world, block, goal);
  const BlockState& state = world.state().blocks[static_cast<std::size_t>(block)];
  return off.head<2>().norm() < 0.005 && std::abs(off.z()) < 0.004 && !state.touched_by(kinematics::ArmSide::kLeft) &&
         !state.touched_by(kinematics::ArmSide::kRight);
}

}  // namespace trocar::simulation
