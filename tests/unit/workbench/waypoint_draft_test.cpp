#include "engine/workbench/waypoint_draft.h"

#include <doctest/doctest.h>

#include <numbers>

#include "engine/demonstration/edits.h"
#include "tests/support/document_samples.h"

namespace trocar::workbench {
namespace {

using demonstration::MoveTool;
using Eigen::Vector3d;

GizmoSettings gizmo(GizmoKind kind) {
  GizmoSettings settings;
  settings.kind = kind;
  settings.radius_s = 0.4;
  return settings;
}

}  // namespace

TEST_CASE("a tool that is moved where there is no waypoint gets one, with the reach that was asked for") {
  const auto document = testing::moving_demonstration(800);
  const WaypointDraft draft = draft_at(document, gizmo(GizmoKind::kMove), 2.0);
  CHECK(draft.entry == 0);
  CHECK(displacement_of(draft) == Vector3d::Zero());
  CHECK(radius_of(draft) == 0.4);
  const CommitEdit commit = commit_of({1}, displaced_further(draft, {0.0, 0.0025, 0.0}));
  const auto& edit = std::get<EditDemonstration>(commit.edit);
  CHECK(std::get<MoveTool>(edit.edit).by_m == Vector3d(0.0, 0.0025, 0.0));
  CHECK(std::get<MoveTool>(edit.edit).at_s == 2.0);
}

TEST_CASE("moved where there is one, it goes further by the same edit, which keeps its own reach") {
  const auto first = testing::moving_demonstration(800);
  const MoveTool move{demonstration::Arms::kLeft, 2.0, {0.001, 0.0, 0.0}, 0.25, demonstration::Falloff::kSharp};
  const auto document = demonstration::apply(first, move, 11).value();
  const WaypointDraft draft = draft_at(document, gizmo(GizmoKind::kMove), 2.0);
  CHECK(draft.entry == 11);
  const CommitEdit commit = commit_of({1}, displaced_further(draft, {0.002, 0.0, 0.0}));
  const auto& edit = std::get<ReplaceStackEntry>(commit.edit);
  CHECK(edit.entry == 11);
  CHECK(std::get<MoveTool>(edit.edit).by_m.isApprox(Vector3d(0.003, 0.0, 0.0)));
  CHECK(std::get<MoveTool>(edit.edit).radius_s == 0.25);
  CHECK(std::get<MoveTool>(edit.edit).falloff == demonstration::Falloff::kSharp);
}

TEST_CASE("two turns follow each other in the tool's frame or in the board's") {
  const auto document = testing::moving_demonstration(800);
  constexpr double kQuarter = std::numbers::pi / 2.0;
  GizmoSettings settings = gizmo(GizmoKind::kTurn);
  const auto twice = [&](const Vector3d& first, const Vector3d& then) {
    return displacement_of(displaced_further(displaced_further(draft_at(document, settings, 2.0), first), then));
  };
  CHECK(twice({kQuarter, 0.0, 0.0}, {kQuarter, 0.0, 0.0}).norm() == doctest::Approx(std::numbers::pi));
  // A quarter about x and then about the tool's own y is a third of a turn about (1, 1, 1); about the board's y it is
  // one about (1, 1, −1).
  const double third = 2.0 * std::numbers::pi / 3.0 / std::sqrt(3.0);
  CHECK(twice({kQuarter, 0.0, 0.0}, {0.0, kQuarter, 0.0}).isApprox(Vector3d(third, third, third)));
  settings.frame = demonstration::TurnFrame::kBoard;
  CHECK(twice({kQuarter, 0.0, 0.0}, {0.0, kQuarter, 0.0}).isApprox(Vector3d(third, third, -third)));
}

}  // namespace trocar::workbench
