/// The stage's meshes, loaded or made once.
#pragma once

#include <memory>

#include "engine/core/result.h"
#include "engine/scene/scene.h"
#include "engine/stage/stage.h"

namespace trocar::stage {

using MeshPointer = std::shared_ptr<const scene::Mesh>;

struct Meshes {
  MeshPointer board, table, peg, block;
  MeshPointer shaft, shaft_pin, shaft_band, wrist, wrist_pin, jaw;
  MeshPointer shaft_end;       ///< In the shaft's frame: the tube from where the opaque part ends, fading upwards.
  MeshPointer cube;            ///< Edges of 1.
  MeshPointer axis;            ///< An arrow along z, 9 mm long.
  MeshPointer highlight_ring;  ///< Round a block at the origin, flat in x and y.

  /// Errors: kIo, kCorrupt naming the mesh.
  static Result<std::shared_ptr<const Meshes>> load();
};

}  // namespace trocar::stage
