#include "engine/stage/glyphs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "engine/core/check.h"
#include "engine/learning/rollout.h"
#include "engine/stage/glyph_meshes.h"
#include "engine/stage/mesh_parts.h"

namespace trocar::stage {
namespace {

constexpr std::array<std::string_view, 3> kGlyphNames{"none", "best", "stars"};
constexpr Rgba kBest{255, 255, 255, 255};
constexpr Rgba kArm{34, 38, 46, 255};
/// In cells.
constexpr double kArmLength = 0.44;
constexpr double kLeastArm = 0.10;
constexpr double kArmWidth = 0.06;
constexpr double kBestWidth = 0.11;
constexpr double kShaftRadius = 0.06;
constexpr double kPointRadius = 0.20;
constexpr double kPointLength = 0.36;
constexpr double kArrowReach = 0.40;
constexpr int kPointSides = 8;

/// 0 … 1 for each action, by Q among those of the cell that are finite; NaN for the others.
std::array<double, spatial::kActionCount> shares(const learning::Model& model, spatial::CellIndex cell) {
  std::array<double, spatial::kActionCount> share{};
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (int action = 0; action < spatial::kActionCount; ++action) {
    const double q = model.q_at(cell, static_cast<spatial::Action>(action));
    share[static_cast<std::size_t>(action)] = std::isfinite(q) ? q : std::numeric_limits<double>::quiet_NaN();
    if (!std::isfinite(q)) continue;
    low = std::min(low, q);
    high = std::max(high, q);
  }
  for (double& one : share) one = high > low ? (one - low) / (high - low) : one - low;
  return share;
}

void add_star(const learning::Model& model, spatial::CellIndex cell, std::uint8_t best, const scene::Mesh& cube,
              scene::Mesh& whole) {
  const double cell_m = model.grid.cell_m;
  const auto share = shares(model, cell);
  for (int action = 0; action < spatial::kActionCount; ++action) {
    const double one = share[static_cast<std::size_t>(action)];
    if (!std::isfinite(one)) continue;
    const bool is_best = action == static_cast<int>(best);
    const double length = cell_m * (kLeastArm + (kArmLength - kLeastArm) * one);
    const double width = cell_m * (is_best ? kBestWidth : kArmWidth);
    const Eigen::Vector3d along = direction_of(action);
    add_part(cube, z_towards(along), {width, width, length}, model.grid.centre(cell) + 0.5 * length * along,
             is_best ? kBest : kArm, whole);
  }
}

void add_arrow(const spatial::Grid& grid, spatial::CellIndex cell, std::uint8_t best, const scene::Mesh& cube,
               const scene::Mesh& point, scene::Mesh& whole) {
  const double cell_m = grid.cell_m;
  const Eigen::Vector3d along = direction_of(best);
  const Eigen::Matrix3d R = z_towards(along);
  const Eigen::Vector3d middle = grid.centre(cell);
  const double shaft = cell_m * (2.0 * kArrowReach - kPointLength);
  const double radius = cell_m * kPointRadius;
  add_part(cube, R, {2.0 * kShaftRadius * cell_m, 2.0 * kShaftRadius * cell_m, shaft},
           middle + (0.5 * shaft - kArrowReach * cell_m) * along, kBest, whole);
  add_part(point, R, {radius, radius, kPointLength * cell_m}, middle + (shaft - kArrowReach * cell_m) * along, kBest,
           whole);
}

}  // namespace

std::string_view to_string(Glyphs glyphs) {
  return kGlyphNames[static_cast<std::size_t>(glyphs)];
}

const std::vector<Glyphs>& all_glyphs() {
  static const std::vector<Glyphs> all{Glyphs::kNone, Glyphs::kBest, Glyphs::kStars};
  return all;
}

Result<Glyphs> glyphs_from(std::string_view text) {
  for (const Glyphs glyphs : all_glyphs()) {
    if (to_string(glyphs) == text) return glyphs;
  }
  return fail(ErrorCode::kInvalidArgument,
              "no glyphs are named \"" + std::string(text) + "\"; there are none, best, stars");
}

void add_glyphs(const FieldLayer& layer, scene::Scene& scene) {
  if (layer.glyphs == Glyphs::kNone || layer.model == nullptr || layer.policy == nullptr) return;
  const learning::Model& model = *layer.model;
  TROCAR_CHECK(layer.policy->size() == static_cast<std::size_t>(model.grid.cell_count()));
  const scene::Mesh cube = scene::unit_cube();
  const scene::Mesh point = cone(kPointSides);
  scene::Mesh whole;
  for (int s = 0; s < model.grid.cell_count(); ++s) {
    const spatial::CellCoordinates c = model.grid.coordinates({s});
    if (c.x != layer.slices[0] && c.y != layer.slices[1] && c.z != layer.slices[2]) continue;
    const std::uint8_t best = (*layer.policy)[static_cast<std::size_t>(s)];
    if (best == learning::kNoAction) continue;
    if (layer.glyphs == Glyphs::kStars) {
      add_star(model, {s}, best, cube, whole);
    } else {
      add_arrow(model.grid, {s}, best, cube, point, whole);
    }
  }
  add_drawn(std::move(whole), 1.0F, scene);
}

}  // namespace trocar::stage
