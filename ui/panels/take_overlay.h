/// What lies over the 3-D view while something is recorded: the red frame and its words, the countdown, what the arms
/// cannot do; and the mouse, which drags the tools.
#pragma once

#include <optional>

#include "ui/gizmo.h"
#include "ui/panel.h"

namespace trocar::ui {

class TakeOverlay {
 public:
  /// Right after the canvas of the picture. True if the mouse is on a tool and not the camera's.
  bool take_mouse(Ui& ui, const WorkbenchState& state, const ViewPort& view, bool hovered, Requests& requests);
  /// Where the tools will go, over the picture.
  void draw_marks(Ui& ui, const WorkbenchState& state, const ViewPort& view) const;
  /// Over all that; its words stand above `bottom`.
  void draw(Ui& ui, const WorkbenchState& state, const ViewPort& view, float bottom) const;

 private:
  struct Drag {
    kinematics::ArmSide arm = kinematics::ArmSide::kLeft;
    Eigen::Vector2f last;             ///< Where the pointer was.
    Eigen::Vector3d left_W{0, 0, 0};  ///< In step mode: the way that is not yet a cell.
    /// Of a waypoint that is dragged by one: which, and where pointer and waypoint were when it began.
    std::optional<Handle> handle;
    Eigen::Vector2f from;
    spatial::Pose X_WT;
  };
  void begin(const WorkbenchState& state, kinematics::ArmSide arm);
  void follow(const WorkbenchState& state, const ViewPort& view, float wheel, Requests& requests);

  void draw_handles(Ui& ui, const WorkbenchState& state, const ViewPort& view) const;

  std::optional<Drag> drag_;
  std::optional<Handle> hovered_;  ///< A waypoint's handle under the pointer.
};

}  // namespace trocar::ui
