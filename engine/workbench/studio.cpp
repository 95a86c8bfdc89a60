#include "engine/workbench/studio.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/learning/start_set.h"
#include "engine/simulation/world.h"
#include "engine/stage/field_layer.h"
#include "engine/stage/path_layer.h"
#include "engine/volume/volume.h"

namespace trocar::workbench {
namespace {

/// A volume is looked at through every third pixel each way while something moves.
constexpr int kCoarseDivisor = 3;

}  // namespace

Result<Studio> Studio::create() {
  TROCAR_ASSIGN_OR_RETURN(std::shared_ptr<const stage::Stage> stage, stage::Stage::load());
  TROCAR_ASSIGN_OR_RETURN(render::Renderer renderer, render::Renderer::create());
  return Studio(std::move(stage), std::move(renderer));
}

Result<Image> Studio::picture(const ViewRequest& request) {
  if (!request.beside) return one_picture(request, 0);
  ViewRequest half = request;
  half.render.width = std::max(request.render.width / 2, 1);
  TROCAR_ASSIGN_OR_RETURN(const Image left, one_picture(half, 0));
  half.pose = request.beside->pose;
  half.paths = request.beside->paths;
  half.fields = request.beside->fields;
  TROCAR_ASSIGN_OR_RETURN(const Image right, one_picture(half, 1));
  Image both(2 * left.width, left.height);
  const std::size_t row = 4 * static_cast<std::size_t>(left.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(left.height); ++y) {
    std::copy_n(left.rgba.data() + y * row, row, both.rgba.data() + 2 * y * row);
    std::copy_n(right.rgba.data() + y * row, row, both.rgba.data() + (2 * y + 1) * row);
  }
  return both;
}

Result<Image> Studio::one_picture(const ViewRequest& request, std::size_t half) {
  stage::StageOptions options = request.options;
  options.camera_right = request.camera.X_WC.rotation().col(0);
  options.lattice_frame = false;
  scene::Scene scene = stage_->scene(request.pose, {}, {}, options);
  Kept& kept = kept_[half];
  show_paths(request.paths, kept);
  show_fields(request.fields, kept);
  const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  add(scene.nodes, kept.path_nodes);
  add(scene.nodes, kept.field_scene.nodes);
  add(scene.quads, kept.field_scene.quads);
  if (request.ghost) stage_->add_ghost(*request.ghost, request.ghost_opacity, scene);
  if (request.options.lattice_frame) {
    const bool known = !request.fields.empty() && request.fields.front().field != nullptr;
    stage_->add_lattice_frame(known ? request.fields.front().field->grid : spatial::Grid{}, scene);
  }
  TROCAR_ASSIGN_OR_RETURN(Image image, drawn(scene, request, kept.volumes));
  labels_.draw(image, scene, request.camera);
  return image;
}

Result<Image> Studio::drawn(const scene::Scene& scene, const ViewRequest& request, volume::Marcher& volumes) {
  const auto has_volume = [](const stage::FieldLayer& layer) {
    return layer.volume && layer.field != nullptr && !layer.field->categorical;
  };
  if (std::none_of(request.fields.begin(), request.fields.end(), has_volume)) {
    return renderer_.draw(scene, request.camera, request.render);
  }
  TROCAR_ASSIGN_OR_RETURN(render::DeepPicture picture, renderer_.draw_deep(scene, request.camera, request.render));
  for (const stage::FieldLayer& layer : request.fields) {
    if (!has_volume(layer)) continue;
    volume::MarchOptions options;
    options.divisor = request.coarse ? kCoarseDivisor : 1;
    options.opacity = layer.opacity;
    options.curve = layer.opacity_curve;
    options.slices = layer.slices;
    volumes.draw(picture.image, picture.depth_m, request.camera, layer.field, layer.colouring, options);
  }
  return std::move(picture.image);
}

void Studio::show_fields(const std::vector<stage::FieldLayer>& fields, Kept& kept) const {
  if (std::equal(fields.begin(), fields.end(), kept.fields.begin(), kept.fields.end(), stage::same_drawing)) return;
  kept.fields = fields;
  kept.field_scene = stage_->field_scene(fields);
}

void Studio::show_paths(const std::shared_ptr<const std::vector<stage::PathLayer>>& paths, Kept& kept) const {
  if (paths == kept.paths) return;
  kept.paths = paths;
  scene::Scene made;
  if (paths) {
    for (const stage::PathLayer& path : *paths) stage::add_path(path, made);
  }
  kept.path_nodes = std::move(made.nodes);
}

scene::Camera half_camera(const scene::Camera& whole) {
  constexpr double kWider = 1.5;
  scene::Camera half = whole;
  half.vertical_fov_rad = 2.0 * std::atan(kWider * std::tan(0.5 * whole.vertical_fov_rad));
  half.orthographic_height_m *= kWider;
  return half;
}

stage::Pose3d ready_stage() {
  return stage::pose_of(simulation::World().state());
}

stage::FieldLayer field_layer(std::shared_ptr<const learning::Field> field, const FieldSettings& settings,
                              const FieldOwner& owner) {
  stage::FieldLayer layer;
  layer.colouring = colouring_of(*field, settings);
  layer.slices = settings.slices;
  layer.slabs = settings.slabs;
  layer.through = settings.through;
  layer.voxels = settings.voxels;
  layer.voxel_threshold = settings.voxel_threshold;
  if (settings.iso_surface) layer.iso_level = settings.iso_level;
  layer.volume = settings.volume;
  layer.opacity_curve = settings.opacity_curve;
  layer.glyphs = settings.glyphs;
  layer.opacity = settings.opacity;
  layer.field = std::move(field);
  layer.model = owner.model;
  layer.policy = owner.policy;
  if (settings.streamlines && owner.model != nullptr) {
    if (auto starts = learning::starts_from(settings.streamline_starts, *owner.model)) {
      layer.streamlines = std::move(*starts);
    }
  }
  return layer;
}

}  // namespace trocar::workbench
