/// What is shown of a field and how: its layer, its colours, and what is drawn of it in the 3-D view.
#pragma once

#include "ui/panel.h"
#include "ui/panels/field_shading.h"
#include "ui/panels/opacity_editor.h"

namespace trocar::ui {

/// `montage` follows the choice between three slices and all of them.
void draw_field_controls(Ui& ui, const WorkbenchState& state, const FieldShading& shading, OpacityEditor& opacity,
                         bool& montage, Requests& requests);

}  // namespace trocar::ui
