#include <doctest/doctest.h>

#include <cmath>

#include "engine/peg_board/peg_board.h"
#include "engine/scene/scene.h"
#include "engine/spatial/units.h"

using namespace trocar;
using Eigen::Vector3d;

namespace {

constexpr int kWidth = 960;
constexpr int kHeight = 540;

constexpr scene::CameraPreset kPresets[] = {scene::CameraPreset::kPaper, scene::CameraPreset::kTop,
                                            scene::CameraPreset::kSide, scene::CameraPreset::kFront};

}  // namespace

TEST_CASE("the paper's camera is where the paper's scene has it and looks 30 degrees down") {
  const scene::Camera camera = scene::camera(scene::CameraPreset::kPaper);
  CHECK((camera.X_WC.p - Vector3d(0.1015, 0.0, 0.0829)).norm() < 1e-12);
  const Vector3d forward = camera.X_WC.q * Vector3d::UnitZ();
  CHECK(spatial::to_degrees(std::asin(forward.z())) == doctest::Approx(-30.0));
  CHECK(forward.x() < 0.0);
  CHECK(std::abs(forward.y()) < 1e-12);
  CHECK(spatial::to_degrees(camera.vertical_fov_rad) == doctest::Approx(45.0));
}

TEST_CASE("in the paper's view and from the top, y is to the right; z is up in all but the top view") {
  for (const scene::CameraPreset preset : kPresets) {
    const scene::Camera camera = scene::camera(preset);
    const Vector3d middle = camera.project({-0.01, 0.0, 0.01}, kWidth, kHeight);
    const Vector3d right = camera.project({-0.01, 0.01, 0.01}, kWidth, kHeight);
    const Vector3d above = camera.project({-0.01, 0.0, 0.02}, kWidth, kHeight);
    if (preset != scene::CameraPreset::kSide) CHECK(right.x() > middle.x() + 5.0);
    if (preset != scene::CameraPreset::kTop) CHECK(above.y() < middle.y() - 5.0);
  }
  const scene::Camera top = scene::camera(scene::CameraPreset::kTop);
  const double far_row = top.project({-0.03, 0.0, 0.0}, kWidth, kHeight).y();
  CHECK(far_row < top.project({0.03, 0.0, 0.0}, kWidth, kHeight).y());
}

TEST_CASE("every peg is inside of every preset's picture") {
  for (const scene::CameraPreset preset : kPresets) {
    const scene::Camera camera = scene::camera(preset);
    for (int i = 0; i < peg_board::kBlockCount; ++i) {
      for (const Vector3d& foot : {peg_board::start_peg(i), peg_board::goal_peg(i)}) {
        const Vector3d tip = camera.project(foot + Vector3d(0.0, 0.0, peg_board::kPegHeight_m), kWidth, kHeight);
        CHECK(tip.z() > camera.near_m);
        CHECK(tip.x() > 20.0);
        CHECK(tip.x() < kWidth - 20.0);
        CHECK(tip.y() > 20.0);
        CHECK(tip.y() < kHeight - 20.0);
      }
    }
  }
}

TEST_CASE("a ray through the pixel of a point passes through the point") {
  for (const bool orthographic : {false, true}) {
    scene::Camera camera = scene::Camera::look_at({0.1, 0.05, 0.2}, {-0.01, 0.0, 0.0});
    camera.orthographic = orthographic;
    for (const Vector3d& point : {Vector3d(0.0, 0.0, 0.0), Vector3d(-0.02, 0.03, 0.02), Vector3d(0.01, -0.03, 0.05)}) {
      const Vector3d pixel = camera.project(point, kWidth, kHeight);
      const auto [origin, direction] = camera.ray(pixel.x(), pixel.y(), kWidth, kHeight);
      const Vector3d offset = point - origin;
      CHECK(direction.norm() == doctest::Approx(1.0));
      CHECK((offset - direction * direction.dot(offset)).norm() < 1e-12);
      CHECK(direction.dot(offset) > 0.0);
    }
  }
}

TEST_CASE("a point behind the camera has no positive depth") {
  const scene::Camera camera = scene::camera(scene::CameraPreset::kPaper);
  CHECK(camera.project({0.3, 0.0, 0.1}, kWidth, kHeight).z() <= 0.0);
  CHECK(camera.project(camera.X_WC.p, kWidth, kHeight).allFinite());
}

TEST_CASE("an orbit camera stays at its distance and its target stays in the middle") {
  scene::OrbitCamera orbit;
  orbit.distance_m = 0.24;
  orbit.orbit(1.0, 0.2);
  orbit.pan(0.01, -0.02);
  orbit.zoom(0.5);
  const scene::Camera camera = orbit.camera();
  CHECK((camera.X_WC.p - orbit.target).norm() == doctest::Approx(0.12));
  const Vector3d pixel = camera.project(orbit.target, kWidth, kHeight);
  CHECK(pixel.x() == doctest::Approx(kWidth / 2.0));
  CHECK(pixel.y() == doctest::Approx(kHeight / 2.0));
}

TEST_CASE("panning to the right moves what is seen to the left") {
  scene::OrbitCamera orbit;
  const Vector3d before = orbit.camera().project({0.0, 0.0, 0.0}, kWidth, kHeight);
  orbit.pan(0.01, 0.01);
  const Vector3d after = orbit.camera().project({0.0, 0.0, 0.0}, kWidth, kHeight);
  CHECK(after.x() < before.x());
  CHECK(after.y() > before.y());
}

TEST_CASE("an orbit camera cannot turn over the pole nor fly through its target") {
  scene::OrbitCamera orbit;
  orbit.orbit(0.0, 10.0);
  CHECK(orbit.elevation_rad < spatial::from_degrees(90.0));
  for (int i = 0; i < 100; ++i) orbit.zoom(0.5);
  CHECK(orbit.distance_m == doctest::Approx(0.02));
  for (int i = 0; i < 100; ++i) orbit.zoom(2.0);
  CHECK(orbit.distance_m == doctest::Approx(1.0));
}

TEST_CASE("an orbit camera made from a preset shows the preset's view") {
  for (const scene::CameraPreset preset : kPresets) {
    const scene::Camera camera = scene::camera(preset);
    const scene::Camera again = scene::OrbitCamera::from(camera, 0.2).camera();
    CHECK((again.X_WC.p - camera.X_WC.p).norm() < 5e-3);  // From the top the orbit stops at 89°, 3.5 mm off at 0.2 m.
    CHECK(spatial::angle_between(again.X_WC.q, camera.X_WC.q) < spatial::from_degrees(1.01));
  }
}
