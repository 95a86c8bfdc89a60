/// The colour bar of a field, or the list of its classes.
#pragma once

#include <array>
#include <optional>

#include "ui/panels/field_shading.h"
#include "ui/widgets/widgets.h"

namespace trocar::ui {

struct LegendOptions {
  bool stale = false;                           ///< The field is of a demonstration that was edited since.
  std::optional<std::array<double, 2>> limits;  ///< Of the colours; none: fitted to the field.
};

/// As wide as what is left of the region, with a histogram over it; `marked` is shown as a tick on the bar if it is a
/// number. Returns the limits, which the mouse may have moved, or freed by a double click.
std::optional<std::array<double, 2>> colour_legend(Ui& ui, const FieldShading& shading, double marked,
                                                   const LegendOptions& options);
/// Diagonal lines: nothing is known here.
void draw_hatch(Ui& ui, const Rect& rect);

}  // namespace trocar::ui
