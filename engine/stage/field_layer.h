/// Fields over the lattice: slices, voxels, surfaces, and what their models would do.
#pragma once

#include "engine/scene/scene.h"
#include "engine/stage/meshes.h"
#include "engine/stage/stage.h"

namespace trocar::stage {

/// Adds what the layer asks for. A slice outside of the lattice is left out, as is a layer without a field.
/// Slices that cross are cut along each other, so that each piece is wholly in front of or behind any other.
void add_field(const Meshes& meshes, const FieldLayer& layer, scene::Scene& scene);

/// The same drawing in the scene; cheap, but for a scale of rank it compares all values.
bool same_drawing(const FieldLayer& a, const FieldLayer& b);

/// A field's colour at a cell; nothing where it is unknown.
std::optional<Rgba> colour_of(const FieldLayer& layer, spatial::CellIndex cell);

}  // namespace trocar::stage
