/// Where a field has one value.
#pragma once

#include "engine/learning/field.h"
#include "engine/scene/scene.h"

namespace trocar::stage {

/// The surface around the cells whose value is at least `level`, in W, metres; values are linear between the middles of
/// cells (marching tetrahedra). It is always closed: where what is known ends, or the lattice, it runs half-way to the
/// cells beyond. Its normals point to smaller values: against the field's gradient, and where that is not known as the
/// triangles do. Empty if no cell is above.
/// Precondition: one value for each cell.
scene::Mesh iso_surface(const learning::Field& field, double level);

}  // namespace trocar::stage
