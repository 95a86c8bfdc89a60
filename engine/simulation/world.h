/// One simulated world: the peg board, six blocks held by friction alone, and two kinematic arms.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "engine/core/result.h"
#include "engine/simulation/world_snapshot.h"
#include "engine/simulation/world_state.h"

namespace trocar::simulation {

struct WorldOptions {
  std::uint64_t seed = 1;         ///< Yaw of each block, uniform in ±30°.
  double jaw_friction = 0.8;      ///< µ at the jaws.
  double scene_friction = 0.4;    ///< µ elsewhere.
  double grip_torque_nm = 0.020;  ///< Limit of each jaw's servo; 20 mN·m is 2.5 N at the tip.
  int ticks_per_second = 1000;    ///< 1000 live; 500 allowed for rollouts.
  /// Where the left tool begins, turned as in `kinematics::ready_pose`; nothing: there. Only the beginning depends on
  /// it. Precondition: within reach.
  std::optional<Eigen::Vector3d> left_begin_p_WT = std::nullopt;
};

/// Both arms start at `kinematics::ready_pose` with closed jaws, each block on its start peg.
///
/// Threads: one at a time; different worlds may be stepped in different threads and give the same bits as serially.
class World {
 public:
  explicit World(const WorldOptions& options = {});
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  /// Sets where `side` is to be at the end of the next tick; the arm moves there at constant speed during the tick.
  /// Errors: kInvalidArgument if not finite; kOutOfReach naming the joint. The old setpoint then stays.
  Status command(kinematics::ArmSide side, const ArmCommand& command);

  /// Advances one tick.
  void step();

  const WorldState& state() const;
  const WorldOptions& options() const;

  /// The whole state as a value; a world restored from it continues bit-identically.
  WorldSnapshot snapshot() const;
  /// Takes over the seed too, which only the beginning depends on.
  /// Errors: kInvalidArgument for bytes that are not a whole snapshot of this version, and for one of a world with
  /// other options but the seed; the world then stays as it was.
  Status restore(const WorldSnapshot& snapshot);
  /// Of everything that the next step depends on; equal in every process and thread for equal inputs.
  std::uint64_t state_hash() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::simulation
