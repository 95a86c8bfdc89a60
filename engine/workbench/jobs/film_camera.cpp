#include "engine/workbench/jobs/film_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

double tracked(const film::Source& source, std::string_view property, double film_s, double otherwise) {
  for (const film::Track& track : source.tracks) {
    if (track.property == property) return film::value_at(track.keys, film_s, otherwise);
  }
  return otherwise;
}

scene::OrbitCamera orbit_of(const film::Source& source, double film_s) {
  const CameraPath& path = source.camera;
  scene::OrbitCamera orbit;
  orbit.azimuth_rad = tracked(source, "orbit.yaw", film_s, path.yaw_rad);
  if (path.view == film::View::kTurntable) orbit.azimuth_rad += 2.0 * std::numbers::pi * film_s / path.turn_s;
  orbit.elevation_rad = tracked(source, "orbit.elevation", film_s, path.elevation_rad);
  orbit.distance_m = tracked(source, "orbit.distance", film_s, path.distance_m);
  return orbit;
}

scene::Camera pose_of(const std::vector<CameraKey>& keys, double film_s) {
  const auto vector = [](const std::array<double, 3>& p) { return Eigen::Vector3d(p[0], p[1], p[2]); };
  const auto next =
      std::upper_bound(keys.begin(), keys.end(), film_s, [](double t, const CameraKey& key) { return t < key.t_s; });
  const CameraKey& to = next == keys.end() ? keys.back() : *next;
  const CameraKey& from = next == keys.begin() ? keys.front() : *(next - 1);
  const double span_s = to.t_s - from.t_s;
  const double u = span_s > 0.0 ? film::eased(from.ease, (film_s - from.t_s) / span_s) : 0.0;
  const Eigen::Vector3d eye = (1.0 - u) * vector(from.eye_m) + u * vector(to.eye_m);
  Eigen::Vector3d target = (1.0 - u) * vector(from.target_m) + u * vector(to.target_m);
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
  return opened(looking(source, film_s, p_WT), width, height);
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
