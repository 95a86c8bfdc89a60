#include "engine/simulation/body_bits.h"

#include <algorithm>
#include <cmath>

namespace trocar::simulation {

BodyBits read_bits(dBodyID body) {
  BodyBits bits;
  std::copy_n(dBodyGetPosition(body), 3, bits.position.begin());
  std::copy_n(dBodyGetQuaternion(body), 4, bits.quaternion.begin());
  std::copy_n(dBodyGetRotation(body), 12, bits.rotation.begin());
  std::copy_n(dBodyGetLinearVel(body), 3, bits.linear_velocity.begin());
  std::copy_n(dBodyGetAngularVel(body), 3, bits.angular_velocity.begin());
  return bits;
}

void write_bits(dBodyID body, const BodyBits& bits) {
  dBodySetPosition(body, bits.position[0], bits.position[1], bits.position[2]);
  const dQuaternion quaternion = {bits.quaternion[0], bits.quaternion[1], bits.quaternion[2], bits.quaternion[3]};
  dBodySetQuaternion(body, quaternion);
  // The setter renormalises and derives the matrix anew; only the very bits continue the very motion.
  std::copy(bits.quaternion.begin(), bits.quaternion.end(), const_cast<dReal*>(dBodyGetQuaternion(body)));
  std::copy(bits.rotation.begin(), bits.rotation.end(), const_cast<dReal*>(dBodyGetRotation(body)));
  dBodySetLinearVel(body, bits.linear_velocity[0], bits.linear_velocity[1], bits.linear_velocity[2]);
  dBodySetAngularVel(body, bits.angular_velocity[0], bits.angular_velocity[1], bits.angular_velocity[2]);
}

bool plausible(const BodyBits& bits) {
  const auto small = [](double limit) { return [limit](double x) { return std::abs(x) <= limit; }; };  // NaN is not
  constexpr double kFar = 100.0 * kOdeLength;
  if (!std::all_of(bits.position.begin(), bits.position.end(), small(kFar))) return false;
  if (!std::all_of(bits.linear_velocity.begin(), bits.linear_velocity.end(), small(kFar))) return false;
  if (!std::all_of(bits.angular_velocity.begin(), bits.angular_velocity.end(), small(1000.0))) return false;
  const Eigen::Quaterniond q(bits.quaternion[0], bits.quaternion[1], bits.quaternion[2], bits.quaternion[3]);
  if (!(std::abs(q.norm() - 1.0) <= 1e-9)) return false;
  const Eigen::Matrix3d R = q.toRotationMatrix();
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const auto at = [](std::size_t index) { return static_cast<Eigen::Index>(index); };
      const double expected = column < 3 ? R(at(row), at(column)) : 0.0;
      if (!(std::abs(bits.rotation[4 * row + column] - expected) <= 1e-9)) return false;
    }
  }
  return true;
}

}  // namespace trocar::simulation
