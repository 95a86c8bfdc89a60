#include "engine/render/shadow_sweep.h"

#include <Eigen/LU>
#include <algorithm>
#include <cstddef>

namespace trocar::render {
namespace {

/// Light that falls at less than this is too flat to follow.
constexpr float kLeastFall = 0.2F;
/// How far a body is followed down at a time.
constexpr float kStep_m = 0.004F;
constexpr int kMostSteps = 100;

}  // namespace

bool ShadowSweep::Box::meets(const Box& other) const {
  return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
}

bool ShadowSweep::Box::holds(const Box& other) const {
  return (low.array() <= other.low.array()).all() && (other.high.array() <= high.array()).all();
}

Corners ShadowSweep::Box::corners() const {
  Corners corners;
  for (int i = 0; i < 8; ++i) {
    corners.col(i) << ((i & 1) != 0 ? high : low).x(), ((i & 2) != 0 ? high : low).y(), ((i & 4) != 0 ? high : low).z();
  }
  return corners;
}

bool ShadowSweep::Solid::holds(const Box& other) const {
  if (!box.holds(other)) return false;
  const Eigen::Matrix<float, 4, 8> p_M = X_MW * other.corners().colwise().homogeneous();
  return std::all_of(mesh->sides.begin(), mesh->sides.end(),
                     [&p_M](const Eigen::Vector4f& side) { return (side.transpose() * p_M).maxCoeff() <= 0.0F; });
}

ShadowSweep::Box ShadowSweep::around(const Corners& corners) {
  return {corners.rowwise().minCoeff(), corners.rowwise().maxCoeff()};
}

ShadowSweep::ShadowSweep(const scene::Scene& scene, const std::vector<Item>& items, const Changes& changes,
                         MeshCache& cache, const Eigen::Vector3f& light, float reach_m)
    : light_(light), reach_m_(reach_m) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Item& item = items[i];
    if (item.source == 0) continue;
    // What changed is drawn anew wherever it is.
    if (std::find(changes.come.begin(), changes.come.end(), &item) != changes.come.end()) continue;
    const Box box = around(item.corners);
    receivers_.push_back(box);
    floor_z_m_ = std::min(floor_z_m_, box.low.z());
    const GpuMesh& mesh = cache.mesh(scene.nodes[i].mesh);
    if (!mesh.sides.empty() && item.casts_shadow) solids_.push_back({box, scene.nodes[i].X_WM.inverse(), &mesh});
  }
}

bool ShadowSweep::inside_a_solid(const Box& slab) const {
  return std::any_of(solids_.begin(), solids_.end(), [&slab](const Solid& solid) { return solid.holds(slab); });
}

void ShadowSweep::add(const Corners& corners, Damage& damage) const {
  if (-light_.z() < kLeastFall) return damage.add_all();
  const float way_m = (corners.row(2).maxCoeff() + reach_m_ - floor_z_m_) / -light_.z();
  const int steps = std::clamp(static_cast<int>(way_m / kStep_m) + 1, 1, kMostSteps);
  const Eigen::Vector3f step = light_ * (std::max(way_m, 0.0F) / static_cast<float>(steps));
  const Box start = around(corners);
  const Eigen::Vector3f reach = Eigen::Vector3f::Constant(reach_m_);
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector3f from = start.low + static_cast<float>(i) * step;
    const Eigen::Vector3f to = start.high + static_cast<float>(i) * step;
    const Box slab{from.cwiseMin(from + step) - reach, to.cwiseMax(to + step) + reach};
    if (inside_a_solid(slab)) return;
    for (const Box& receiver : receivers_) {
      if (!slab.meets(receiver)) continue;
      damage.add(Box{slab.low.cwiseMax(receiver.low), slab.high.cwiseMin(receiver.high)}.corners());
    }
  }
}

}  // namespace trocar::render
