#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <memory>

#include "engine/core/check.h"
#include "engine/render/renderer.h"
#include "engine/stage/stage.h"
#include "engine/workbench/studio.h"

namespace {

using namespace trocar;

/// Both arms at the start of a trial, moved up and down a little from frame to frame; blocks on their pegs.
stage::Pose3d pose_at(int frame) {
  stage::Pose3d pose;
  for (const kinematics::ArmSide side : kinematics::kArmSides) {
    spatial::Pose X_WT = kinematics::ready_pose(side);
    X_WT.p.z() -= 0.0002 * (frame % 50);
    const auto joints = kinematics::inverse(kinematics::psm_model(side), X_WT);
    TROCAR_CHECK(joints.has_value());
    pose.joints[kinematics::index_of(side)] = *joints;
    pose.jaw_rad[kinematics::index_of(side)] = 0.35;
  }
  for (int i = 0; i < peg_board::kBlockCount; ++i) {
    pose.blocks[static_cast<std::size_t>(i)].p =
        peg_board::start_peg(i) + Eigen::Vector3d(0.0, 0.0, peg_board::kBlockRest_m);
  }
  return pose;
}

/// Processor time of the whole process, all threads of the renderer.
double process_cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// One iteration is a frame of the real scene: staged, drawn with its shadows and read back. The time is the wall's;
/// the counter is what all threads together spent. The arms move, and the camera too if it circles: then nothing of the
/// picture before can stay.
void frames(benchmark::State& state, const render::RenderOptions& options, bool circling = false) {
  const auto stage = stage::Stage::load();
  TROCAR_CHECK(stage.has_value());
  auto renderer = render::Renderer::create();
  TROCAR_CHECK(renderer.has_value());
  renderer->warm_up();
  scene::Camera camera = scene::camera(scene::CameraPreset::kPaper);
  scene::OrbitCamera orbit = scene::OrbitCamera::from(camera, 0.21);
  int frame = 0;
  TROCAR_CHECK(renderer->draw((*stage)->scene(pose_at(frame), {}, {}, {}), camera, options).has_value());
  std::size_t triangles = 0;
  const double begin_s = process_cpu_s();
  for (auto _ : state) {
    const scene::Scene scene = (*stage)->scene(pose_at(++frame), {}, {}, {});
    if (circling) {
      orbit.orbit(frame % 50 < 25 ? 0.01 : -0.01, 0.0);
      camera = orbit.camera();
    }
    benchmark::DoNotOptimize(renderer->draw(scene, camera, options));
    triangles = 0;
    for (const scene::Node& node : scene.nodes) triangles += node.mesh->indices.size() / 3;
  }
  const double spent_s = process_cpu_s() - begin_s;
  state.counters["cpu_ms"] = 1e3 * spent_s / static_cast<double>(state.iterations());
  state.counters["triangles"] = static_cast<double>(triangles);
}

/// A field that is known in every cell: a cloud in which rays go far.
std::shared_ptr<const learning::Field> cloud() {
  auto field = std::make_shared<learning::Field>();
  const Eigen::Vector3d middle =
      field->grid.p_WGo + Eigen::Vector3d::Constant(0.5 * field->grid.n * field->grid.cell_m);
  for (int s = 0; s < field->grid.cell_count(); ++s) {
    const double r = (field->grid.centre({s}) - middle).norm();
    field->values.push_back(std::exp(-r * r / 2e-4) + 0.2 * std::sin(400.0 * field->grid.centre({s}).x()));
  }
  return field;
}

/// One iteration is a frame of the 3-D view as the window asks for it while the camera circles: staged, drawn, marched
/// through and labelled.
void orbit_field(benchmark::State& state, const workbench::FieldSettings& settings, bool coarse) {
  auto studio = workbench::Studio::create();
  TROCAR_CHECK(studio.has_value());
  workbench::ViewRequest request;
  request.pose = pose_at(0);
  request.fields = {workbench::field_layer(cloud(), settings)};
  request.options.lattice_frame = true;
  request.render = {960, 540, coarse ? 1 : 4, true, !coarse};
  request.coarse = coarse;
  scene::OrbitCamera orbit;
  request.camera = orbit.camera();
  TROCAR_CHECK(studio->picture(request).has_value());
  int frame = 0;
  const double begin_s = process_cpu_s();
  for (auto _ : state) {
    orbit.orbit(++frame % 50 < 25 ? 0.01 : -0.01, 0.0);
    request.camera = orbit.camera();
    benchmark::DoNotOptimize(studio->picture(request));
  }
  state.counters["cpu_ms"] = 1e3 * (process_cpu_s() - begin_s) / static_cast<double>(state.iterations());
  state.counters["frames_hz"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
void volume_orbit_960x540(benchmark::State& state) {
  workbench::FieldSettings settings;
  settings.volume = true;
  orbit_field(state, settings, true);
}
void volume_fine_960x540(benchmark::State& state) {
  workbench::FieldSettings settings;
  settings.volume = true;
  orbit_field(state, settings, false);
}
void slices_orbit_960x540(benchmark::State& state) {
  workbench::FieldSettings settings;
  settings.slices = {11, 11, 11};
  orbit_field(state, settings, true);
}

void render_640x480(benchmark::State& state) {
  frames(state, {640, 480, 1, true, false});
}
void render_960x540(benchmark::State& state) {
  frames(state, {960, 540, 1, true, false});
}
void render_960x540_circling(benchmark::State& state) {
  frames(state, {960, 540, 1, true, false}, true);
}
void render_1280x720_msaa4_circling(benchmark::State& state) {
  frames(state, {1280, 720, 4, true, true}, true);
}
void render_960x540_soft(benchmark::State& state) {
  frames(state, {960, 540, 1, true, true});
}
void render_1280x720_msaa4(benchmark::State& state) {
  frames(state, {1280, 720, 4, true, true});
}
BENCHMARK(render_640x480)->Name("render_640x480")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(render_960x540)->Name("render_960x540")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(render_960x540_circling)->Name("render_960x540_circling")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(render_1280x720_msaa4_circling)
    ->Name("render_1280x720_msaa4_circling")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(render_960x540_soft)->Name("render_960x540_soft")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(render_1280x720_msaa4)->Name("render_1280x720_msaa4")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(volume_orbit_960x540)->Name("volume_orbit_960x540")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(volume_fine_960x540)->Name("volume_fine_960x540")->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(slices_orbit_960x540)->Name("slices_orbit_960x540")->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
