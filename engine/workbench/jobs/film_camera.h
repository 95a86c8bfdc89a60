/// Where the camera of a film's source is at an instant.
#pragma once

#include <Eigen/Core>

#include "engine/film/composition.h"
#include "engine/scene/scene.h"

namespace trocar::workbench {

/// `film_s` counts in the pass; `p_WT` is the tool that is followed. A picture narrower than 16:9 is opened up until it
/// shows as much of the board's width.
scene::Camera film_camera(const film::Source& source, double film_s, const Eigen::Vector3d& p_WT, int width,
                          int height);

film::View film_view(scene::CameraPreset preset);

}  // namespace trocar::workbench
