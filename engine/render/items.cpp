#include "engine/render/items.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace trocar::render {
namespace {

/// Nothing nearer to the eye than this can be bounded.
constexpr float kNearest = 1e-4F;
/// What rounding and several samples a pixel may add.
constexpr float kRounding_px = 2.0F;

Corners box_corners(const Eigen::Matrix4f& X_WM, const GpuMesh& mesh) {
  Corners corners;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3f sign((i & 1) != 0 ? 1.0F : -1.0F, (i & 2) != 0 ? 1.0F : -1.0F, (i & 4) != 0 ? 1.0F : -1.0F);
    const Eigen::Vector3f p_M = mesh.centre + sign.cwiseProduct(mesh.half_size);
    corners.col(i) = (X_WM * p_M.homogeneous()).head<3>();
  }
  return corners;
}

Item item_of(const scene::Node& node, MeshCache& cache) {
  Item item;
  if (node.mesh == nullptr || node.material.base_colour.w() <= 0.0F) return item;
  const GpuMesh& mesh = cache.mesh(node.mesh);
  item.source = mesh.serial;
  item.look = instance_of(node);
  item.casts_shadow = node.material.casts_shadow && node.material.base_colour.w() >= kOpaqueFrom;
  item.corners = box_corners(node.X_WM, mesh);
  return item;
}

Item item_of(const scene::Quad& quad, MeshCache& cache) {
  Item item;
  if (quad.texture == nullptr || quad.texture->empty() || quad.opacity <= 0.0F) return item;
  item.source = cache.texture(quad.texture).serial;
  item.look.X_WM << quad.u, quad.v, Eigen::Vector3f::Zero(), quad.origin;
  item.look.base_colour = Eigen::Vector4f(0.0F, 0.0F, 0.0F, quad.opacity);
  item.look.material.setZero();
  for (int i = 0; i < 8; ++i) {
    item.corners.col(i) = quad.origin + static_cast<float>(i & 1) * quad.u + static_cast<float>(i >> 1 & 1) * quad.v;
  }
  return item;
}

}  // namespace

bool Item::operator==(const Item& other) const {
  if (source == 0 || other.source == 0) return source == other.source;
  return source == other.source && casts_shadow == other.casts_shadow && look.X_WM == other.look.X_WM &&
         look.base_colour == other.look.base_colour && look.material == other.look.material;
}

Instance instance_of(const scene::Node& node) {
  const scene::Material& material = node.material;
  return {node.X_WM.topRows<3>(), material.base_colour,
          Eigen::Vector4f(material.roughness, material.metallic, material.emission, 0.0F)};
}

std::vector<Item> items_of(const scene::Scene& scene, MeshCache& cache) {
  std::vector<Item> items;
  items.reserve(scene.nodes.size() + scene.quads.size());
  for (const scene::Node& node : scene.nodes) items.push_back(item_of(node, cache));
  for (const scene::Quad& quad : scene.quads) items.push_back(item_of(quad, cache));
  return items;
}

bool PixelBox::meets(const PixelBox& other) const {
  return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
}

PixelBox PixelBox::with(const PixelBox& other) const {
  return {std::min(left, other.left), std::min(top, other.top), std::max(right, other.right),
          std::max(bottom, other.bottom)};
}

std::optional<PixelBox> bounds(const Corners& corners, const Window& window) {
  const Eigen::Matrix<float, 4, 8> clip = window.clip_from_world * corners.colwise().homogeneous();
  const float nearest = clip.row(3).minCoeff();
  if (!(nearest > kNearest)) return std::nullopt;
  const Eigen::Array2f size(static_cast<float>(window.width), static_cast<float>(window.height));
  const Eigen::Array<float, 2, 8> at =
      (0.5F + 0.5F * (clip.topRows<2>().array().rowwise() / clip.row(3).array())).colwise() * size;
  // Far outside is as good as outside, and whole numbers stay small.
  const Eigen::Array2f low = (at.rowwise().minCoeff() - kRounding_px).floor().max(-16.0F).min(size + 16.0F);
  const Eigen::Array2f high = (at.rowwise().maxCoeff() + kRounding_px).ceil().max(-16.0F).min(size + 16.0F);
  return PixelBox{static_cast<int>(low.x()), static_cast<int>(low.y()), static_cast<int>(high.x()),
                  static_cast<int>(high.y())};
}

}  // namespace trocar::render
