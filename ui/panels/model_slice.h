/// One slice of a model's field as a square picture, as the Models panel lays them beside each other.
#pragma once

#include <string_view>

#include "ui/panel.h"
#include "ui/panels/field_shading.h"

namespace trocar::ui {

/// The slice across `axis` that the settings have; where they have none, the one through the selected model's goal.
/// Precondition: there is an insight with a field.
int model_slice_index(const WorkbenchState& state, int axis);

/// The wheel over the last item steps the slice.
void step_model_slice(const WorkbenchState& state, int axis, Requests& requests);

struct ModelSliceOptions {
  std::string_view label;  ///< Of the item.
  std::string_view title;  ///< Above the picture.
  int axis = 2;
  float side = 0.0F;  ///< Pixels.
};
/// A title and the picture below it, as one item of the layout.
void draw_model_slice(Ui& ui, const WorkbenchState& state, const FieldShading& shading,
                      const ModelSliceOptions& options, Requests& requests);

/// The slice over `rect`, between two shares of its width.
void paint_model_slice(Ui& ui, const WorkbenchState& state, const FieldShading& shading, std::string_view key, int axis,
                       const Rect& rect, float from = 0.0F, float to = 1.0F);

}  // namespace trocar::ui
