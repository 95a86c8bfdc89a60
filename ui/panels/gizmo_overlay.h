/// The handles on the tool at the playhead, over the 3-D view, and the waypoints that were set before: a drag is
/// previewed while it lasts and is one edit when it ends.
#pragma once

#include <memory>
#include <optional>

#include "engine/workbench/waypoint_draft.h"
#include "ui/gizmo.h"
#include "ui/panel.h"

namespace trocar::ui {

class GizmoOverlay {
 public:
  /// Right after the canvas of the picture. True if the mouse is the gizmo's and not the camera's.
  bool take_mouse(Ui& ui, const WorkbenchState& state, const ViewPort& view, bool hovered, Requests& requests);
  /// Over the picture.
  void draw(Ui& ui, const WorkbenchState& state, const ViewPort& view) const;

 private:
  struct Drag {
    Handle handle;
    Eigen::Vector2f from;
    spatial::Pose X_WG;  ///< When it began.
    ViewPort view;
    std::shared_ptr<const demonstration::Demonstration> shown;
    workbench::WaypointDraft before;
    workbench::WaypointDraft now;
  };

  void begin(const WorkbenchState& state, const ViewPort& view, const Handle& handle, const Eigen::Vector2f& mouse);
  void follow(Ui& ui, const Eigen::Vector2f& mouse, Requests& requests);
  void end(const WorkbenchState& state, bool commit, Requests& requests);
  bool click_waypoint(Ui& ui, const WorkbenchState& state, const ViewPort& view, const Eigen::Vector2f& mouse,
                      Requests& requests) const;
  void draw_waypoints(Ui& ui, const WorkbenchState& state, const ViewPort& view) const;
  void draw_handles(Ui& ui, const WorkbenchState& state, const ViewPort& view) const;

  std::optional<Drag> drag_;
  std::optional<Handle> hovered_;
  bool given_up_ = false;  ///< Escape was pressed in a drag; until the button is let go the mouse does nothing.
};

/// Where the pointer is, in pixels.
Eigen::Vector2f mouse_now();
/// One handle as it lies on the picture; `taken`: under the pointer or in a drag.
void draw_handle(Ui& ui, const HandleShape& shape, bool taken);
/// Names a handle for scripts; what hangs over the edge of the picture is out of their reach.
void note_grip(Ui& ui, std::string_view label, std::string_view value, const Eigen::Vector2f& p, const Rect& picture);

/// True while the gizmo can be used: a demonstration is selected and stands still.
bool gizmo_shown(const WorkbenchState& state);

}  // namespace trocar::ui
