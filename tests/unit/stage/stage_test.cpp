#include "engine/stage/stage.h"
#include "engine/demonstration/segment_colour.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/peg_board/peg_board.h"
#include "engine/scene/primitives.h"
#include "engine/spatial/rotation.h"
#include "engine/stage/field_layer.h"
#include "engine/stage/label_painter.h"

using namespace trocar;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

const stage::Stage& loaded() {
  static const Result<std::shared_ptr<const stage::Stage>> kStage = stage::Stage::load();
  REQUIRE(kStage);
  return **kStage;
}

kinematics::Joints ready(kinematics::ArmSide side) {
  const auto joints = kinematics::inverse(kinematics::psm_model(side), kinematics::ready_pose(side));
  REQUIRE(joints);
  return *joints;
}

stage::Pose3d ready_pose() {
  stage::Pose3d pose;
  for (const kinematics::ArmSide side : kinematics::kArmSides) {
    pose.joints[kinematics::index_of(side)] = ready(side);
  }
  for (int i = 0; i < peg_board::kBlockCount; ++i) {
    spatial::Pose& X_WK = pose.blocks[static_cast<std::size_t>(i)];
    X_WK.p = peg_board::start_peg(i) + Vector3d(0.0, 0.0, peg_board::kBlockRest_m);
  }
  return pose;
}

stage::StageOptions bare() {
  stage::StageOptions options;
  options.arms = false;
  options.scale_bar = false;
  options.labels = false;
  return options;
}

std::size_t triangle_count(const scene::Scene& scene) {
  std::size_t count = 0;
  for (const scene::Node& node : scene.nodes) count += node.mesh->indices.size() / 3;
  return count;
}

std::vector<Vector3d> points_of(const scene::Node& node) {
  std::vector<Vector3d> points;
  for (const Vector3f& p : node.mesh->positions) {
    points.push_back((node.X_WM * p.homogeneous()).head<3>().cast<double>());
  }
  return points;
}

/// 1 in the middle half of the lattice, unknown elsewhere.
std::shared_ptr<const learning::Field> core_field() {
  auto field = std::make_shared<learning::Field>();
  for (int s = 0; s < field->grid.cell_count(); ++s) {
    const spatial::CellCoordinates c = field->grid.coordinates({s});
    const bool inside = std::min({c.x, c.y, c.z}) >= 6 && std::max({c.x, c.y, c.z}) < 16;
    field->values.push_back(inside ? 1.0 : std::numeric_limits<double>::quiet_NaN());
  }
  return field;
}

}  // namespace

TEST_CASE("the whole stage with labels, both arms and a long path has fewer than 30,000 triangles") {
  stage::PathLayer path;
  for (int i = 0; i < 6000; ++i) {
    const double t = i * 0.002;
    path.points.emplace_back(0.02 * std::cos(t), 0.02 * std::sin(t), 0.02 + 0.01 * std::sin(3.0 * t));
    path.colours.push_back(demonstration::segment_colour(static_cast<demonstration::Segment>(i / 1200)));
  }
  stage::StageOptions options;
  options.highlighted_block = 2;
  options.lattice_frame = true;
  const scene::Scene scene = loaded().scene(ready_pose(), {path}, {}, options);
  CHECK(triangle_count(scene) < 30000);
  CHECK(triangle_count(scene) > 5000);
}

TEST_CASE("the board, the pegs and the blocks have the sizes of the task") {
  const scene::Scene scene = loaded().scene(ready_pose(), {}, {}, bare());
  int pegs = 0;
  int blocks = 0;
  for (const scene::Node& node : scene.nodes) {
    Vector3d low = Vector3d::Constant(1.0);
    Vector3d high = -low;
    for (const Vector3d& p : points_of(node)) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const Vector3d size = high - low;
    if (std::abs(high.z() - peg_board::kPegHeight_m) < 1e-6) ++pegs;
    // A block at yaw 0 reaches from a wall at −5 mm to the opposite corner, which is cut.
    if (std::abs(size.z() - peg_board::kBlockHeight_m) < 1e-6) {
      ++blocks;
      CHECK(size.x() > 0.0130);
      CHECK(size.x() < 0.0150);
    }
    if (std::abs(size.x() - peg_board::kBoardX_m) < 1e-6) {
      CHECK(size.y() == doctest::Approx(peg_board::kBoardY_m));
      CHECK(size.z() == doctest::Approx(peg_board::kBoardZ_m));
      CHECK(high.z() == doctest::Approx(0.0));
    }
  }
  CHECK(pegs == peg_board::kPegCount);
  CHECK(blocks == peg_board::kBlockCount);
}

TEST_CASE("a block's walls are where its physics has them: 5 mm from the axis, its hole clear") {
  stage::Pose3d pose = ready_pose();
  for (spatial::Pose& X_WK : pose.blocks) X_WK = spatial::Pose{};
  const scene::Scene scene = loaded().scene(pose, {}, {}, bare());
  const scene::Node& block = scene.nodes.back();
  for (int wall = 0; wall < peg_board::kWallCount; ++wall) {
    const double angle = peg_board::wall_angle(wall);
    const Vector3d normal(std::cos(angle), std::sin(angle), 0.0);
    double farthest = 0.0;
    double narrowest = 1.0;
    for (const Vector3d& p : points_of(block)) {
      farthest = std::max(farthest, normal.dot(p));
      narrowest = std::min(narrowest, std::hypot(p.x(), p.y()));
    }
    CHECK(farthest == doctest::Approx(peg_board::kHoleApothem_m + peg_board::kWallThickness_m).epsilon(1e-3));
    CHECK(narrowest >= peg_board::kHoleApothem_m - 1e-6);
  }
}

TEST_CASE("the closed jaws end at the tool tip and open jaws end apart, on both sides of it") {
  for (const kinematics::ArmSide side : kinematics::kArmSides) {
    const Vector3d p_WT = kinematics::ready_pose(side).p;
    const Vector3d opening = kinematics::ready_pose(side).q * Vector3d::UnitY();
    for (const double jaw_rad : {0.0, 0.4}) {
      stage::Pose3d pose = ready_pose();
      pose.jaw_rad = {jaw_rad, jaw_rad};
      stage::StageOptions options = bare();
      options.arms = true;
      double low = 0.0;
      double high = 0.0;
      double lowest_z = 1.0;
      for (const scene::Node& node : loaded().scene(pose, {}, {}, options).nodes) {
        for (const Vector3d& p : points_of(node)) {
          // The last millimetre of the jaws.
          if ((p - p_WT).norm() > 0.004 || p.z() > p_WT.z() + 0.001) continue;
          low = std::min(low, opening.dot(p - p_WT));
          high = std::max(high, opening.dot(p - p_WT));
          lowest_z = std::min(lowest_z, p.z());
        }
      }
      // sin(0.2) · 10.2 mm = 2.03 mm, and a jaw's thickness.
      CHECK(high == doctest::Approx(jaw_rad > 0.0 ? 0.0026 : 0.0007).epsilon(0.25));
      CHECK(-low == doctest::Approx(high).epsilon(0.05));
      if (jaw_rad == 0.0) CHECK(lowest_z == doctest::Approx(p_WT.z()).epsilon(1e-4));
    }
  }
}

TEST_CASE("nothing of an arm is below its tip while it points down") {
  stage::StageOptions options = bare();
  const std::size_t without = loaded().scene(ready_pose(), {}, {}, options).nodes.size();
  options.arms = true;
  const scene::Scene scene = loaded().scene(ready_pose(), {}, {}, options);
  REQUIRE(scene.nodes.size() > without);
  for (std::size_t i = without; i < scene.nodes.size(); ++i) {
    for (const Vector3d& p : points_of(scene.nodes[i])) CHECK(p.z() > 0.0499);
  }
}

TEST_CASE("a highlighted block differs from the others and is ringed") {
  stage::StageOptions options = bare();
  const std::size_t plain = loaded().scene(ready_pose(), {}, {}, options).nodes.size();
  options.highlighted_block = 4;
  CHECK(loaded().scene(ready_pose(), {}, {}, options).nodes.size() == plain + 1);
}

TEST_CASE("three slices are cut along each other into twelve pieces, each in its plane") {
  stage::FieldLayer layer;
  layer.field = core_field();
  layer.slices = {8, 10, 12};
  const scene::Scene scene = loaded().scene(ready_pose(), {}, {layer}, bare());
  REQUIRE(scene.quads.size() == 12);
  const Vector3d middle = layer.field->grid.centre(layer.field->grid.index({8, 10, 12}));
  for (const scene::Quad& quad : scene.quads) {
    const Vector3f normal = quad.u.cross(quad.v).normalized();
    CHECK(std::abs(normal.dot(quad.origin - middle.cast<float>())) < 1e-6F);
    CHECK(quad.texture->width * quad.v.norm() == doctest::Approx(quad.texture->height * quad.u.norm()));
  }
}

TEST_CASE("a slice shows known cells in their colour and unknown ones see-through") {
  stage::FieldLayer layer;
  layer.field = core_field();
  layer.slices = {10, -1, -1};
  layer.colouring.map = plot::ColourMap::kViridis;
  const scene::Scene scene = loaded().scene(ready_pose(), {}, {layer}, bare());
  REQUIRE(scene.quads.size() == 1);
  const scene::Quad& quad = scene.quads.front();
  CHECK(quad.origin.x() == doctest::Approx(layer.field->grid.centre(layer.field->grid.index({10, 0, 0})).x()));
  const Image& texture = *quad.texture;
  const int texels = texture.width / layer.field->grid.n;
  CHECK(texture.at(10 * texels + texels / 2, 10 * texels + texels / 2) == plot::colour(layer.colouring.map, 1.0));
  int opaque = 0;
  for (int y = 0; y < texels; ++y) {
    for (int x = 0; x < texels; ++x) opaque += texture.at(2 * texels + x, 2 * texels + y).a > 128 ? 1 : 0;
  }
  CHECK(opaque == 0);
}

TEST_CASE("the top row of a slice is the lattice's highest layer") {
  auto field = std::make_shared<learning::Field>();
  for (int s = 0; s < field->grid.cell_count(); ++s) field->values.push_back(field->grid.coordinates({s}).z);
  stage::FieldLayer layer;
  layer.field = field;
  layer.slices = {-1, 5, -1};
  layer.colouring.scale.high = 21.0;
  layer.colouring.map = plot::ColourMap::kGrey;
  const scene::Scene scene = loaded().scene(ready_pose(), {}, {layer}, bare());
  REQUIRE(scene.quads.size() == 1);
  const Image& texture = *scene.quads.front().texture;
  CHECK(scene.quads.front().v.z() > 0.0F);
  CHECK(texture.at(20, 4) == plot::colour(layer.colouring.map, 1.0));
  CHECK(texture.at(20, texture.height - 4) == plot::colour(layer.colouring.map, 0.0));
}

TEST_CASE("slices outside of the lattice are left out") {
  stage::FieldLayer layer;
  layer.field = core_field();
  layer.slices = {22, -1, 100};
  CHECK(loaded().scene(ready_pose(), {}, {layer}, bare()).quads.empty());
  layer.field = nullptr;
  layer.slices = {1, 1, 1};
  CHECK(loaded().scene(ready_pose(), {}, {layer}, bare()).quads.empty());
}

TEST_CASE("voxels stand for the cells above the threshold that can be seen") {
  stage::FieldLayer layer;
  layer.field = core_field();
  layer.voxels = true;
  layer.voxel_threshold = 0.5;
  const std::size_t without = loaded().scene(ready_pose(), {}, {}, bare()).nodes.size();
  const std::size_t with = loaded().scene(ready_pose(), {}, {layer}, bare()).nodes.size();
  CHECK(with - without == 10 * 10 * 10 - 8 * 8 * 8);  // The skin of a cube of 10 cells a side.
}

TEST_CASE("a straight path is one tube of two points, and each segment has its own colour") {
  stage::PathLayer path;
  for (int i = 0; i <= 1000; ++i) path.points.emplace_back(0.0, i * 2e-5, 0.03);
  path.colours = {{10, 20, 30, 255}};
  const std::size_t without = loaded().scene(ready_pose(), {}, {}, bare()).nodes.size();
  const scene::Scene one = loaded().scene(ready_pose(), {path}, {}, bare());
  REQUIRE(one.nodes.size() == without + 1);
  CHECK(one.nodes.back().mesh->indices.size() / 3 == 2 * 6 + 2 * 4);  // Six sides and two caps.
  path.colours.assign(path.points.size(), demonstration::segment_colour(demonstration::Segment::kA));
  for (std::size_t i = 500; i < path.points.size(); ++i) {
    path.colours[i] = demonstration::segment_colour(demonstration::Segment::kB);
  }
  CHECK(loaded().scene(ready_pose(), {path}, {}, bare()).nodes.size() == without + 2);
}

TEST_CASE("a path that does not move is not drawn") {
  stage::PathLayer path;
  path.points.assign(10, Vector3d(0.0, 0.0, 0.03));
  path.colours = {{10, 20, 30, 255}};
  const std::size_t without = loaded().scene(ready_pose(), {}, {}, bare()).nodes.size();
  CHECK(loaded().scene(ready_pose(), {path}, {}, bare()).nodes.size() == without);
}

TEST_CASE("every segment has a colour of its own") {
  for (int a = 0; a < demonstration::kSegmentCount; ++a) {
    for (int b = 0; b < a; ++b) {
      CHECK_FALSE(demonstration::segment_colour(static_cast<demonstration::Segment>(a)) ==
                  demonstration::segment_colour(static_cast<demonstration::Segment>(b)));
    }
  }
}

TEST_CASE("labels change the picture near their points and nowhere else") {
  scene::Scene scene;
  scene.labels.push_back({{-0.01, 0.0, 0.0}, "10 mm"});
  scene.labels.push_back({{0.5, 0.0, 0.0}, "behind the camera"});
  const scene::Camera camera = scene::camera(scene::CameraPreset::kPaper);
  const Image picture(640, 360, {40, 40, 40, 255});
  const Image labelled = stage::with_labels(picture, scene, camera);
  const Vector3d at = camera.project({-0.01, 0.0, 0.0}, 640, 360);
  int changed = 0;
  for (int y = 0; y < 360; ++y) {
    for (int x = 0; x < 640; ++x) {
      if (labelled.at(x, y) == picture.at(x, y)) continue;
      ++changed;
      CHECK(std::abs(x - at.x()) < 40.0);
      CHECK(std::abs(y - at.y()) < 25.0);
    }
  }
  CHECK(changed > 50);
}

TEST_CASE("two labels at one place are both legible: one gives way") {
  const scene::Camera camera = scene::camera(scene::CameraPreset::kPaper);
  const Image picture(640, 360, {40, 40, 40, 255});
  scene::Scene one;
  one.labels.push_back({{-0.01, 0.0, 0.0}, "888"});
  scene::Scene two = one;
  two.labels.push_back({{-0.011, 0.0, 0.0}, "888"});
  const auto ink = [&picture](const Image& image) {
    int count = 0;
    for (int y = 0; y < 360; ++y) {
      for (int x = 0; x < 640; ++x) count += image.at(x, y) == picture.at(x, y) ? 0 : 1;
    }
    return count;
  };
  const int single = ink(stage::with_labels(picture, one, camera));
  CHECK(ink(stage::with_labels(picture, two, camera)) > 1.9 * single);
}

TEST_CASE("a label behind a thing is left out, one in front of it or beside it is not") {
  const scene::Camera camera = scene::Camera::look_at({0.2, 0.0, 0.05}, {0.0, 0.0, 0.05});
  const Image picture(640, 360, {40, 40, 40, 255});
  scene::Scene scene;
  scene::Node wall;
  wall.mesh = std::make_shared<const scene::Mesh>(scene::unit_cube());
  wall.X_WM = scene::node_pose(spatial::Pose::translation({0.0, 0.0, 0.05}), {0.01F, 0.06F, 0.06F});
  scene.nodes.push_back(wall);
  const auto drawn = [&](const Vector3d& at) {
    scene.labels = {{at, "S0"}};
    return !(stage::with_labels(picture, scene, camera) == picture);
  };
  CHECK_FALSE(drawn({-0.02, 0.0, 0.05}));
  CHECK(drawn({0.02, 0.0, 0.05}));
  CHECK(drawn({-0.02, 0.06, 0.05}));
  CHECK(drawn({0.005, 0.0, 0.05}));  // On the wall's near face.
  scene.nodes[0].material.base_colour.w() = 0.3F;
  CHECK(drawn({-0.02, 0.0, 0.05}));
}

TEST_CASE("a label painter gives the same picture whatever it wrote before") {
  const scene::Camera camera = scene::camera(scene::CameraPreset::kPaper);
  const Image ground(320, 180, {90, 60, 40, 255});
  scene::Scene scene;
  scene.labels = {{{-0.01, 0.0, 0.0}, "G3"}, {{-0.01, 0.02, 0.0}, "G3", {255, 0, 0, 255}}};
  stage::LabelPainter painter;
  Image first = ground;
  painter.draw(first, scene, camera);
  Image larger(640, 360);
  painter.draw(larger, scene, camera);
  Image again = ground;
  painter.draw(again, scene, camera);
  CHECK(again == first);
  CHECK(first == stage::with_labels(ground, scene, camera));
}

TEST_CASE("the classes of a field have the colours that its layer names") {
  auto field = std::make_shared<learning::Field>();
  field->categorical = true;
  field->values.assign(static_cast<std::size_t>(field->grid.cell_count()), 1.0);
  stage::FieldLayer layer;
  layer.field = field;
  layer.colouring.categories = {{1, 2, 3, 255}, {4, 5, 6, 255}};
  CHECK(stage::colour_of(layer, {0}) == Rgba{4, 5, 6, 255});
  layer.colouring.categories.pop_back();
  CHECK_FALSE(stage::colour_of(layer, {0}));
}

TEST_CASE("what was not recorded of arms and blocks is worked out or left out") {
  demonstration::Sample sample;
  const spatial::Pose ready = kinematics::ready_pose(kinematics::ArmSide::kLeft);
  sample.arms[0].measured = demonstration::CompactPose::from(ready);
  sample.arms[1].measured = demonstration::CompactPose::from(spatial::Pose::translation({9.0, 9.0, 9.0}));
  sample.blocks[3].p = {0.01F, 0.0F, 0.01F};
  const stage::Pose3d pose = stage::pose_of(sample);
  CHECK(pose.arm_known[0]);
  CHECK_FALSE(pose.arm_known[1]);
  const spatial::Pose X_WT = kinematics::forward(kinematics::psm_model(kinematics::ArmSide::kLeft), pose.joints[0]);
  CHECK((X_WT.p - ready.p).norm() < 1e-6);
  CHECK(pose.block_known == std::array{false, false, false, true, false, false});
  const std::size_t all = loaded().scene(ready_pose(), {}, {}, bare()).nodes.size();
  CHECK(loaded().scene(pose, {}, {}, bare()).nodes.size() < all);
}

TEST_CASE("the scale bar lies across the view of every camera, ten millimetres long, on the board") {
  stage::StageOptions options = bare();
  const std::size_t without = loaded().scene(ready_pose(), {}, {}, options).nodes.size();
  options.scale_bar = true;
  for (const scene::CameraPreset preset : {scene::CameraPreset::kPaper, scene::CameraPreset::kTop,
                                           scene::CameraPreset::kSide, scene::CameraPreset::kFront}) {
    const scene::Camera camera = scene::camera(preset);
    options.camera_right = camera.X_WC.rotation().col(0);
    const scene::Scene made = loaded().scene(ready_pose(), {}, {}, options);
    REQUIRE(made.nodes.size() == without + 3);
    REQUIRE(made.labels.size() == 1);
    CHECK(made.labels.front().text == "10 mm");
    double left = 1e9;
    double right = -1e9;
    for (std::size_t i = without; i < made.nodes.size(); ++i) {
      for (const Vector3d& p_W : points_of(made.nodes[i])) {
        CHECK(std::abs(p_W.x()) < 0.5 * peg_board::kBoardX_m);
        CHECK(std::abs(p_W.y()) < 0.5 * peg_board::kBoardY_m);
        const Vector3d seen = camera.project(p_W, 1280, 720);
        CHECK(seen.x() > 0.0);
        CHECK(seen.x() < 1280.0);
        CHECK(seen.y() > 0.0);
        CHECK(seen.y() < 720.0);
        left = std::min(left, p_W.dot(options.camera_right));
        right = std::max(right, p_W.dot(options.camera_right));
      }
    }
    // Across: its whole length is to the right in the picture.
    CHECK(right - left == doctest::Approx(0.010).epsilon(0.01));
  }
}

TEST_CASE("a label behind a slice is not written over it, one before it or behind unknown cells is") {
  const Image ground(320, 180, {20, 20, 20, 255});
  const scene::Camera camera = scene::Camera::look_at({0.2, 0.0, 0.0}, {0.0, 0.0, 0.0});
  const auto written = [&](double label_x_m, std::uint8_t alpha, float opacity) {
    scene::Scene scene;
    scene::Quad quad;
    quad.origin = {0.0F, -0.05F, -0.05F};
    quad.u = {0.0F, 0.1F, 0.0F};
    quad.v = {0.0F, 0.0F, 0.1F};
    quad.texture = std::make_shared<const Image>(4, 4, Rgba{90, 160, 90, alpha});
    quad.opacity = opacity;
    scene.quads.push_back(quad);
    scene.labels.push_back({{label_x_m, 0.0, 0.0}, "S2"});
    return !(stage::with_labels(ground, scene, camera) == ground);
  };
  CHECK_FALSE(written(-0.02, 255, 0.8F));
  CHECK(written(0.02, 255, 0.8F));
  CHECK(written(-0.02, 0, 0.8F));
  CHECK(written(-0.02, 255, 0.3F));
}
