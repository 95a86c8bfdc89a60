#include "engine/stage/occlusion.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <utility>

namespace trocar::stage {
namespace {

using Eigen::Vector3f;

constexpr float kOpaqueFrom = 0.6F;
/// A label sits on what it names, which does not hide it.
constexpr double kTouch_m = 0.0015;

/// A mesh's middle and how far it reaches from there, in its own frame.
std::pair<Vector3f, float> extent(const scene::Mesh& mesh) {
  if (mesh.positions.empty()) return {Vector3f::Zero(), 0.0F};
  Vector3f low = mesh.positions.front();
  Vector3f high = low;
  for (const Vector3f& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return {0.5F * (low + high), 0.5F * (high - low).norm()};
}

/// Whether the way from `from` by `way` enters a triangle from its outside.
bool enters(const Vector3f& from, const Vector3f& way, const Vector3f& a, const Vector3f& b, const Vector3f& c) {
  const Vector3f ab = b - a;
  const Vector3f ac = c - a;
  const Vector3f p = way.cross(ac);
  const float determinant = ab.dot(p);
  if (!(determinant > 0.0F)) return false;  // Seen from behind, or along it.
  const Vector3f s = from - a;
  const float u = s.dot(p);
  if (u < 0.0F || u > determinant) return false;
  const Vector3f q = s.cross(ab);
  const float v = way.dot(q);
  if (v < 0.0F || u + v > determinant) return false;
  const float t = ac.dot(q);
  return t >= 0.0F && t <= determinant;
}

/// Whether the way from `from` by `way` goes through a texel of the quad that is opaque enough.
bool pierces(const Vector3f& from, const Vector3f& way, const scene::Quad& quad) {
  const Vector3f normal = quad.u.cross(quad.v);
  const float across = normal.dot(way);
  if (across == 0.0F) return false;
  const float t = normal.dot(quad.origin - from) / across;
  if (t < 0.0F || t > 1.0F) return false;
  const Vector3f at = from + t * way - quad.origin;
  const float u = at.dot(quad.u) / quad.u.squaredNorm();
  const float v = at.dot(quad.v) / quad.v.squaredNorm();
  if (u < 0.0F || v < 0.0F || u >= 1.0F || v >= 1.0F) return false;
  const Image& texture = *quad.texture;
  const int column = std::clamp(static_cast<int>(u * static_cast<float>(texture.width)), 0, texture.width - 1);
  const int row = std::clamp(static_cast<int>((1.0F - v) * static_cast<float>(texture.height)), 0, texture.height - 1);
  return quad.opacity * static_cast<float>(texture.at(column, row).a) / 255.0F >= kOpaqueFrom;
}

}  // namespace

Occlusion::Occlusion(const scene::Scene& scene) {
  std::map<const scene::Mesh*, std::pair<Vector3f, float>> extents;
  for (const scene::Node& node : scene.nodes) {
    if (node.mesh == nullptr || node.material.base_colour.w() < kOpaqueFrom) continue;
    const auto [found, added] = extents.try_emplace(node.mesh.get());
    if (added) found->second = extent(*node.mesh);
    const float scale = node.X_WM.topLeftCorner<3, 3>().colwise().norm().maxCoeff();
    bodies_.push_back({node.mesh.get(), node.X_WM, (node.X_WM * found->second.first.homogeneous()).head<3>(),
                       scale * found->second.second});
  }
  for (const scene::Quad& quad : scene.quads) {
    const bool drawn = quad.texture != nullptr && !quad.texture->empty();
    if (drawn && quad.opacity >= kOpaqueFrom) sheets_.push_back(&quad);
  }
}

bool Occlusion::hides(const Eigen::Vector3d& p_WEye, const Eigen::Vector3d& p_WPoint) const {
  const double distance_m = (p_WPoint - p_WEye).norm();
  if (distance_m <= kTouch_m) return false;
  const Vector3f from = p_WEye.cast<float>();
  const Vector3f way = ((p_WPoint - p_WEye) * (1.0 - kTouch_m / distance_m)).cast<float>();
  const auto pierced = [&](const scene::Quad* quad) { return pierces(from, way, *quad); };
  if (std::any_of(sheets_.begin(), sheets_.end(), pierced)) return true;
  for (const Body& body : bodies_) {
    const float along = std::clamp((body.centre_W - from).dot(way) / way.squaredNorm(), 0.0F, 1.0F);
    if ((from + along * way - body.centre_W).squaredNorm() > body.radius_m * body.radius_m) continue;
    const Eigen::Matrix4f X_MW = body.X_WM.inverse();
    const Vector3f from_M = (X_MW * from.homogeneous()).head<3>();
    const Vector3f way_M = X_MW.topLeftCorner<3, 3>() * way;
    const scene::Mesh& mesh = *body.mesh;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      if (enters(from_M, way_M, mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]],
                 mesh.positions[mesh.indices[i + 2]])) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace trocar::stage
