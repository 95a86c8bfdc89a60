/// What a field has along the three lines of cells through one of them.
#pragma once

#include "ui/panel.h"
#include "ui/panels/field_shading.h"

namespace trocar::ui {

/// A row of bars along each axis, as high as their value lies on the scale and in its colour; the cell is marked.
/// Precondition: `at` is in the lattice of the shading.
void draw_field_lines(Ui& ui, const FieldShading& shading, const spatial::CellCoordinates& at);

}  // namespace trocar::ui
