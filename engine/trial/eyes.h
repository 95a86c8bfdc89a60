/// What an operator sees of the world, some time ago.
#pragma once

#include <array>
#include <vector>

#include "engine/simulation/world_state.h"

namespace trocar::trial {

/// One look at the picture.
struct Glimpse {
  std::array<spatial::Pose, 2> X_WT;  ///< Tools, by `kinematics::index_of`.
  std::array<double, 2> jaw_rad{};
  simulation::BlockState block;  ///< The target.

  const spatial::Pose& tool(kinematics::ArmSide side) const { return X_WT[kinematics::index_of(side)]; }
};

/// A delay line of whole samples at 200 Hz. Threads: one at a time.
class Eyes {
 public:
  Eyes(int block, double delay_s);
  /// Takes in the present and returns what is seen now: the past, or the first look as long as there is no older one.
  const Glimpse& look(const simulation::WorldState& present);
  /// Of a tool over the last 50 ms that were seen, m/s.
  double tool_speed_m_s(kinematics::ArmSide side) const;

 private:
  const Glimpse& ago(std::size_t samples) const;

  int block_;
  std::size_t delay_;
  std::vector<Glimpse> ring_;
  std::size_t newest_ = 0;
  std::size_t seen_ = 0;
};

}  // namespace trocar::trial
