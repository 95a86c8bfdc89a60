/// Meshes made from numbers: what stands for a cell, an edge, an axis or a path.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "engine/scene/scene.h"

namespace trocar::scene {

/// Edges of 1, centred at the origin.
Mesh unit_cube();

/// Along +z from 0 to `length_m`: a cylinder with a cone on its last `head_m`. Precondition: all > 0, head < length.
Mesh arrow(float length_m, float radius_m, float head_m, float head_radius_m);

/// A closed tube through `points`, without twist. `colours` is empty, or one for each point.
/// Points that coincide with the one before are passed over; fewer than two different ones give an empty mesh.
/// Precondition: radius > 0, sides ≥ 3, all points finite.
Mesh tube(std::span<const Eigen::Vector3d> points, std::span<const Rgba> colours, double radius_m, int sides);

/// A pose as a node's matrix, with an optional scale along the mesh's own axes.
Eigen::Matrix4f node_pose(const spatial::Pose& X_WM, const Eigen::Vector3f& scale = Eigen::Vector3f::Ones());

}  // namespace trocar::scene
