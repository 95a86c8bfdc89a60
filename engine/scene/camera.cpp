#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/peg_board/peg_board.h"
#include "engine/scene/scene.h"
#include "engine/spatial/units.h"

namespace trocar::scene {
namespace {

using Eigen::Vector3d;

/// Pixels for each metre at depth 1 (perspective) or anywhere (orthographic).
double pixels_per_unit(const Camera& camera, int height) {
  if (camera.orthographic) return height / camera.orthographic_height_m;
  return 0.5 * height / std::tan(0.5 * camera.vertical_fov_rad);
}

Camera preset_from(const Vector3d& eye, const Vector3d& target, double vertical_fov_rad) {
  Camera camera = Camera::look_at(eye, target);
  camera.vertical_fov_rad = vertical_fov_rad;
  return camera;
}

constexpr double kNarrow_rad = spatial::from_degrees(22.0);
constexpr double kElevationLimit_rad = spatial::from_degrees(89.0);

}  // namespace

Camera Camera::look_at(const Vector3d& eye, const Vector3d& target) {
  const Vector3d forward = (target - eye).normalized();
  Vector3d right = forward.cross(Vector3d::UnitZ());
  // Straight down or up: the viewer stands at +x, so the top of the picture is −x.
  if (right.norm() < 1e-9) right = forward.cross(-Vector3d::UnitX());
  right.normalize();
  Eigen::Matrix3d axes;
  axes << right, forward.cross(right), forward;
  Camera camera;
  camera.X_WC = {eye, Eigen::Quaterniond(axes)};
  return camera;
}

Vector3d Camera::project(const Vector3d& p_W, int width, int height) const {
  const Vector3d p_C = X_WC.inverse() * p_W;
  const double scale = pixels_per_unit(*this, height) / (orthographic ? 1.0 : p_C.z());
  if (!std::isfinite(scale)) return {0.5 * width, 0.5 * height, p_C.z()};
  return {0.5 * width + scale * p_C.x(), 0.5 * height + scale * p_C.y(), p_C.z()};
}

std::array<Vector3d, 2> Camera::ray(double x, double y, int width, int height) const {
  const double scale = pixels_per_unit(*this, height);
  const Vector3d on_plane((x - 0.5 * width) / scale, (y - 0.5 * height) / scale, orthographic ? 0.0 : 1.0);
  if (orthographic) return {X_WC * on_plane, X_WC.q * Vector3d::UnitZ()};
  return {X_WC.p, X_WC.q * on_plane.normalized()};
}

Camera camera(CameraPreset preset) {
  const Vector3d middle(-0.008, 0.0, 0.012);
  switch (preset) {
    case CameraPreset::kPaper: {
      const peg_board::PaperCamera paper = peg_board::paper_camera();
      const Vector3d forward(-std::cos(paper.pitch_rad), 0.0, std::sin(paper.pitch_rad));
      return preset_from(paper.eye, paper.eye + forward, paper.vertical_fov_rad);
    }
    case CameraPreset::kTop:
      return preset_from(middle + Vector3d(0.0, 0.0, 0.33), middle, kNarrow_rad);
    case CameraPreset::kSide:  // From the user's side, where the agent learns.
      return preset_from(middle + Vector3d(0.0, -0.33, 0.095), middle + Vector3d(0.0, 0.0, 0.016), kNarrow_rad);
    case CameraPreset::kFront:
      return preset_from(middle + Vector3d(0.33, 0.0, 0.085), middle + Vector3d(0.0, 0.0, 0.018), kNarrow_rad);
  }
  return {};
}

Camera OrbitCamera::camera() const {
  const Vector3d outward(std::cos(elevation_rad) * std::cos(azimuth_rad),
                         std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad));
  return Camera::look_at(target + distance_m * outward, target);
}

void OrbitCamera::orbit(double d_azimuth_rad, double d_elevation_rad) {
  azimuth_rad = std::remainder(azimuth_rad + d_azimuth_rad, 2.0 * spatial::from_degrees(180.0));
  elevation_rad = std::clamp(elevation_rad + d_elevation_rad, -kElevationLimit_rad, kElevationLimit_rad);
}

void OrbitCamera::pan(double right_m, double up_m) {
  const Eigen::Matrix3d axes = camera().X_WC.rotation();
  target += right_m * axes.col(0) - up_m * axes.col(1);
}

void OrbitCamera::zoom(double factor) {
  distance_m = std::clamp(distance_m * factor, 0.02, 1.0);
}

OrbitCamera OrbitCamera::from(const Camera& camera, double distance_m) {
  const Vector3d forward = camera.X_WC.q * Vector3d::UnitZ();
  OrbitCamera orbit;
  orbit.distance_m = std::clamp(distance_m, 0.02, 1.0);
  orbit.target = camera.X_WC.p + orbit.distance_m * forward;
  orbit.elevation_rad =
      std::clamp(std::asin(std::clamp(-forward.z(), -1.0, 1.0)), -kElevationLimit_rad, kElevationLimit_rad);
  // Seen straight from above the picture's top is forward's continuation.
  const Vector3d ahead =
      std::hypot(forward.x(), forward.y()) > 1e-6 ? forward : Vector3d(camera.X_WC.q * -Vector3d::UnitY());
  orbit.azimuth_rad = std::atan2(-ahead.y(), -ahead.x());
  return orbit;
}

}  // namespace trocar::scene
