/// A body's state to the bit, as ODE holds it: what a snapshot keeps.
#pragma once

#include <array>

#include "engine/simulation/ode_handles.h"

namespace trocar::simulation {

/// In ODE's units. The rotation matrix is kept beside the quaternion: ODE never derives one from the other exactly.
struct BodyBits {
  std::array<dReal, 3> position;
  std::array<dReal, 4> quaternion;
  std::array<dReal, 12> rotation;
  std::array<dReal, 3> linear_velocity;
  std::array<dReal, 3> angular_velocity;
};

BodyBits read_bits(dBodyID body);
void write_bits(dBodyID body, const BodyBits& bits);
/// Finite, a rotation in both forms, within 100 m, 100 m/s and 1000 rad/s: what ODE can be given without harm.
bool plausible(const BodyBits& bits);

}  // namespace trocar::simulation
