/// Meshes put together, each part in a colour of its own.
#pragma once

#include "engine/scene/scene.h"

namespace trocar::stage {

/// Adds `part`, turned by R_WM, scaled and moved, to `whole`, all of whose vertices have colours.
void add_part(const scene::Mesh& part, const Eigen::Matrix3d& R_WM, const Eigen::Vector3d& scale,
              const Eigen::Vector3d& p_W, Rgba colour, scene::Mesh& whole);
/// A rotation that takes z to `direction`. Precondition: unit length.
Eigen::Matrix3d z_towards(const Eigen::Vector3d& direction);
/// Along +z from 0 to 1 with radius 1: a head for arrows, closed. Precondition: sides ≥ 3.
scene::Mesh cone(int sides);
/// The direction of an action, W.
Eigen::Vector3d direction_of(int action);
/// A node of what was put together, shown in its own colours with a little shade; nothing for an empty mesh.
void add_drawn(scene::Mesh whole, float opacity, scene::Scene& scene);

}  // namespace trocar::stage
