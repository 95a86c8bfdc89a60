/// Paths as tubes.
#pragma once

#include "engine/scene/scene.h"
#include "engine/stage/stage.h"

namespace trocar::stage {

/// Adds the path as one tube for each run of equal colour. Points that a straight line passes within a twentieth of a
/// millimetre are left out; a path of one colour for each point keeps those that are 0.35 mm apart.
/// Precondition: `colours` has one entry, or one for each point.
void add_path(const PathLayer& layer, scene::Scene& scene);

/// The points that stay, as indices, first and last among them: none left out is farther than `tolerance_m` from the
/// line between its neighbours that stay.
std::vector<std::size_t> simplified(const std::vector<Eigen::Vector3d>& points, double tolerance_m);

}  // namespace trocar::stage
