#include "engine/kinematics/chain.h"

#include <cmath>
#include <numbers>

namespace trocar::kinematics {
namespace {

constexpr double kQuarter_rad = std::numbers::pi / 2.0;

}  // namespace

const std::array<ChainRow, kJointCount> kChain{{
    {0.0, 1.0, 0.0, 0.0, kQuarter_rad, false},
    {0.0, -1.0, 0.0, 0.0, -kQuarter_rad, false},
    {0.0, 1.0, 0.0, -0.4318, 0.0, true},
    {1.0, 0.0, 0.0, 0.4162, 0.0, false},
    {0.0, -1.0, 0.0, 0.0, -kQuarter_rad, false},
    {0.0, -1.0, kWrist_m, 0.0, -kQuarter_rad, false},
}};

Frame frame_after(const Joints& q, int count) {
  return frame_after(Frame{}, q, 0, count);
}

Frame frame_after(Frame frame, const Joints& q, int first, int count) {
  for (int i = first; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const ChainRow& row = kChain[k];
    const double theta = row.theta_rad + (row.prismatic ? 0.0 : q[k]);
    const double d = row.d_m + (row.prismatic ? q[k] : 0.0);
    const double c = std::cos(theta);
    const double s = std::sin(theta);
    const Eigen::Vector3d x = frame.R.col(0);
    const Eigen::Vector3d y = row.cos_alpha * frame.R.col(1) + row.sin_alpha * frame.R.col(2);
    const Eigen::Vector3d z = row.cos_alpha * frame.R.col(2) - row.sin_alpha * frame.R.col(1);
    frame.p += row.a_m * x + d * z;
    frame.R.col(0) = c * x + s * y;
    frame.R.col(1) = c * y - s * x;
    frame.R.col(2) = z;
  }
  return frame;
}

Eigen::Matrix3d tool_axes() {
  Eigen::Matrix3d R;
  R << 0, -1, 0, 0, 0, 1, -1, 0, 0;
  return R;
}

}  // namespace trocar::kinematics
