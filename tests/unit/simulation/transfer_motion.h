/// Hand-made motions for tests and benchmarks: minimum-jerk moves of the tools, commanded tick by tick.
#pragma once

#include <functional>
#include <vector>

#include "engine/simulation/grasp.h"
#include "engine/simulation/world.h"

namespace trocar::simulation {

/// Where both arms are to be after `duration_s` more.
struct Waypoint {
  kinematics::ArmSide side;
  spatial::Pose X_WT;
  double jaw_rad;
  double duration_s;
};

/// Moves one arm to the waypoint along a minimum-jerk profile; the other one holds. `each_tick` is called after every
/// step.
inline void follow(World& world, const Waypoint& goal, const std::function<void(const World&)>& each_tick = {}) {
  const ArmCommand from = world.state().arm(goal.side).setpoint;
  const int ticks = static_cast<int>(goal.duration_s * world.options().ticks_per_second);
  for (int i = 1; i <= ticks; ++i) {
    const double s = static_cast<double>(i) / ticks;
    const double blend = s * s * s * (10.0 + s * (6.0 * s - 15.0));
    const spatial::Pose X_WT = spatial::interpolate(from.X_WT, goal.X_WT, blend);
    const double jaw_rad = from.jaw_rad + blend * (goal.jaw_rad - from.jaw_rad);
    if (const Status status = world.command(goal.side, {X_WT, jaw_rad}); !status) return;
    world.step();
    if (each_tick) each_tick(world);
  }
}

inline spatial::Pose raised(spatial::Pose pose, double z_m) {
  pose.p.z() += z_m;
  return pose;
}

/// Takes the block at its wall and closes: above, down, grip.
inline void take(World& world, kinematics::ArmSide side, int block, int wall,
                 const std::function<void(const World&)>& each_tick = {}) {
  const spatial::Pose grasp = grasp_pose(world.state().blocks[static_cast<std::size_t>(block)].X_WK, wall);
  follow(world, {side, raised(grasp, 0.018), kApproachOpening_rad, 1.0}, each_tick);
  follow(world, {side, grasp, kApproachOpening_rad, 0.6}, each_tick);
  follow(world, {side, grasp, kGripCommand_rad, 0.4}, each_tick);
}

}  // namespace trocar::simulation
