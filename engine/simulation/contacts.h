/// The contacts of one pair of bodies: found box by box, thinned to a few, and given to ODE.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "engine/simulation/ode_handles.h"

namespace trocar::simulation {

/// What a contact is made of.
struct ContactMaterial {
  double friction = 0.4;
  /// Along the finger at the jaws, in W: friction is a pyramid there, true along its axes. None: ODE picks the axes.
  std::optional<Eigen::Vector3d> first_axis;
};

/// Holds at most `kCapacity` contacts between two bodies. Threads: one at a time.
class ContactPatch {
 public:
  void clear() { count_ = 0; }
  /// Adds the contacts of two geoms whose bounding boxes meet, in ODE's order.
  void collide(dGeomID first, dGeomID second);
  bool empty() const { return count_ == 0; }
  /// Keeps at most four contacts of each direction of the normal: the deepest, then those that spread farthest. Solving
  /// grows with the cube of the number, and four points carry a face.
  void thin();
  std::span<const dContactGeom> contacts() const { return {contacts_.data(), static_cast<std::size_t>(count_)}; }
  /// Makes a joint of each contact. `step_s` turns stiffness and damping into ODE's erp and cfm.
  void connect(dWorldID world, dJointGroupID group, const ContactMaterial& material, double step_s) const;

 private:
  static constexpr int kCapacity = 64;
  static constexpr int kPerPair = 8;
  std::array<dContactGeom, kCapacity> contacts_;
  int count_ = 0;
};

}  // namespace trocar::simulation
