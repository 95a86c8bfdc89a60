#include "engine/workbench/jobs/film_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/film/property.h"

namespace trocar::workbench {
namespace {

using film::CameraKey;
using film::CameraPath;

scene::Camera opened(scene::Camera camera, int width, int height) {
  constexpr double kDesigned = 16.0 / 9.0;
  const double aspect = static_cast<double>(width) / height;
  if (aspect < kDesigned) {
    camera.vertical_fov_rad = 2.0 * std::atan(std::tan(0.5 * camera.vertical_fov_rad) * kDesigned / aspect);
    camera.orthographic_height_m *= kDesigned / aspect;
  }
  return camera;
}

scene::Camera zoomed(scene::Camera camera, double zoom) {
  camera.vertical_fov_rad = 2.0 * std::atan(std::tan(0.5 * camera.vertical_fov_rad) / zoom);
  camera.orthographic_height_m /= zoom;
  return camera;
}

scene::OrbitCamera orbit_of(const film::Source& source, double film_s) {
  const CameraPath& path = source.camera;
  scene::OrbitCamera orbit;
  orbit.azimuth_rad = film::value_of(source, "orbit.yaw", film_s);
  if (path.view == film::View::kTurntable) orbit.azimuth_rad += 2.0 * std::numbers::pi * film_s / path.turn_s;
  orbit.elevation_rad = film::value_of(source, "orbit.elevation", film_s);
  orbit.distance_m = film::value_of(source, "orbit.distance", film_s);
  return orbit;
}

/// Of the eye or of what it looks at.
using PointOf = std::array<double, 3> CameraKey::*;

Eigen::Vector3d point(const CameraKey& key, PointOf of) {
  return {(key.*of)[0], (key.*of)[1], (key.*of)[2]};
}

/// Catmull and Rom's: through each key as the way from the key before to the one after it.
Eigen::Vector3d along_spline(const std::vector<CameraKey>& keys, std::size_t i, double u, PointOf of) {
  const auto velocity = [&](std::size_t at) -> Eigen::Vector3d {
    if (at == 0 || at + 1 == keys.size()) return Eigen::Vector3d::Zero();
    return (point(keys[at + 1], of) - point(keys[at - 1], of)) / (keys[at + 1].t_s - keys[at - 1].t_s);
  };
  const double span_s = keys[i + 1].t_s - keys[i].t_s;
  const double rise = u * u * (3.0 - 2.0 * u);
  return (1.0 - rise) * point(keys[i], of) + rise * point(keys[i + 1], of) +
         span_s * (u * (1.0 - u) * (1.0 - u) * velocity(i) - u * u * (1.0 - u) * velocity(i + 1));
}

Eigen::Vector3d between_keys(const std::vector<CameraKey>& keys, std::size_t i, double film_s, PointOf of) {
  const CameraKey& from = keys[i];
  const double u = std::clamp((film_s - from.t_s) / (keys[i + 1].t_s - from.t_s), 0.0, 1.0);
  if (from.ease == film::Ease::kSpline) return along_spline(keys, i, u, of);
  const double share = film::eased(from.ease, u);
  return (1.0 - share) * point(from, of) + share * point(keys[i + 1], of);
}

scene::Camera pose_of(const std::vector<CameraKey>& keys, double film_s) {
  const auto next =
      std::upper_bound(keys.begin(), keys.end(), film_s, [](double t, const CameraKey& key) { return t < key.t_s; });
  const bool moves = next != keys.begin() && next != keys.end();
  const CameraKey& still = next == keys.begin() ? keys.front() : keys.back();
  const std::size_t from = moves ? static_cast<std::size_t>(next - keys.begin()) - 1 : 0;
  const Eigen::Vector3d eye =
      moves ? between_keys(keys, from, film_s, &CameraKey::eye_m) : point(still, &CameraKey::eye_m);
  Eigen::Vector3d target =
      moves ? between_keys(keys, from, film_s, &CameraKey::target_m) : point(still, &CameraKey::target_m);
  // Between two poses the eye may come upon what it looks at.
  if ((target - eye).norm() < 1e-6) target = eye + Eigen::Vector3d(-1e-3, 0.0, 0.0);
  return scene::Camera::look_at(eye, target);
}

scene::Camera looking(const film::Source& source, double film_s, const Eigen::Vector3d& p_WT) {
  switch (source.camera.view) {
    case film::View::kPaper:
      return scene::camera(scene::CameraPreset::kPaper);
    case film::View::kTop:
      return scene::camera(scene::CameraPreset::kTop);
    case film::View::kSide:
      return scene::camera(scene::CameraPreset::kSide);
    case film::View::kFront:
      return scene::camera(scene::CameraPreset::kFront);
    case film::View::kOrbit:
    case film::View::kTurntable:
      return orbit_of(source, film_s).camera();
    case film::View::kPoses:
      return pose_of(source.camera.keys, film_s);
    case film::View::kFollow:
      break;
  }
  scene::OrbitCamera orbit = orbit_of(source, film_s);
  orbit.target = p_WT;
  return orbit.camera();
}

}  // namespace

scene::Camera film_camera(const film::Source& source, double film_s, const Eigen::Vector3d& p_WT, int width,
                          int height) {
  const scene::Camera camera = zoomed(looking(source, film_s, p_WT), film::value_of(source, "zoom", film_s));
  return opened(camera, width, height);
}

film::View film_view(scene::CameraPreset preset) {
  switch (preset) {
    case scene::CameraPreset::kTop:
      return film::View::kTop;
    case scene::CameraPreset::kSide:
      return film::View::kSide;
    case scene::CameraPreset::kFront:
      return film::View::kFront;
    case scene::CameraPreset::kPaper:
      break;
  }
  return film::View::kPaper;
}

}  // namespace trocar::workbench
