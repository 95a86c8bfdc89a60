#include "engine/workbench/waypoint_draft.h"

#include <Eigen/Geometry>
#include <utility>
#include <variant>

namespace trocar::workbench {
namespace {

using demonstration::MoveTool;
using demonstration::RotateTool;

template <typename Displacement>
WaypointDraft found_or(const demonstration::Demonstration& shown, Displacement fresh) {
  if (auto there = demonstration::waypoint_at(shown, fresh)) return {std::move(there->edit), there->entry};
  return {std::move(fresh), 0};
}

Eigen::Quaterniond rotation_of(const Eigen::Vector3d& by_rad) {
  const double angle = by_rad.norm();
  return angle == 0.0 ? Eigen::Quaterniond::Identity() : Eigen::Quaterniond(Eigen::AngleAxisd(angle, by_rad / angle));
}

Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& q) {
  const Eigen::AngleAxisd turn(q.w() < 0.0 ? Eigen::Quaterniond(-q.coeffs()) : q);
  return turn.angle() * turn.axis();
}

}  // namespace

WaypointDraft draft_at(const demonstration::Demonstration& shown, const GizmoSettings& settings, double at_s) {
  if (settings.kind == GizmoKind::kTurn) {
    return found_or(shown, RotateTool{settings.arms, at_s, Eigen::Vector3d::Zero(), settings.frame, settings.radius_s,
                                      settings.falloff});
  }
  return found_or(shown, MoveTool{settings.arms, at_s, Eigen::Vector3d::Zero(), settings.radius_s, settings.falloff});
}

Eigen::Vector3d displacement_of(const WaypointDraft& draft) {
  if (const auto* turn = std::get_if<RotateTool>(&draft.edit)) return turn->by_rad;
  return std::get<MoveTool>(draft.edit).by_m;
}

double radius_of(const WaypointDraft& draft) {
  if (const auto* turn = std::get_if<RotateTool>(&draft.edit)) return turn->radius_s;
  return std::get<MoveTool>(draft.edit).radius_s;
}

demonstration::Falloff falloff_of(const WaypointDraft& draft) {
  if (const auto* turn = std::get_if<RotateTool>(&draft.edit)) return turn->falloff;
  return std::get<MoveTool>(draft.edit).falloff;
}

WaypointDraft with_displacement(WaypointDraft draft, const Eigen::Vector3d& by) {
  if (auto* turn = std::get_if<RotateTool>(&draft.edit)) turn->by_rad = by;
  if (auto* move = std::get_if<MoveTool>(&draft.edit)) move->by_m = by;
  return draft;
}

WaypointDraft with_reach(WaypointDraft draft, double radius_s, demonstration::Falloff falloff) {
  const auto set = [&](auto& edit) {
    edit.radius_s = radius_s;
    edit.falloff = falloff;
  };
  if (auto* turn = std::get_if<RotateTool>(&draft.edit)) set(*turn);
  if (auto* move = std::get_if<MoveTool>(&draft.edit)) set(*move);
  return draft;
}

WaypointDraft displaced_further(WaypointDraft draft, const Eigen::Vector3d& by) {
  const Eigen::Vector3d before = displacement_of(draft);
  if (!std::holds_alternative<RotateTool>(draft.edit)) return with_displacement(std::move(draft), before + by);
  // In the tool's frame the later turn is about axes that the earlier one has turned.
  const bool tool = std::get<RotateTool>(draft.edit).frame == demonstration::TurnFrame::kTool;
  const Eigen::Quaterniond first = rotation_of(before);
  const Eigen::Quaterniond then = rotation_of(by);
  return with_displacement(std::move(draft), rotation_vector(tool ? first * then : then * first));
}

PreviewEdit preview_of(const WaypointDraft& draft) {
  return {draft.edit, draft.entry};
}

CommitEdit commit_of(DemonstrationId demonstration, const WaypointDraft& draft) {
  if (draft.entry == 0) return {EditDemonstration{demonstration, draft.edit}};
  return {ReplaceStackEntry{demonstration, draft.entry, draft.edit}};
}

}  // namespace trocar::workbench
