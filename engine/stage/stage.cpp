#include "engine/stage/stage.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "engine/peg_board/peg_board.h"
#include "engine/scene/primitives.h"
#include "engine/spatial/rotation.h"
#include "engine/stage/arm_nodes.h"
#include "engine/stage/field_layer.h"
#include "engine/stage/meshes.h"
#include "engine/stage/palette.h"
#include "engine/stage/path_layer.h"

namespace trocar::stage {
namespace {

using Eigen::Vector3d;
using spatial::Pose;

// Where the paper's camera sees them, in front of the pegs.
const Vector3d kScaleBarMiddle_m(0.0265, 0.042, 0.0);
// … and where the cameras from the other three sides do.
const Vector3d kScaleBarBehind_m(-0.044, -0.042, 0.0);
constexpr double kScaleBarAside_m = 0.064;
const Vector3d kAxesOrigin_m(0.0265, -0.056, 0.0004);

void add_board(const Meshes& meshes, bool light, scene::Scene& scene) {
  scene.nodes.push_back({meshes.table, palette::table(light)});
  scene.nodes.push_back({meshes.board, palette::board()});
  for (int i = 0; i < peg_board::kBlockCount; ++i) {
    for (const Vector3d& foot : {peg_board::start_peg(i), peg_board::goal_peg(i)}) {
      scene.nodes.push_back({meshes.peg, palette::peg(), scene::node_pose(Pose::translation(foot))});
    }
  }
}

/// Makes the joints fit the tool's pose, where they do not; false if they cannot and were never recorded.
bool fit_joints(kinematics::ArmSide side, const Pose& X_WT, kinematics::Joints& joints) {
  constexpr double kFits_m = 0.0002;
  constexpr double kFits_rad = 0.02;
  const kinematics::PsmModel model = kinematics::psm_model(side);
  const bool recorded = joints != kinematics::Joints{};
  if (recorded) {
    const Pose X_WF = kinematics::forward(model, joints);
    if ((X_WF.p - X_WT.p).norm() < kFits_m && X_WF.q.angularDistance(X_WT.q) < kFits_rad) return true;
  }
  const Result<kinematics::Joints> fitting = kinematics::inverse(model, X_WT);
  if (fitting) joints = *fitting;
  return recorded || fitting.has_value();
}

void add_blocks(const Meshes& meshes, const Pose3d& pose, int highlighted, scene::Scene& scene) {
  for (int i = 0; i < peg_board::kBlockCount; ++i) {
    if (!pose.block_known[static_cast<std::size_t>(i)]) continue;
    const Pose& X_WK = pose.blocks[static_cast<std::size_t>(i)];
    scene.nodes.push_back({meshes.block, palette::block(i, i == highlighted), scene::node_pose(X_WK)});
    if (i != highlighted) continue;
    // Under the block, on the board, also while it is in the air.
    const Vector3d below(X_WK.p.x(), X_WK.p.y(), 0.0004);
    scene.nodes.push_back(
        {meshes.highlight_ring, palette::drawn(palette::kHighlight), scene::node_pose(Pose::translation(below))});
  }
}

void add_bar(const Meshes& meshes, const Vector3d& middle, const Vector3d& size, Rgba colour, scene::Scene& scene) {
  scene.nodes.push_back(
      {meshes.cube, palette::drawn(colour), scene::node_pose(Pose::translation(middle), size.cast<float>())});
}

/// Along y, or along x, as the picture's right is.
struct BarPlace {
  Vector3d middle;
  int axis;
};

BarPlace scale_bar_place(const Vector3d& right) {
  if (std::abs(right.x()) > std::abs(right.y())) {
    return {Vector3d(0.0, right.x() > 0.0 ? -kScaleBarAside_m : kScaleBarAside_m, 0.0), 0};
  }
  return {right.y() >= 0.0 ? kScaleBarMiddle_m : kScaleBarBehind_m, 1};
}

void add_scale_bar(const Meshes& meshes, const Vector3d& right, scene::Scene& scene) {
  constexpr double kLength_m = 0.010;
  constexpr double kWidth_m = 0.0006;
  constexpr double kHeight_m = 0.0003;
  constexpr double kEnd_m = 0.0026;
  const BarPlace place = scale_bar_place(right);
  const Vector3d along = Vector3d::Unit(place.axis);
  const Vector3d across = Vector3d::Unit(1 - place.axis);
  const Vector3d up(0.0, 0.0, kHeight_m);
  const Vector3d lifted = place.middle + 0.5 * up;
  add_bar(meshes, lifted, kLength_m * along + kWidth_m * across + up, palette::kRuler, scene);
  for (const double side : {-0.5, 0.5}) {
    const Vector3d end = lifted + side * (kLength_m - kWidth_m) * along;
    add_bar(meshes, end, kWidth_m * along + kEnd_m * across + up, palette::kRuler, scene);
  }
  scene.labels.push_back({place.middle, "10 mm", palette::kText, 1.15});
}

void add_axes(const Meshes& meshes, scene::Scene& scene) {
  const std::array<Eigen::Quaterniond, 3> turns{spatial::about_y(std::numbers::pi / 2.0),
                                                spatial::about_x(-std::numbers::pi / 2.0), spatial::about_x(0.0)};
  const std::array<const char*, 3> names{"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    scene::Material material = palette::material(palette::kAxes[i], 0.6F, 0.0F);
    material.emission = 0.6F;
    scene.nodes.push_back({meshes.axis, material, scene::node_pose({kAxesOrigin_m, turns[i]})});
    const Vector3d end = kAxesOrigin_m + turns[i] * Vector3d(0.0, 0.0, 0.0112);
    scene.labels.push_back({end, names[i], palette::kAxes[i]});
  }
}

void add_peg_numbers(scene::Scene& scene) {
  const Vector3d tip(0.0, 0.0, peg_board::kPegHeight_m);
  for (int i = 0; i < peg_board::kBlockCount; ++i) {
    scene.labels.push_back({peg_board::start_peg(i) + tip, fmt::format("S{}", i), palette::kQuietText, 1.0});
    scene.labels.push_back({peg_board::goal_peg(i) + tip, fmt::format("G{}", i), palette::kQuietText, 1.0});
  }
}

void add_frame(const Meshes& meshes, const spatial::Grid& grid, scene::Scene& scene) {
  const double side = grid.n * grid.cell_m;
  constexpr double kThickness_m = 0.00025;
  for (int axis = 0; axis < 3; ++axis) {
    for (int edge = 0; edge < 4; ++edge) {
      Vector3d middle = grid.p_WGo + Vector3d::Unit(axis) * 0.5 * side;
      if ((edge & 1) != 0) middle += Vector3d::Unit((axis + 1) % 3) * side;
      if ((edge & 2) != 0) middle += Vector3d::Unit((axis + 2) % 3) * side;
      Vector3d size = Vector3d::Constant(kThickness_m);
      size[axis] += side;
      add_bar(meshes, middle, size, palette::kFrame, scene);
    }
  }
}

}  // namespace

Pose3d pose_of(const simulation::WorldState& state) {
  Pose3d pose;
  for (std::size_t i = 0; i < 2; ++i) {
    pose.joints[i] = state.arms[i].joints;
    pose.jaw_rad[i] = state.arms[i].jaw_rad;
  }
  for (std::size_t i = 0; i < pose.blocks.size(); ++i) pose.blocks[i] = state.blocks[i].X_WK;
  return pose;
}

Pose3d pose_of(const demonstration::Sample& sample) {
  Pose3d pose;
  for (std::size_t i = 0; i < 2; ++i) {
    const demonstration::ArmSample& arm = sample.arms[i];
    for (std::size_t k = 0; k < pose.joints[i].size(); ++k) pose.joints[i][k] = static_cast<double>(arm.joints[k]);
    pose.arm_known[i] = fit_joints(kinematics::kArmSides[i], arm.measured.pose(), pose.joints[i]);
    pose.jaw_rad[i] = static_cast<double>(arm.jaw_rad);
  }
  for (std::size_t i = 0; i < pose.blocks.size(); ++i) {
    pose.blocks[i] = sample.blocks[i].pose();
    pose.block_known[i] = demonstration::is_known(sample.blocks[i]);
  }
  return pose;
}

Result<std::shared_ptr<const Stage>> Stage::load() {
  auto stage = std::make_shared<Stage>();
  TROCAR_ASSIGN_OR_RETURN(stage->meshes_, Meshes::load());
  return stage;
}

scene::Scene Stage::scene(const Pose3d& pose, const std::vector<PathLayer>& paths,
                          const std::vector<FieldLayer>& fields, const StageOptions& options) const {
  scene::Scene made;
  if (options.light_ground) {
    made.background_top = palette::kLightTop;
    made.background_bottom = palette::kLightBottom;
  }
  add_board(*meshes_, options.light_ground, made);
  add_blocks(*meshes_, pose, options.highlighted_block, made);
  if (options.arms) {
    for (const kinematics::ArmSide side : kinematics::kArmSides) {
      const std::size_t i = kinematics::index_of(side);
      if (pose.arm_known[i]) add_arm(*meshes_, side, pose.joints[i], pose.jaw_rad[i], made.nodes);
    }
  }
  for (const PathLayer& path : paths) add_path(path, made);
  for (const FieldLayer& field : fields) add_field(*meshes_, field, made);
  if (options.lattice_frame) {
    const bool known = !fields.empty() && fields.front().field != nullptr;
    add_frame(*meshes_, known ? fields.front().field->grid : spatial::Grid{}, made);
  }
  if (options.scale_bar) add_scale_bar(*meshes_, options.camera_right, made);
  if (options.labels) {
    add_axes(*meshes_, made);
    add_peg_numbers(made);
  }
  return made;
}

scene::Scene Stage::field_scene(const std::vector<FieldLayer>& fields) const {
  scene::Scene made;
  for (const FieldLayer& field : fields) add_field(*meshes_, field, made);
  return made;
}

void Stage::add_lattice_frame(const spatial::Grid& grid, scene::Scene& scene) const {
  add_frame(*meshes_, grid, scene);
}

void Stage::add_ghost(const Pose3d& pose, float opacity, scene::Scene& scene) const {
  std::vector<scene::Node> nodes;
  for (const kinematics::ArmSide side : kinematics::kArmSides) {
    const std::size_t i = kinematics::index_of(side);
    if (pose.arm_known[i]) add_arm(*meshes_, side, pose.joints[i], pose.jaw_rad[i], nodes);
  }
  for (scene::Node& node : nodes) {
    node.material.base_colour.w() = opacity;
    node.material.casts_shadow = false;
    scene.nodes.push_back(std::move(node));
  }
}

}  // namespace trocar::stage
