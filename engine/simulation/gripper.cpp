#include "engine/simulation/gripper.h"

#include <algorithm>
#include <cmath>

#include "engine/simulation/shapes.h"

namespace trocar::simulation {
namespace {

using kinematics::kTipFromWrist_m;
using spatial::Pose;

constexpr double kJawMass_kg = 0.0005;
constexpr double kServoStiffness_nm_per_rad = 1.0;
constexpr double kServoDamping_nm_s_per_rad = 0.003;

/// +1 for jaw 0, which lies at +y_T, −1 for jaw 1.
double side_of(std::size_t jaw) {
  return jaw == 0 ? 1.0 : -1.0;
}

Pose base_pose(const ArmPosture& posture) {
  return kinematics::wrist_pose(posture.X_WT);
}

Pose link_pose(const ArmPosture& posture, std::size_t link) {
  const Eigen::Vector3d& low = posture.skeleton[2 - link];
  const Eigen::Vector3d& high = posture.skeleton[1 - link];
  return {0.5 * (low + high), Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), high - low)};
}

OdeBody make_kinematic(dWorldID world) {
  OdeBody body(dBodyCreate(world));
  dBodySetKinematic(body.get());
  dBodySetFiniteRotationMode(body.get(), 1);
  return body;
}

Jaw make_jaw(dWorldID world, dBodyID base, std::size_t index) {
  const Eigen::Vector3d size = Eigen::Vector3d(kJawWidth_m, kJawThickness_m, kTipFromWrist_m) * kOdeLength;
  Jaw jaw;
  jaw.body.reset(dBodyCreate(world));
  dBodySetFiniteRotationMode(jaw.body.get(), 1);
  dBodySetGravityMode(jaw.body.get(), 0);
  dMass mass;
  dMassSetBoxTotal(&mass, kJawMass_kg * kOdeMass, size.x(), size.y(), size.z());
  dBodySetMass(jaw.body.get(), &mass);
  jaw.box.reset(dCreateBox(nullptr, size.x(), size.y(), size.z()));
  dGeomSetBody(jaw.box.get(), jaw.body.get());
  // Hinged at the origin with the base unturned: the joint's constants are then the same in every world.
  set_pose(jaw.body.get(), jaw_pose(index, 0.0));
  jaw.hinge.reset(dJointCreateHinge(world, nullptr));
  dJointAttach(jaw.hinge.get(), jaw.body.get(), base);
  dJointSetHingeAnchor(jaw.hinge.get(), 0.0, 0.0, 0.0);
  dJointSetHingeAxis(jaw.hinge.get(), -side_of(index), 0.0, 0.0);
  return jaw;
}

}  // namespace

Gripper make_gripper(dWorldID world) {
  Gripper gripper;
  gripper.base = make_kinematic(world);
  for (std::size_t i = 0; i < 2; ++i) gripper.jaws[i] = make_jaw(world, gripper.base.get(), i);
  const std::array<double, 2> lengths_m{0.0091, 0.240};
  const std::array<double, 2> radii_m{kWristRadius_m, kShaftRadius_m};
  for (std::size_t i = 0; i < 2; ++i) {
    Link& link = gripper.links[i];
    link.body = make_kinematic(world);
    link.capsule.reset(dCreateCapsule(nullptr, radii_m[i] * kOdeLength, lengths_m[i] * kOdeLength));
    dGeomSetBody(link.capsule.get(), link.body.get());
  }
  return gripper;
}

void settle(const Gripper& gripper, const ArmPosture& posture) {
  set_pose(gripper.base.get(), base_pose(posture));
  for (std::size_t i = 0; i < 2; ++i) {
    const Link& link = gripper.links[i];
    set_pose(link.body.get(), link_pose(posture, i));
    const double length = (posture.skeleton[2 - i] - posture.skeleton[1 - i]).norm() * kOdeLength;
    dReal radius = 0.0;
    dReal old_length = 0.0;
    dGeomCapsuleGetParams(link.capsule.get(), &radius, &old_length);
    if (length != old_length) dGeomCapsuleSetParams(link.capsule.get(), radius, length);
  }
}

void place(const Gripper& gripper, const ArmPosture& posture, double jaw_rad) {
  settle(gripper, posture);
  set_motion(gripper, posture, posture, 1.0);
  for (std::size_t i = 0; i < 2; ++i) {
    dBodyID body = gripper.jaws[i].body.get();
    set_pose(body, base_pose(posture) * jaw_pose(i, jaw_rad / 2.0));
    dBodySetLinearVel(body, 0.0, 0.0, 0.0);
    dBodySetAngularVel(body, 0.0, 0.0, 0.0);
  }
}

void set_motion(const Gripper& gripper, const ArmPosture& from, const ArmPosture& to, double duration_s) {
  set_motion(gripper.base.get(), base_pose(from), base_pose(to), duration_s);
  for (std::size_t i = 0; i < 2; ++i) {
    set_motion(gripper.links[i].body.get(), link_pose(from, i), link_pose(to, i), duration_s);
  }
}

double opening(const Gripper& gripper) {
  return dJointGetHingeAngle(gripper.jaws[0].hinge.get()) + dJointGetHingeAngle(gripper.jaws[1].hinge.get());
}

void drive_jaws(const Gripper& gripper, double jaw_rad, double torque_nm, double step_s) {
  const double reach_rad = 2.0 * torque_nm / kServoStiffness_nm_per_rad;
  const double measured_rad = opening(gripper);
  const double target_rad = std::max(0.0, std::clamp(jaw_rad, measured_rad - reach_rad, measured_rad + reach_rad));
  const double hk = step_s * kServoStiffness_nm_per_rad;
  const double erp = hk / (hk + kServoDamping_nm_s_per_rad);
  const double cfm = 1.0 / ((hk + kServoDamping_nm_s_per_rad) * kOdeTorsionalStiffness);
  for (const Jaw& jaw : gripper.jaws) {
    dJointID hinge = jaw.hinge.get();
    dJointSetHingeParam(hinge, dParamLoStop, target_rad / 2.0);
    dJointSetHingeParam(hinge, dParamHiStop, target_rad / 2.0);
    dJointSetHingeParam(hinge, dParamStopERP, erp);
    dJointSetHingeParam(hinge, dParamStopCFM, cfm);
  }
}

void pause(const Gripper& gripper) {
  dBodyDisable(gripper.base.get());
  for (const Link& link : gripper.links) dBodyDisable(link.body.get());
  for (const Jaw& jaw : gripper.jaws) {
    dBodySetLinearVel(jaw.body.get(), 0.0, 0.0, 0.0);
    dBodySetAngularVel(jaw.body.get(), 0.0, 0.0, 0.0);
    dBodyDisable(jaw.body.get());
  }
}

void resume(const Gripper& gripper) {
  dBodyEnable(gripper.base.get());
  for (const Link& link : gripper.links) dBodyEnable(link.body.get());
  for (const Jaw& jaw : gripper.jaws) dBodyEnable(jaw.body.get());
}

bool jaws_settled(const Gripper& gripper, double jaw_rad) {
  constexpr double kSettled_rad = 1e-4;
  constexpr double kSettled_rad_s = 0.01;
  if (std::abs(opening(gripper) - std::max(0.0, jaw_rad)) > kSettled_rad) return false;
  return std::all_of(gripper.jaws.begin(), gripper.jaws.end(), [](const Jaw& jaw) {
    return std::abs(dJointGetHingeAngleRate(jaw.hinge.get())) < kSettled_rad_s &&
           kOdeLength * from_ode(dBodyGetLinearVel(jaw.body.get())).norm() < kSettled_rad_s;
  });
}

Eigen::Vector3d finger_direction(const Jaw& jaw) {
  const dReal* R = dBodyGetRotation(jaw.body.get());
  return {R[2], R[6], R[10]};
}

}  // namespace trocar::simulation
