/// The grips of the slices in the 3-D view: a drag moves a slice along its axis, the wheel steps it by a cell.
#pragma once

#include <optional>

#include "ui/panel.h"
#include "ui/slice_grips.h"

namespace trocar::ui {

class SliceOverlay {
 public:
  /// Right after the canvas of the picture. True if the mouse is a grip's and not the camera's.
  bool take_mouse(Ui& ui, const WorkbenchState& state, const ViewPort& view, bool hovered, Requests& requests);
  /// Over the picture.
  void draw(Ui& ui, const WorkbenchState& state, const ViewPort& view) const;

 private:
  struct Drag {
    SliceGrip grip;  ///< When it began.
    Eigen::Vector2f from;
  };
  std::optional<Drag> drag_;
  int hovered_ = -1;  ///< Axis of the grip under the mouse.
};

}  // namespace trocar::ui
