#include "engine/workbench/studio.h"

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
  layer.map = figure::suggested_options(*field).map;
  layer.scale = plot::fit_scale(settings.scale, field->values, layer.map == plot::ColourMap::kDiverging);
  layer.slices = settings.slices;
  layer.voxels = settings.voxels;
  layer.opacity = settings.opacity;
  if (field->categorical) layer.categories = figure::category_colours(*field);
  layer.field = std::move(field);
  return layer;
}

}  // namespace trocar::workbench
