#include "engine/core/check.h"
#include "engine/kinematics/chain.h"

namespace trocar::kinematics {
namespace {

spatial::Pose in_world(const PsmModel& model, const Eigen::Matrix3d& R_BL, const Eigen::Vector3d& p_BL) {
  return model.X_WB * spatial::Pose{p_BL, Eigen::Quaterniond(R_BL).normalized()};
}

}  // namespace

spatial::Pose forward(const PsmModel& model, const Joints& q) {
  const Frame wrist = frame_after(q, kJointCount);
  return in_world(model, wrist.R * tool_axes(), wrist.p + kTipFromWrist_m * wrist.R.col(1));
}

spatial::Pose wrist_pose(const spatial::Pose& X_WT) {
  return {X_WT * Eigen::Vector3d(0.0, 0.0, -kTipFromWrist_m), X_WT.q};
}

std::array<Eigen::Vector3d, 4> skeleton(const PsmModel& model, const Joints& q) {
  const Frame wrist_pitch = frame_after(q, kJointCount - 1);
  const Frame wrist_yaw = frame_after(wrist_pitch, q, kJointCount - 1, kJointCount);
  const Eigen::Vector3d p_BT = wrist_yaw.p + kTipFromWrist_m * wrist_yaw.R.col(1);
  return {model.X_WB.p, model.X_WB * wrist_pitch.p, model.X_WB * wrist_yaw.p, model.X_WB * p_BT};
}

spatial::Pose joint_frame(const PsmModel& model, const Joints& q, int joint) {
  TROCAR_CHECK(joint >= 0 && joint < kJointCount);
  const Frame frame = frame_after(q, joint + 1);
  return in_world(model, frame.R, frame.p);
}

}  // namespace trocar::kinematics
