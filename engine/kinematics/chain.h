/// The arm's chain of joints in modified Denavit–Hartenberg form, shared by the forward and the inverse solution.
#pragma once

#include <Eigen/Core>
#include <array>

#include "engine/kinematics/psm.h"

namespace trocar::kinematics {

/// One row of the table: frame i − 1 to frame i is Rx(alpha) Tx(a) Rz(theta) Tz(d). Every alpha is a quarter turn or
/// none, so its cosine and sine are whole numbers.
struct ChainRow {
  double cos_alpha;
  double sin_alpha;
  double a_m;
  double d_m;        ///< Added to the joint's value if the joint is prismatic.
  double theta_rad;  ///< Added to the joint's value if the joint is revolute.
  bool prismatic;
};
extern const std::array<ChainRow, kJointCount> kChain;

/// How far the wrist-pitch joint lies behind the insertion: 0.4318 − 0.4162 m.
constexpr double kInsertionOffset_m = 0.4318 - 0.4162;
/// From the wrist-pitch to the wrist-yaw joint, in metres.
constexpr double kWrist_m = 0.0091;

/// The orientation and the origin of a frame in B.
struct Frame {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
};
/// X_BL of the frame after `count` joints; 0 is B itself.
Frame frame_after(const Joints& q, int count);
/// Likewise from that after `first` joints on.
Frame frame_after(Frame frame, const Joints& q, int first, int count);

/// The axes of T in the frame of joint 6: x_T = −z, y_T = −x, z_T = y (the dVRK's tool-tip offset).
Eigen::Matrix3d tool_axes();

}  // namespace trocar::kinematics
