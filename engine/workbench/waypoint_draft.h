/// A displacement that is being given to a tool at an instant: that of the waypoint there, or of a new one.
#pragma once

#include <cstdint>

#include "engine/demonstration/waypoints.h"
#include "engine/workbench/command.h"

namespace trocar::workbench {

struct WaypointDraft {
  demonstration::Edit edit;  ///< A MoveTool or a RotateTool.
  std::int64_t entry = 0;    ///< Of the stack, which it changes; 0: it adds one.
};

/// As the settings want it, without a displacement yet if there is no such waypoint at `at_s`.
/// Precondition: `settings.kind` is not `kNone`.
WaypointDraft draft_at(const demonstration::Demonstration& shown, const GizmoSettings& settings, double at_s);

/// The displacement so far: metres in W, or a rotation vector in radians in the frame of the edit.
Eigen::Vector3d displacement_of(const WaypointDraft& draft);
double radius_of(const WaypointDraft& draft);
demonstration::Falloff falloff_of(const WaypointDraft& draft);

WaypointDraft with_displacement(WaypointDraft draft, const Eigen::Vector3d& by);
WaypointDraft with_reach(WaypointDraft draft, double radius_s, demonstration::Falloff falloff);
/// Moved or turned by that much more.
WaypointDraft displaced_further(WaypointDraft draft, const Eigen::Vector3d& by);

/// The commands that show it and that make it.
PreviewEdit preview_of(const WaypointDraft& draft);
CommitEdit commit_of(DemonstrationId demonstration, const WaypointDraft& draft);

}  // namespace trocar::workbench
