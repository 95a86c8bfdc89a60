/// Where pictures are made: the stage and a renderer, together in one thread.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/render/renderer.h"
#include "engine/scene/scene.h"
#include "engine/stage/label_painter.h"
#include "engine/stage/stage.h"
#include "engine/volume/volume.h"
#include "engine/workbench/command.h"

namespace trocar::workbench {

/// Everything that one picture depends on; equal requests give equal pixels.
struct ViewRequest {
  stage::Pose3d pose;
  std::shared_ptr<const std::vector<stage::PathLayer>> paths;  ///< May be null.
  std::vector<stage::FieldLayer> fields;
  std::optional<stage::Pose3d> ghost;  ///< Arms that are seen through …
  float ghost_opacity = 0.3F;          ///< … 0 to 1.
  stage::StageOptions options;
  scene::Camera camera;
  render::RenderOptions render;
  bool coarse = false;  ///< Something moves: a volume is marched through at a third of the resolution.
  /// What the right half of the picture shows, of the same camera; all else of the request is in the left one.
  struct Beside {
    stage::Pose3d pose;
    std::shared_ptr<const std::vector<stage::PathLayer>> paths;
    std::vector<stage::FieldLayer> fields;
  };
  std::optional<Beside> beside;
};

/// Threads: created, used and destroyed in one thread, which holds no other GL context.
class Studio {
 public:
  /// Errors: those of `stage::Stage::load` and `render::Renderer::create`.
  static Result<Studio> create();

  Result<Image> picture(const ViewRequest& request);

 private:
  Studio(std::shared_ptr<const stage::Stage> stage, render::Renderer renderer)
      : stage_(std::move(stage)), renderer_(std::move(renderer)) {}

  /// `half`: 0 the left one, or all; 1 the right one. What each showed last is kept.
  Result<Image> one_picture(const ViewRequest& request, std::size_t half);
  /// With volumes, without labels.
  Result<Image> drawn(const scene::Scene& scene, const ViewRequest& request, volume::Marcher& volumes);
  /// The same paths and fields keep their meshes from picture to picture, so that they need not be made anew.
  struct Kept {
    std::shared_ptr<const std::vector<stage::PathLayer>> paths;
    std::vector<scene::Node> path_nodes;
    std::vector<stage::FieldLayer> fields;
    scene::Scene field_scene;
    volume::Marcher volumes;
  };
  void show_paths(const std::shared_ptr<const std::vector<stage::PathLayer>>& paths, Kept& kept) const;
  void show_fields(const std::vector<stage::FieldLayer>& fields, Kept& kept) const;

  std::shared_ptr<const stage::Stage> stage_;
  std::array<Kept, 2> kept_;  ///< Of the halves.
  render::Renderer renderer_;
  stage::LabelPainter labels_;
};

/// The camera of either half of a picture that shows two models: it sees more above and below, so that less is lost at
/// the sides.
scene::Camera half_camera(const scene::Camera& whole);

/// The scene before anything is recorded: arms at the ready pose, every block on its start peg.
stage::Pose3d ready_stage();

/// Whose the field is; both may be null where neither glyphs nor streamlines are wanted.
struct FieldOwner {
  std::shared_ptr<const learning::Model> model;
  std::shared_ptr<const std::vector<std::uint8_t>> policy;
};
/// The field as the settings want it drawn, with the map that suits its layer. Starts of streamlines that the model
/// cannot have are left out.
stage::FieldLayer field_layer(std::shared_ptr<const learning::Field> field, const FieldSettings& settings,
                              const FieldOwner& owner = {});

}  // namespace trocar::workbench
