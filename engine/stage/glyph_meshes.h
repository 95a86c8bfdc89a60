/// Glyphs on the slices of a field.
#pragma once

#include "engine/scene/primitives.h"
#include "engine/stage/stage.h"

namespace trocar::stage {

/// Adds what `layer.glyphs` asks for in each cell of the slices for which the policy has an action, one mesh: nothing
/// without a model and its policy. The greedy action is white, the others are dark.
void add_glyphs(const FieldLayer& layer, scene::Scene& scene);

}  // namespace trocar::stage
