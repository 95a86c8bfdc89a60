/// Where the shadows of things that move can fall: along the light, but only onto what is there to be darkened.
#pragma once

#include <vector>

#include "engine/render/damage.h"
#include "engine/render/items.h"
#include "engine/render/mesh_cache.h"
#include "engine/scene/scene.h"

namespace trocar::render {

/// Holds pointers into the cache: use it before the cache drops anything.
class ShadowSweep {
 public:
  /// `reach_m`: how far beside its exact place a shadow still darkens.
  ShadowSweep(const scene::Scene& scene, const std::vector<Item>& items, const Changes& changes, MeshCache& cache,
              const Eigen::Vector3f& light, float reach_m);

  /// Adds what a body with these corners may darken.
  void add(const Corners& corners, Damage& damage) const;

 private:
  struct Box {
    Eigen::Vector3f low;
    Eigen::Vector3f high;
    bool meets(const Box& other) const;
    bool holds(const Box& other) const;
    Corners corners() const;
  };
  /// A convex body that stays where it is: what is beyond it is in its own shadow already.
  struct Solid {
    Box box;
    Eigen::Matrix4f X_MW;
    const GpuMesh* mesh = nullptr;
    bool holds(const Box& other) const;
  };
  static Box around(const Corners& corners);
  bool inside_a_solid(const Box& slab) const;

  Eigen::Vector3f light_;
  float reach_m_;
  float floor_z_m_ = 0.0F;
  std::vector<Box> receivers_;
  std::vector<Solid> solids_;
};

}  // namespace trocar::render
