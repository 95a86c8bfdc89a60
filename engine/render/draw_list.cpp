#include "engine/render/draw_list.h"

#include <algorithm>
#include <map>
#include <utility>

namespace trocar::render {
namespace {

/// From here on a highlight is not worth its cost.
constexpr float kMatteRoughness = 0.9F;

bool matte(const scene::Material& material) {
  return (material.roughness >= kMatteRoughness && material.metallic <= 0.0F) || material.emission >= 1.0F;
}

struct Group {
  const GpuMesh* mesh = nullptr;
  bool matte = false;
  std::vector<std::size_t> casters;
  std::vector<std::size_t> others;
};

using Wanted = std::vector<std::uint8_t>;

void add_opaque(const scene::Scene& scene, const Wanted& wanted, MeshCache& cache, DrawList& list) {
  std::vector<Group> groups;
  std::map<std::pair<const scene::Mesh*, bool>, std::size_t> group_of;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const scene::Node& node = scene.nodes[i];
    if (wanted[i] == 0 || node.material.base_colour.w() < kOpaqueFrom) continue;
    const auto [found, added] = group_of.try_emplace({node.mesh.get(), matte(node.material)}, groups.size());
    if (added) groups.push_back({&cache.mesh(node.mesh), matte(node.material), {}, {}});
    Group& group = groups[found->second];
    (node.material.casts_shadow ? group.casters : group.others).push_back(i);
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.mesh->radius_m < b.mesh->radius_m; });
  for (const Group& group : groups) {
    list.opaque.push_back({group.mesh, list.instances.size(), group.casters.size() + group.others.size(),
                           group.casters.size(), group.matte});
    for (const std::size_t i : group.casters) list.instances.push_back(instance_of(scene.nodes[i]));
    for (const std::size_t i : group.others) list.instances.push_back(instance_of(scene.nodes[i]));
  }
}

struct SeeThrough {
  double depth = 0.0;
  const scene::Node* node = nullptr;
  int quad = -1;
};

double distance(const scene::Camera& camera, const Eigen::Vector3d& p_W) {
  const Eigen::Vector3d from_eye = p_W - camera.X_WC.p;
  return camera.orthographic ? from_eye.dot(camera.X_WC.q * Eigen::Vector3d::UnitZ()) : from_eye.squaredNorm();
}

std::vector<SeeThrough> see_through(const scene::Scene& scene, const scene::Camera& camera, const Wanted& wanted,
                                    MeshCache& cache) {
  std::vector<SeeThrough> found;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const scene::Node& node = scene.nodes[i];
    if (wanted[i] == 0 || node.material.base_colour.w() >= kOpaqueFrom) continue;
    const Eigen::Vector3f centre = (node.X_WM * cache.mesh(node.mesh).centre.homogeneous()).head<3>();
    found.push_back({distance(camera, centre.cast<double>()), &node, -1});
  }
  for (std::size_t i = 0; i < scene.quads.size(); ++i) {
    const scene::Quad& quad = scene.quads[i];
    if (wanted[scene.nodes.size() + i] == 0) continue;
    const Eigen::Vector3f centre = quad.origin + 0.5F * (quad.u + quad.v);
    found.push_back({distance(camera, centre.cast<double>()), nullptr, static_cast<int>(i)});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const SeeThrough& a, const SeeThrough& b) { return a.depth > b.depth; });
  return found;
}

}  // namespace

DrawList make_draw_list(const scene::Scene& scene, const scene::Camera& camera, MeshCache& cache,
                        const Wanted& wanted) {
  DrawList list;
  list.instances.reserve(scene.nodes.size());
  add_opaque(scene, wanted, cache, list);
  for (const SeeThrough& item : see_through(scene, camera, wanted, cache)) {
    if (item.node == nullptr) {
      list.blended.push_back({{}, item.quad});
      continue;
    }
    const GpuMesh* mesh = &cache.mesh(item.node->mesh);
    if (list.blended.empty() || list.blended.back().batch.mesh != mesh) {
      list.blended.push_back({{mesh, list.instances.size(), 0, 0, false}, -1});
    }
    ++list.blended.back().batch.count;
    list.instances.push_back(instance_of(*item.node));
  }
  return list;
}

}  // namespace trocar::render
