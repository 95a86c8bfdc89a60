#include "engine/stage/arm_nodes.h"

#include <algorithm>
#include <numbers>

#include "engine/scene/primitives.h"
#include "engine/spatial/rotation.h"
#include "engine/stage/palette.h"

namespace trocar::stage {
namespace {

using Eigen::Vector3d;

spatial::Pose frame(const Vector3d& origin, const Vector3d& x, const Vector3d& z) {
  Eigen::Matrix3d axes;
  axes << x, z.cross(x), z;
  return {origin, Eigen::Quaterniond(axes).normalized()};
}

}  // namespace

void add_arm(const Meshes& meshes, kinematics::ArmSide side, const kinematics::Joints& joints, double jaw_rad,
             std::vector<scene::Node>& nodes) {
  const kinematics::PsmModel model = kinematics::psm_model(side);
  const auto [p_remote, p_pitch, p_yaw, p_tip] = kinematics::skeleton(model, joints);
  const spatial::Pose X_WT = kinematics::forward(model, joints);
  const Vector3d hinge = X_WT.q * Vector3d::UnitX();
  const Vector3d along_wrist = (p_yaw - p_pitch).normalized();
  const Vector3d along_shaft = (p_pitch - p_remote).normalized();
  const Vector3d pitch_axis = along_wrist.cross(hinge).normalized();

  const spatial::Pose X_WS = frame(p_pitch, pitch_axis.cross(along_shaft), along_shaft);
  const spatial::Pose X_WL = frame(p_pitch, hinge, along_wrist);
  const auto add = [&nodes](const MeshPointer& mesh, const spatial::Pose& pose, const scene::Material& material) {
    nodes.push_back({mesh, material, scene::node_pose(pose)});
  };
  add(meshes.shaft, X_WS, palette::shaft());
  scene::Material fading = palette::shaft();
  fading.base_colour.w() = 0.99F;
  add(meshes.shaft_end, X_WS, fading);
  add(meshes.shaft_pin, X_WS, palette::pin());
  add(meshes.shaft_band, X_WS, palette::material(palette::kArms[kinematics::index_of(side)], 0.5F, 0.0F));
  add(meshes.wrist, X_WL, palette::steel());
  add(meshes.wrist_pin, X_WL, palette::pin());

  const spatial::Pose X_WY{p_yaw, X_WT.q};
  const double half_rad = 0.5 * std::max(jaw_rad, 0.0);
  add(meshes.jaw, X_WY * spatial::Pose{{0, 0, 0}, spatial::about_x(-half_rad)}, palette::steel());
  add(meshes.jaw, X_WY * spatial::Pose{{0, 0, 0}, spatial::about_x(half_rad) * spatial::about_z(std::numbers::pi)},
      palette::steel());
}

}  // namespace trocar::stage
