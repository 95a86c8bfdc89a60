#include "engine/workbench/studio.h"

#include <algorithm>
#include <utility>

#include "engine/figure/field_figure.h"
#include "engine/simulation/world.h"
#include "engine/stage/path_layer.h"

namespace trocar::workbench {
Result<Studio> Studio::create() {
  TROCAR_ASSIGN_OR_RETURN(std::shared_ptr<const stage::Stage> stage, stage::Stage::load());
  TROCAR_ASSIGN_OR_RETURN(render::Renderer renderer, render::Renderer::create());
  return Studio(std::move(stage), std::move(renderer));
}

Result<Image> Studio::picture(const ViewRequest& request) {
  if (!request.beside) return one_picture(request);
  ViewRequest half = request;
  half.render.width = std::max(request.render.width / 2, 1);
  TROCAR_ASSIGN_OR_RETURN(const Image left, one_picture(half));
  half.pose = *request.beside;
  TROCAR_ASSIGN_OR_RETURN(const Image right, one_picture(half));
  Image both(2 * left.width, left.height);
  const std::size_t row = 4 * static_cast<std::size_t>(left.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(left.height); ++y) {
    std::copy_n(left.rgba.data() + y * row, row, both.rgba.data() + 2 * y * row);
    std::copy_n(right.rgba.data() + y * row, row, both.rgba.data() + (2 * y + 1) * row);
  }
  return both;
}

Result<Image> Studio::one_picture(const ViewRequest& request) {
  stage::StageOptions options = request.options;
  options.camera_right = request.camera.X_WC.rotation().col(0);
  scene::Scene scene = stage_->scene(request.pose, {}, request.fields, options);
  show_paths(request.paths);
  scene.nodes.insert(scene.nodes.end(), path_nodes_.begin(), path_nodes_.end());
  TROCAR_ASSIGN_OR_RETURN(Image image, renderer_.draw(scene, request.camera, request.render));
  labels_.draw(image, scene, request.camera);
  return image;
}

void Studio::show_paths(const std::shared_ptr<const std::vector<stage::PathLayer>>& paths) {
  if (paths == paths_) return;
  paths_ = paths;
  scene::Scene made;
  if (paths) {
    for (const stage::PathLayer& path : *paths) stage::add_path(path, made);
  }
  path_nodes_ = std::move(made.nodes);
}

stage::Pose3d ready_stage() {
  return stage::pose_of(simulation::World().state());
}

stage::FieldLayer field_layer(std::shared_ptr<const learning::Field> field, const FieldSettings& settings) {
  stage::FieldLayer layer;
  layer.colouring = colouring_of(*field, settings);
  layer.slices = settings.slices;
  layer.voxels = settings.voxels;
  layer.opacity = settings.opacity;
  layer.field = std::move(field);
  return layer;
}

}  // namespace trocar::workbench
