#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>

#include "engine/core/file.h"
#include "engine/demonstration/segment_colour.h"
#include "engine/media/picture_file.h"
#include "engine/render/renderer.h"
#include "engine/stage/stage.h"

// Pictures against tests/golden/*.png. Run with TROCAR_BLESS=1 to write them anew, look at them, and say why.

using namespace trocar;
using Eigen::Vector3d;

namespace {

// Pictures were the same to the byte on one CPU; another one may round an edge pixel differently.
constexpr double kMeanLimit = 0.25;
constexpr int kWorstLimit = 64;

render::Renderer& renderer() {
  static Result<render::Renderer> made = render::Renderer::create();
  REQUIRE(made);
  return *made;
}

const stage::Stage& loaded() {
  static const Result<std::shared_ptr<const stage::Stage>> kStage = stage::Stage::load();
  REQUIRE(kStage);
  return **kStage;
}

stage::Pose3d ready() {
  stage::Pose3d pose;
  for (const kinematics::ArmSide side : kinematics::kArmSides) {
    const auto joints = kinematics::inverse(kinematics::psm_model(side), kinematics::ready_pose(side));
    REQUIRE(joints);
    pose.joints[kinematics::index_of(side)] = *joints;
    pose.jaw_rad[kinematics::index_of(side)] = 0.35;
  }
  for (int i = 0; i < peg_board::kBlockCount; ++i) {
    spatial::Pose& X_WK = pose.blocks[static_cast<std::size_t>(i)];
    X_WK.p = peg_board::start_peg(i) + Vector3d(0.0, 0.0, peg_board::kBlockRest_m);
    X_WK.q = Eigen::Quaterniond(Eigen::AngleAxisd(0.15 * i - 0.4, Vector3d::UnitZ()));
  }
  return pose;
}

/// A bell about a point, unknown far from it.
stage::FieldLayer bell() {
  auto field = std::make_shared<learning::Field>();
  for (int s = 0; s < field->grid.cell_count(); ++s) {
    const double r = (field->grid.centre({s}) - Vector3d(-0.010, -0.020, 0.030)).norm();
    field->values.push_back(r < 0.028 ? std::exp(-r * r / 3e-4) : std::numeric_limits<double>::quiet_NaN());
  }
  stage::FieldLayer layer;
  layer.field = field;
  return layer;
}

stage::PathLayer spiral() {
  stage::PathLayer path;
  for (int i = 0; i < 1000; ++i) {
    const double t = 0.01 * i;
    path.points.emplace_back(-0.01 + 0.015 * std::cos(t), -0.025 + 0.015 * std::sin(t), 0.012 + 0.004 * t);
    path.colours.push_back(demonstration::segment_colour(static_cast<demonstration::Segment>(i / 200)));
  }
  return path;
}

void compare(const std::string& name, const scene::Scene& scene, scene::CameraPreset preset) {
  const Result<Image> image = renderer().draw(scene, scene::camera(preset), {480, 270, 4, true, true});
  REQUIRE(image);
  const std::filesystem::path path = share_path("tests/golden") / (name + ".png");
  if (std::getenv("TROCAR_BLESS") != nullptr) REQUIRE(media::write_png(path, *image));
  const Result<Image> golden = media::read_picture(path);
  REQUIRE(golden);
  const ImageDifference apart = difference(*image, *golden);
  CHECK(apart.mean <= kMeanLimit);
  CHECK(apart.worst <= kWorstLimit);
}

}  // namespace

TEST_CASE("every preset's picture of a trial's start is the golden one") {
  const scene::Scene scene = loaded().scene(ready(), {}, {}, {});
  compare("stage_paper", scene, scene::CameraPreset::kPaper);
  compare("stage_top", scene, scene::CameraPreset::kTop);
  compare("stage_side", scene, scene::CameraPreset::kSide);
  compare("stage_front", scene, scene::CameraPreset::kFront);
}

TEST_CASE("slices, a path and the lattice's frame are drawn as in the golden picture") {
  stage::FieldLayer layer = bell();
  layer.slices = {8, 12, 6};
  stage::StageOptions options;
  options.lattice_frame = true;
  options.highlighted_block = 3;
  compare("stage_slices", loaded().scene(ready(), {spiral()}, {layer}, options), scene::CameraPreset::kPaper);
}

TEST_CASE("see-through voxels are drawn as in the golden picture") {
  stage::FieldLayer layer = bell();
  layer.voxels = true;
  layer.voxel_threshold = 0.5;
  layer.opacity = 0.6F;
  compare("stage_voxels", loaded().scene(ready(), {}, {layer}, {}), scene::CameraPreset::kFront);
}

TEST_CASE("the golden test can fail: a moved block is outside of the tolerance") {
  stage::Pose3d moved = ready();
  const Result<Image> right = renderer().draw(loaded().scene(moved, {}, {}, {}),
                                              scene::camera(scene::CameraPreset::kPaper), {480, 270, 4, true, true});
  moved.blocks[1].p.y() += 0.002;
  const Result<Image> wrong = renderer().draw(loaded().scene(moved, {}, {}, {}),
                                              scene::camera(scene::CameraPreset::kPaper), {480, 270, 4, true, true});
  REQUIRE(right);
  REQUIRE(wrong);
  CHECK(difference(*right, *wrong).worst > kWorstLimit);
}
