/// The handles that move and turn a tool in the 3-D view: where they lie on the picture, which one is under the
/// pointer, and how far a drag goes. No drawing, so that it can be tested.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/scene.h"
#include "engine/spatial/pose.h"
#include "engine/workbench/command.h"
#include "ui/widgets/item_log.h"

namespace trocar::ui {

/// A picture on the screen and the camera that it was taken with. Pixels from the window's top left.
struct ViewPort {
  scene::Camera camera;
  Rect rect;

  /// Nothing for a point behind the camera.
  std::optional<Eigen::Vector2f> pixel(const Eigen::Vector3d& p_W) const;
  /// Origin and unit direction, W.
  std::array<Eigen::Vector3d, 2> ray(const Eigen::Vector2f& pixel) const;
  /// How wide a pixel is at that point, in metres.
  double pixel_m(const Eigen::Vector3d& p_W) const;
};

enum class HandleKind : std::uint8_t { kAxis, kPlane, kCentre, kRing };
struct Handle {
  HandleKind kind = HandleKind::kCentre;
  int axis = 0;  ///< Along it, normal to the plane, or about it; unused by the centre.
  bool operator==(const Handle&) const = default;
};
/// "X", "YZ", "Centre", "Turn X".
std::string name_of(const Handle& handle);

/// A handle as it lies on the picture.
struct HandleShape {
  Handle handle;
  std::vector<Eigen::Vector2f> points;  ///< A line, or the outline of a plane or ring.
  Eigen::Vector2f grip;                 ///< Where a hand takes it, and its letter stands.
};

/// Of the gizmo at a pose (its axes are the handles'), `length_px` long; the ones that cannot be seen or used from here
/// (an axis that points at the eye, a ring seen from its edge) are left out; arrows that would end beyond the picture are
/// shorter or point the other way. The nearest to the eye last.
std::vector<HandleShape> handle_shapes(const workbench::GizmoSettings& settings, const spatial::Pose& X_WG,
                                       const ViewPort& view, float length_px);

/// The handle within `reach_px` of a pixel, if any; small ones win.
std::optional<Handle> handle_at(const std::vector<HandleShape>& shapes, const Eigen::Vector2f& pixel, float reach_px);

/// How far a drag between two pixels moves the gizmo, in metres, W. Zero where the view allows no answer.
Eigen::Vector3d dragged_by(const Handle& handle, const spatial::Pose& X_WG, const ViewPort& view,
                           const Eigen::Vector2f& from, const Eigen::Vector2f& to);
/// How far it turns about the ring's axis, in radians, right-handed.
double turned_by(const Handle& handle, const spatial::Pose& X_WG, const ViewPort& view, const Eigen::Vector2f& from,
                 const Eigen::Vector2f& to);

}  // namespace trocar::ui
