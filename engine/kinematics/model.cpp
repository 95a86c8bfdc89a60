#include "engine/core/check.h"
#include "engine/kinematics/psm.h"
#include "engine/spatial/rotation.h"
#include "engine/spatial/units.h"

namespace trocar::kinematics {

using spatial::from_degrees;

std::string_view joint_name(int joint) {
  static constexpr std::array<std::string_view, kJointCount> kNames{"yaw",  "pitch",       "insertion",
                                                                    "roll", "wrist pitch", "wrist yaw"};
  TROCAR_CHECK(joint >= 0 && joint < kJointCount);
  return kNames[static_cast<std::size_t>(joint)];
}

PsmModel psm_model(ArmSide side) {
  const bool left = side == ArmSide::kLeft;
  const auto symmetric = [](double degrees) { return JointLimit{from_degrees(-degrees), from_degrees(degrees)}; };
  PsmModel model;
  model.X_WB.p = {-0.04293, left ? -0.07364 : 0.07364, 0.15530};
  model.X_WB.q = spatial::about_z(from_degrees(left ? -70.0 : -110.0));
  model.limits = {symmetric(91.0),  symmetric(53.0), JointLimit{0.0, 0.240},
                  symmetric(260.0), symmetric(80.0), symmetric(80.0)};
  model.jaw = {from_degrees(-40.0), from_degrees(80.0)};
  return model;
}

Eigen::Quaterniond pointing_down(double yaw_rad) {
  const Eigen::Quaterniond half_turn_about_x(0.0, 1.0, 0.0, 0.0);
  return spatial::about_z(yaw_rad) * half_turn_about_x;
}

spatial::Pose ready_pose(ArmSide side) {
  return {{-0.010, side == ArmSide::kLeft ? -0.022 : 0.022, 0.050}, pointing_down(0.0)};
}

}  // namespace trocar::kinematics
