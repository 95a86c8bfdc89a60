/// The dVRK patient-side manipulator with a large needle driver: model, forward and closed-form inverse kinematics.
#pragma once

#include <array>
#include <string_view>

#include "engine/core/result.h"
#include "engine/spatial/pose.h"

namespace trocar::kinematics {

/// Left is PSM2, the user's arm; right is PSM1, the assistant's.
enum class ArmSide { kLeft, kRight };
constexpr std::array<ArmSide, 2> kArmSides{ArmSide::kLeft, ArmSide::kRight};
constexpr std::size_t index_of(ArmSide side) {
  return side == ArmSide::kLeft ? 0 : 1;
}

constexpr int kJointCount = 6;
/// q1 yaw, q2 pitch, q3 insertion, q4 roll, q5 wrist pitch, q6 wrist yaw: radians, q3 in metres.
using Joints = std::array<double, kJointCount>;
/// "yaw" … "wrist yaw".
std::string_view joint_name(int joint);

struct JointLimit {
  double low;
  double high;
};

/// From the wrist-yaw joint (the dVRK's `measured_cp`) to the tool tip T along the jaw, in metres.
constexpr double kTipFromWrist_m = 0.0102;

/// One arm on its base.
///
/// Frames: W the board; B the arm's base at its remote centre of motion; T the tool tip: z_T out along the closed jaws,
/// x_T the jaws' hinge axis (−z of joint 6), y_T the direction in which the jaws open.
struct PsmModel {
  spatial::Pose X_WB;
  std::array<JointLimit, kJointCount> limits;
  JointLimit jaw;  ///< −40° … 80°, the dVRK's; commanded below contact to grip.
};

/// The arm where SurRoL's scene has it (task, "Scene").
PsmModel psm_model(ArmSide side);

/// X_WT of the tool tip.
spatial::Pose forward(const PsmModel& model, const Joints& q);
/// X_WY of the wrist-yaw joint, axes as T: what the dVRK reports as `measured_cp`.
spatial::Pose wrist_pose(const spatial::Pose& X_WT);
/// Origins in W of: the remote centre, the wrist-pitch joint, the wrist-yaw joint, the tip; for drawing the arm.
std::array<Eigen::Vector3d, 4> skeleton(const PsmModel& model, const Joints& q);
/// X_WL of the frame after joint `joint` (0-based), modified DH; for drawing the arm's parts.
spatial::Pose joint_frame(const PsmModel& model, const Joints& q, int joint);

/// The joints that put the tip at X_WT, inside the limits.
/// Errors: kInvalidArgument if the pose is not finite; kOutOfReach naming the joint and by how much it is beyond.
Result<Joints> inverse(const PsmModel& model, const spatial::Pose& X_WT);

/// Nothing if all joints are inside; else which joint is beyond which limit by how much, in degrees or millimetres.
Status check_limits(const PsmModel& model, const Joints& q);

/// Jaws pointing straight down, hinge axis along x rotated by `yaw_rad` about z: the tool's usual orientation.
Eigen::Quaterniond pointing_down(double yaw_rad);

/// The tips' poses at the start of a trial: (−10, ∓22, 50) mm, jaws straight down.
spatial::Pose ready_pose(ArmSide side);

}  // namespace trocar::kinematics
