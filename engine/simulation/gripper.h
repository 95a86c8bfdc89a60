/// One arm in ODE: a kinematic gripper with two dynamic jaws on torque-limited servos, and its kinematic shaft.
#pragma once

#include <array>

#include "engine/kinematics/psm.h"
#include "engine/simulation/ode_handles.h"

namespace trocar::simulation {

/// The middle of a jaw that sits on its hinge is nearer to the tool tip than this, however far it is opened.
constexpr double kJawFromTip_m = 0.017;

struct Jaw {
  OdeBody body;
  OdeJoint hinge;
  OdeGeom box;
};

/// A capsule of the shaft that pushes blocks but is pushed by nothing.
struct Link {
  OdeBody body;
  OdeGeom capsule;
};

/// Frames: the gripper's body is at the wrist-yaw joint with the axes of T; jaw 0 is on the side of +y_T.
struct Gripper {
  OdeBody base;
  std::array<Jaw, 2> jaws;
  std::array<Link, 2> links;  ///< From wrist yaw to wrist pitch; from there to the remote centre.
};
Gripper make_gripper(dWorldID world);

/// Where an arm is at one instant: what the bodies of a gripper follow.
struct ArmPosture {
  spatial::Pose X_WT;
  std::array<Eigen::Vector3d, 4> skeleton;  ///< `kinematics::skeleton`.
};

/// Puts gripper, jaws and shaft at a posture, the jaws at half the opening each, all at rest.
void place(const Gripper& gripper, const ArmPosture& posture, double jaw_rad);
/// Gives the kinematic parts the velocity from one posture to the other.
void set_motion(const Gripper& gripper, const ArmPosture& from, const ArmPosture& to, double duration_s);
/// Puts the kinematic parts exactly where they belong after a step; the jaws are left where the physics put them.
void settle(const Gripper& gripper, const ArmPosture& posture);

/// The opening between the jaws, in radians.
double opening(const Gripper& gripper);
/// Drives the jaws towards the opening `jaw_rad` with at most `torque_nm` each. The opening as a whole is clamped, not
/// each jaw: clamped one by one, both would creep to the side where something pushes.
void drive_jaws(const Gripper& gripper, double jaw_rad, double torque_nm, double step_s);

/// Stops the jaws where they are and leaves the whole gripper out of the next steps, until `resume`. It saves their
/// constraints for an arm that stands still and touches nothing.
void pause(const Gripper& gripper);
void resume(const Gripper& gripper);
/// Whether the jaws have come to rest at the opening `jaw_rad`.
bool jaws_settled(const Gripper& gripper, double jaw_rad);

/// The direction out along a jaw, in W.
Eigen::Vector3d finger_direction(const Jaw& jaw);

}  // namespace trocar::simulation
