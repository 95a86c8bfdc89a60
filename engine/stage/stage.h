/// From state to what is seen: the peg board, arms, blocks, paths and fields as a scene.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/demonstration/demonstration.h"
#include "engine/kinematics/psm.h"
#include "engine/learning/field.h"
#include "engine/learning/slab.h"
#include "engine/plot/colouring.h"
#include "engine/plot/opacity_curve.h"
#include "engine/scene/scene.h"
#include "engine/simulation/world_state.h"
#include "engine/spatial/grid.h"
#include "engine/stage/glyphs.h"

namespace trocar::stage {

/// What moves: both arms and the blocks.
struct Pose3d {
  std::array<kinematics::Joints, 2> joints{};
  std::array<double, 2> jaw_rad{};
  std::array<spatial::Pose, peg_board::kBlockCount> blocks;
  std::array<bool, 2> arm_known{true, true};  ///< One that is not is left out, as is a block.
  std::array<bool, peg_board::kBlockCount> block_known{true, true, true, true, true, true};
};
Pose3d pose_of(const simulation::WorldState& state);
/// The arms are where their tools were measured, or set by an edit: joints that were not recorded, or no longer fit,
/// are worked out anew; an arm for which there are none is not known.
Pose3d pose_of(const demonstration::Sample& sample);

/// A line through space, drawn as a tube.
struct PathLayer {
  std::vector<Eigen::Vector3d> points;  ///< W, metres.
  std::vector<Rgba> colours;            ///< One for all, or one for each point.
  double radius_m = 0.0005;
};

/// A field as slices (cell coordinates; −1 for none), as voxels above a threshold, as a surface, or as a volume; and
/// what its model would do.
struct FieldLayer {
  std::shared_ptr<const learning::Field> field;
  std::array<int, 3> slices{-1, -1, -1};  ///< x, y, z.
  std::array<int, 3> slabs{1, 1, 1};      ///< Cells, at least 1, of which a slice shows …
  learning::Through through = learning::Through::kLargest;
  bool voxels = false;
  double voxel_threshold = 0.9;                     ///< Position on the scale, 0 … 1, from which on a voxel is drawn.
  std::optional<double> iso_level;                  ///< Position on the scale, 0 … 1; none: no surface.
  bool volume = false;                              ///< Not of the scene: `volume::march` draws it over the picture.
  std::optional<plot::OpacityCurve> opacity_curve;  ///< Of the volume; none: fitted to the field.
  Glyphs glyphs = Glyphs::kNone;                    ///< On the slices; of `model`.
  plot::Colouring colouring;
  float opacity = 0.85F;
  /// Whose field it is, for glyphs and streamlines; may be null without them.
  std::shared_ptr<const learning::Model> model;
  std::shared_ptr<const std::vector<std::uint8_t>> policy;  ///< Greedy, of `model`; may be null as it may.
  std::vector<spatial::CellIndex> streamlines;              ///< Where they start; empty: none.
};

struct StageOptions {
  bool arms = true;
  bool lattice_frame = false;  ///< The edges of the learning cube.
  bool scale_bar = true;       ///< 10 mm on the board's edge, with its label.
  bool labels = true;          ///< Peg numbers, axes.
  bool light_ground = false;  ///< For a light window: table and background; films and rendered views keep the dark one.
  int highlighted_block = -1;
  /// To the right of the picture, W: the scale bar lies across the view, in front of the pegs.
  Eigen::Vector3d camera_right{0.0, 1.0, 0.0};
};

struct Meshes;

/// The meshes of `assets`, loaded once. Threads: immutable after `load`; any.
class Stage {
 public:
  /// Errors: kIo, kCorrupt naming the mesh.
  static Result<std::shared_ptr<const Stage>> load();

  scene::Scene scene(const Pose3d& pose, const std::vector<PathLayer>& paths, const std::vector<FieldLayer>& fields,
                     const StageOptions& options) const;
  /// Nodes and quads of the fields alone, and the edges of a lattice: for who keeps the former from picture to picture.
  scene::Scene field_scene(const std::vector<FieldLayer>& fields) const;
  void add_lattice_frame(const spatial::Grid& grid, scene::Scene& scene) const;
  /// Both arms of another state, to be seen through: what somebody else does meanwhile.
  void add_ghost(const Pose3d& pose, float opacity, scene::Scene& scene) const;

 private:
  std::shared_ptr<const Meshes> meshes_;
};

/// The gated path of a tip, coloured by segment (Okabe–Ito); of a long one about 20,000 points.
PathLayer path_of(const demonstration::Demonstration& demonstration, kinematics::ArmSide side);

/// The picture with the scene's labels, as a fresh `LabelPainter` draws them.
Image with_labels(const Image& picture, const scene::Scene& scene, const scene::Camera& camera);

}  // namespace trocar::stage
