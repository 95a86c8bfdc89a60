/// A scene put in the order in which it is drawn: opaque things by mesh, see-through things from far to near.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/render/items.h"
#include "engine/scene/scene.h"

namespace trocar::render {

/// Some instances of one mesh, next to each other in `DrawList::instances`; those that cast a shadow come first.
struct Batch {
  const GpuMesh* mesh = nullptr;
  std::size_t first = 0;
  std::size_t count = 0;
  std::size_t caster_count = 0;
  bool matte = false;  ///< All of it can do without highlights.
};

/// One step of the see-through pass: a batch, or a quad of the scene if `quad` ≥ 0.
struct BlendStep {
  Batch batch;
  int quad = -1;
};

struct DrawList {
  std::vector<Instance> instances;
  std::vector<Batch> opaque;  ///< Small things first: what they hide is then not shaded.
  std::vector<BlendStep> blended;
};

/// Of the scene's nodes and then its quads, those marked in `wanted`. Precondition: something of these is to be drawn
/// (`Item::source`).
DrawList make_draw_list(const scene::Scene& scene, const scene::Camera& camera, MeshCache& cache,
                        const std::vector<std::uint8_t>& wanted);

}  // namespace trocar::render
