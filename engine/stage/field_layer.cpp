#include "engine/stage/field_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "engine/core/check.h"
#include "engine/learning/slab.h"
#include "engine/scene/primitives.h"
#include "engine/stage/glyph_meshes.h"
#include "engine/stage/iso_surface.h"
#include "engine/stage/palette.h"
#include "engine/stage/streamlines.h"

namespace trocar::stage {
namespace {

using Eigen::Vector3d;

/// Texels a cell is wide; even, so that a cut through the middle of a cell falls between texels.
constexpr int kTexels = 8;
constexpr Rgba kUnknownFill{120, 128, 140, 26};
constexpr Rgba kUnknownHatch{200, 206, 214, 96};
constexpr Rgba kEdge{240, 243, 247, 255};

/// A slice's plane: `normal` is the axis it is cut across, `u` runs along the texture's columns and `v` up its rows.
struct Plane {
  int normal;
  int u;
  int v;
};
constexpr std::array<Plane, 3> kPlanes{Plane{0, 1, 2}, Plane{1, 0, 2}, Plane{2, 1, 0}};

spatial::CellIndex cell_at(const spatial::Grid& grid, const Plane& plane, int slice, int column, int row) {
  std::array<int, 3> at{};
  at[static_cast<std::size_t>(plane.normal)] = slice;
  at[static_cast<std::size_t>(plane.u)] = column;
  at[static_cast<std::size_t>(plane.v)] = row;
  return grid.index({at[0], at[1], at[2]});
}

Rgba darker(Rgba colour) {
  const auto scaled = [](std::uint8_t c) { return static_cast<std::uint8_t>(c * 7 / 8); };
  return {scaled(colour.r), scaled(colour.g), scaled(colour.b), colour.a};
}

void paint_cell(Image& image, int left, int top, const std::optional<Rgba>& colour) {
  for (int y = 0; y < kTexels; ++y) {
    for (int x = 0; x < kTexels; ++x) {
      Rgba texel = kUnknownFill;
      if (colour) {
        // A thin line at two sides tells neighbouring cells apart.
        texel = x == 0 || y == 0 ? darker(*colour) : *colour;
      } else if ((x + y) % kTexels == kTexels - 1) {
        texel = kUnknownHatch;
      }
      image.set(left + x, top + y, texel);
    }
  }
}

Image paint_slice(const FieldLayer& layer, const Plane& plane, int slice) {
  const int n = layer.field->grid.n;
  Image image(n * kTexels, n * kTexels);
  const int thickness = layer.slabs[static_cast<std::size_t>(plane.normal)];
  const learning::Field shown = learning::with_slab(*layer.field, plane.normal, slice, thickness, layer.through);
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const spatial::CellIndex cell = cell_at(layer.field->grid, plane, slice, column, row);
      const Rgba colour = layer.colouring.colour(shown.values[static_cast<std::size_t>(cell.value)]);
      paint_cell(image, column * kTexels, (n - 1 - row) * kTexels,
                 colour.a == 0 ? std::nullopt : std::optional(colour));
    }
  }
  const int last = n * kTexels - 1;
  for (int i = 0; i <= last; ++i) {
    for (const auto& [x, y] : {std::array{i, 0}, std::array{i, last}, std::array{0, i}, std::array{last, i}}) {
      image.set(x, y, kEdge);
    }
  }
  return image;
}

/// Where the slices across `axis`'s direction cut it, in texels from the low end, with both ends.
std::vector<int> cuts(const FieldLayer& layer, int axis) {
  const int n = layer.field->grid.n;
  std::vector<int> at{0};
  const int slice = layer.slices[static_cast<std::size_t>(axis)];
  if (slice >= 0 && slice < n) at.push_back(slice * kTexels + kTexels / 2);
  at.push_back(n * kTexels);
  return at;
}

Image cropped(const Image& image, int left, int top, int width, int height) {
  Image part(width, height);
  for (int y = 0; y < height; ++y) {
    const auto from = image.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(top + y) * image.width + left);
    std::copy(from, from + 4 * static_cast<std::ptrdiff_t>(width),
              part.rgba.begin() + 4 * static_cast<std::ptrdiff_t>(y) * width);
  }
  return part;
}

void add_slice(const FieldLayer& layer, const Plane& plane, scene::Scene& scene) {
  const spatial::Grid& grid = layer.field->grid;
  const int slice = layer.slices[static_cast<std::size_t>(plane.normal)];
  if (slice < 0 || slice >= grid.n) return;
  const Image whole = paint_slice(layer, plane, slice);
  const double texel_m = grid.cell_m / kTexels;
  const std::vector<int> columns = cuts(layer, plane.u);
  const std::vector<int> rows = cuts(layer, plane.v);
  for (std::size_t c = 0; c + 1 < columns.size(); ++c) {
    for (std::size_t r = 0; r + 1 < rows.size(); ++r) {
      const int width = columns[c + 1] - columns[c];
      const int height = rows[r + 1] - rows[r];
      Vector3d p_GQ = Vector3d::Zero();
      p_GQ[plane.normal] = (slice + 0.5) * grid.cell_m;
      p_GQ[plane.u] = columns[c] * texel_m;
      p_GQ[plane.v] = rows[r] * texel_m;
      scene::Quad quad;
      quad.origin = (grid.p_WGo + p_GQ).cast<float>();
      quad.u = Eigen::Vector3f::Unit(plane.u) * static_cast<float>(width * texel_m);
      quad.v = Eigen::Vector3f::Unit(plane.v) * static_cast<float>(height * texel_m);
      quad.texture =
          std::make_shared<const Image>(cropped(whole, columns[c], grid.n * kTexels - rows[r + 1], width, height));
      quad.opacity = layer.opacity;
      scene.quads.push_back(quad);
    }
  }
}

std::vector<std::uint8_t> cells_above(const FieldLayer& layer) {
  const learning::Field& field = *layer.field;
  std::vector<std::uint8_t> above(field.values.size(), 0);
  for (std::size_t s = 0; s < above.size(); ++s) {
    const double value = field.values[s];
    above[s] = std::isfinite(value) && layer.colouring.scale.position(value) >= layer.voxel_threshold ? 1 : 0;
  }
  return above;
}

/// All six neighbours are drawn too.
bool hidden(const spatial::Grid& grid, const std::vector<std::uint8_t>& drawn, spatial::CellIndex cell) {
  for (int action = 0; action < spatial::kActionCount; ++action) {
    const auto next = grid.neighbour(cell, static_cast<spatial::Action>(action));
    if (!next || drawn[static_cast<std::size_t>(next->value)] == 0) return false;
  }
  return true;
}

void add_voxels(const Meshes& meshes, const FieldLayer& layer, scene::Scene& scene) {
  const spatial::Grid& grid = layer.field->grid;
  const std::vector<std::uint8_t> drawn = cells_above(layer);
  const Eigen::Vector3f size = Eigen::Vector3f::Constant(static_cast<float>(0.86 * grid.cell_m));
  for (int s = 0; s < grid.cell_count(); ++s) {
    const spatial::CellIndex cell{s};
    if (drawn[static_cast<std::size_t>(s)] == 0 || hidden(grid, drawn, cell)) continue;
    const std::optional<Rgba> colour = colour_of(layer, cell);
    if (!colour) continue;
    scene::Node node;
    node.mesh = meshes.cube;
    node.material = palette::material(*colour, 0.9F, 0.0F);
    node.material.base_colour.w() = layer.opacity;
    node.material.emission = 0.6F;
    node.material.casts_shadow = false;
    node.X_WM = scene::node_pose(spatial::Pose::translation(grid.centre(cell)), size);
    scene.nodes.push_back(node);
  }
}

void add_surface(const FieldLayer& layer, scene::Scene& scene) {
  if (!layer.iso_level || layer.field->categorical) return;
  scene::Mesh mesh = iso_surface(*layer.field, layer.colouring.scale.value(*layer.iso_level));
  if (mesh.indices.empty()) return;
  scene::Node node;
  node.mesh = std::make_shared<const scene::Mesh>(std::move(mesh));
  node.material = palette::material(layer.colouring.colour_at(*layer.iso_level), 0.6F, 0.0F);
  node.material.base_colour.w() = layer.opacity;
  node.material.emission = 0.25F;
  node.material.casts_shadow = false;
  scene.nodes.push_back(std::move(node));
}

bool same_scale(const plot::Scale& a, const plot::Scale& b) {
  const bool ranked = a.sorted == b.sorted || (a.sorted && b.sorted && *a.sorted == *b.sorted);
  return a.kind == b.kind && a.low == b.low && a.high == b.high && a.linear == b.linear && ranked;
}

}  // namespace

bool same_drawing(const FieldLayer& a, const FieldLayer& b) {
  const plot::Colouring& left = a.colouring;
  const plot::Colouring& right = b.colouring;
  return a.field == b.field && a.slices == b.slices && a.slabs == b.slabs && a.through == b.through &&
         a.voxels == b.voxels && a.voxel_threshold == b.voxel_threshold && a.iso_level == b.iso_level &&
         a.glyphs == b.glyphs && a.opacity == b.opacity && a.model == b.model && a.policy == b.policy &&
         a.streamlines == b.streamlines && left.map == right.map && left.vision == right.vision &&
         left.categories == right.categories && same_scale(left.scale, right.scale);
}

std::optional<Rgba> colour_of(const FieldLayer& layer, spatial::CellIndex cell) {
  const Rgba colour = layer.colouring.colour(layer.field->values[static_cast<std::size_t>(cell.value)]);
  if (colour.a == 0) return std::nullopt;
  return colour;
}

void add_field(const Meshes& meshes, const FieldLayer& layer, scene::Scene& scene) {
  if (layer.field == nullptr) return;
  TROCAR_CHECK(layer.field->values.size() == static_cast<std::size_t>(layer.field->grid.cell_count()));
  for (const Plane& plane : kPlanes) add_slice(layer, plane, scene);
  if (layer.voxels) add_voxels(meshes, layer, scene);
  add_surface(layer, scene);
  add_glyphs(layer, scene);
  if (layer.model != nullptr && layer.policy != nullptr && !layer.streamlines.empty()) {
    add_streamlines(layer.model->grid, streamlines(*layer.model, *layer.policy, layer.streamlines), scene);
  }
}

}  // namespace trocar::stage
