/// One arm as nodes: shaft, wrist and both jaws, articulated from its joints.
#pragma once

#include <vector>

#include "engine/kinematics/psm.h"
#include "engine/scene/scene.h"
#include "engine/stage/meshes.h"

namespace trocar::stage {

/// `jaw_rad` is the full opening between the jaws; both lie against each other at 0 and below.
void add_arm(const Meshes& meshes, kinematics::ArmSide side, const kinematics::Joints& joints, double jaw_rad,
             std::vector<scene::Node>& nodes);

}  // namespace trocar::stage
