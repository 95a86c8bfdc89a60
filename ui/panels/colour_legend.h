/// The colour bar of a field, or the list of its classes.
#pragma once

#include "ui/panels/field_shading.h"
#include "ui/widgets/widgets.h"

namespace trocar::ui {

/// As wide as what is left of the region; `marked` is shown as a tick on the bar if it is a number.
void colour_legend(Ui& ui, const FieldShading& shading, double marked);
/// Diagonal lines: nothing is known here.
void draw_hatch(Ui& ui, const Rect& rect);

}  // namespace trocar::ui
