/// What is drawn over the picture of a slice so that it can be read on its own: the safe set, the expert's cells, start
/// and goal.
#pragma once

#include "engine/learning/model.h"
#include "ui/widgets/widgets.h"

namespace trocar::ui {

struct SlicePlace {
  int axis = 2;
  int index = 0;
  Rect rect;  ///< Of the whole slice, pixels.
};

/// The outline of the safe set and a dot in each cell of the demonstrations.
void draw_slice_outline(const Ui& ui, const learning::Model& model, const SlicePlace& place);
/// "S" and "G" where the slice cuts start and goal.
void draw_slice_ends(Ui& ui, const learning::Model& model, const SlicePlace& place);

}  // namespace trocar::ui
