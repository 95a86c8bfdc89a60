#include "engine/stage/meshes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/file.h"
#include "engine/peg_board/peg_board.h"
#include "engine/scene/mesh_import.h"
#include "engine/scene/primitives.h"
#include "engine/stage/palette.h"

namespace trocar::stage {
namespace {

/// Where the opaque part of the shaft's mesh ends (tools/make_meshes.py), and how much more fades away.
constexpr double kShaftEnd_m = 0.034;
constexpr double kShaftFade_m = 0.034;

scene::Mesh ring(double radius_m, double thickness_m) {
  constexpr int kCorners = 48;
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCorners;
    points.emplace_back(radius_m * std::cos(angle), radius_m * std::sin(angle), 0.0);
  }
  return scene::tube(points, {}, thickness_m, 6);
}

}  // namespace

Result<std::shared_ptr<const Meshes>> Meshes::load() {
  auto meshes = std::make_shared<Meshes>();
  const std::pair<MeshPointer*, const char*> files[] = {
      {&meshes->board, "board"},
      {&meshes->table, "table"},
      {&meshes->peg, "peg"},
      {&meshes->block, "block"},
      {&meshes->shaft, "psm_shaft"},
      {&meshes->shaft_pin, "psm_shaft_pin"},
      {&meshes->shaft_band, "psm_shaft_band"},
      {&meshes->wrist, "psm_wrist"},
      {&meshes->wrist_pin, "psm_wrist_pin"},
      {&meshes->jaw, "psm_jaw"},
  };
  for (const auto& [mesh, name] : files) {
    TROCAR_ASSIGN_OR_RETURN(*mesh, scene::import_mesh(share_path("assets/meshes") / (std::string(name) + ".ply")));
  }
  const std::array<Eigen::Vector3d, 2> tube{Eigen::Vector3d(0.0, 0.0, -kShaftEnd_m),
                                            Eigen::Vector3d(0.0, 0.0, -kShaftEnd_m - kShaftFade_m)};
  meshes->shaft_end = std::make_shared<const scene::Mesh>(scene::tube(tube, palette::kShaftFade, 0.0042, 32));
  meshes->cube = std::make_shared<const scene::Mesh>(scene::unit_cube());
  meshes->axis = std::make_shared<const scene::Mesh>(scene::arrow(0.009F, 0.00045F, 0.0028F, 0.0011F));
  meshes->highlight_ring = std::make_shared<const scene::Mesh>(ring(1.25 * peg_board::kBlockCircumradius_m, 0.0004));
  return meshes;
}

}  // namespace trocar::stage
