/// What can be known of the simulated world at one tick, without any of ODE.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "engine/core/tick.h"
#include "engine/kinematics/psm.h"
#include "engine/peg_board/peg_board.h"
#include "engine/spatial/pose.h"

namespace trocar::simulation {

/// Where an arm is told to be at the end of the next tick.
struct ArmCommand {
  spatial::Pose X_WT;    ///< Tool tip.
  double jaw_rad = 0.0;  ///< Full opening angle between the jaws; below contact it grips, down to −40°.
};

struct ArmState {
  ArmCommand setpoint;  ///< The last command that was accepted.
  spatial::Pose X_WT;   ///< Measured: the kinematic arm after this tick.
  kinematics::Joints joints{};
  double jaw_rad = 0.0;  ///< Measured opening; stays above the setpoint while something is gripped.
};

struct BlockState {
  spatial::Pose X_WK;
  Eigen::Vector3d v_WK{0, 0, 0};  ///< m/s
  Eigen::Vector3d w_WK{0, 0, 0};  ///< rad/s
  /// Which of an arm's two jaws touch the block: [arm][jaw].
  std::array<std::array<bool, 2>, 2> jaw_contact{};
  bool touches_scene = false;  ///< Board, any peg or the table.
  bool asleep = false;

  bool held_by(kinematics::ArmSide side) const {
    const auto& jaws = jaw_contact[kinematics::index_of(side)];
    return jaws[0] && jaws[1];
  }
  bool touched_by(kinematics::ArmSide side) const {
    const auto& jaws = jaw_contact[kinematics::index_of(side)];
    return jaws[0] || jaws[1];
  }
};

struct WorldState {
  Tick tick;
  std::array<ArmState, 2> arms;  ///< By `kinematics::index_of`.
  std::array<BlockState, peg_board::kBlockCount> blocks;
  std::int64_t strained = 0;  ///< Times the physics had to be helped ("LCP internal error" and its kin).

  const ArmState& arm(kinematics::ArmSide side) const { return arms[kinematics::index_of(side)]; }
};

}  // namespace trocar::simulation
