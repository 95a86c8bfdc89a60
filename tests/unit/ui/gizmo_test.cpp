#include "ui/gizmo.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "engine/workbench/edit.h"
#include "tests/support/ui_desk.h"
#include "tests/support/ui_state.h"

namespace trocar::ui {
namespace {

using demonstration::MoveTool;
using demonstration::RotateTool;
using Eigen::Vector2f;
using Eigen::Vector3d;
using workbench::GizmoKind;
using workbench::GizmoSettings;

const ViewPort kView{scene::Camera::look_at({0.15, -0.12, 0.14}, {0.0, 0.0, 0.02}), {100.0F, 50.0F, 900.0F, 650.0F}};
const spatial::Pose kGizmo{{0.01, -0.02, 0.03}, Eigen::Quaterniond::Identity()};

GizmoSettings gizmo(GizmoKind kind) {
  GizmoSettings settings;
  settings.kind = kind;
  return settings;
}

Vector2f pixel(const Vector3d& p_W) {
  return kView.pixel(p_W).value();
}

/// A window whose tool is in hand.
struct ToolDesk : Desk {
  explicit ToolDesk(GizmoKind kind) : Desk(with(kind)) {
    CHECK(text_of(driver().click("Menu/Workspaces/Author")) == "");
    CHECK(driver().frames(6));
    commands.clear();
  }
  static workbench::WorkbenchState with(GizmoKind kind) {
    workbench::WorkbenchState state = testing::made_state();
    state.gizmo.kind = kind;
    return state;
  }
  template <typename Edit>
  const Edit* committed() const {
    const auto* commit = last<workbench::CommitEdit>();
    if (commit == nullptr) return nullptr;
    const auto* edit = std::get_if<workbench::EditDemonstration>(&commit->edit);
    return edit == nullptr ? nullptr : std::get_if<Edit>(&edit->edit);
  }
};

}  // namespace

TEST_CASE("a drag along an axis or in a plane keeps what was taken under the pointer") {
  const Vector3d taken = kGizmo.p + Vector3d(0.004, 0.0, 0.0);
  const Vector3d by(0.0065, 0.0, 0.0);
  CHECK(dragged_by({HandleKind::kAxis, 0}, kGizmo, kView, pixel(taken), pixel(taken + by)).isApprox(by, 1e-4));
  const Vector3d in_plane(0.003, -0.005, 0.0);
  const Vector3d corner = kGizmo.p + Vector3d(0.002, 0.002, 0.0);
  const Vector3d got = dragged_by({HandleKind::kPlane, 2}, kGizmo, kView, pixel(corner), pixel(corner + in_plane));
  CHECK((got - in_plane).norm() < 2e-7);
  CHECK(std::abs(got.z()) < 1e-12);
}

TEST_CASE("a drag of the centre moves across the view and not along it") {
  const Vector3d by =
      dragged_by({HandleKind::kCentre, 0}, kGizmo, kView, pixel(kGizmo.p), pixel(kGizmo.p) + Vector2f(40.0F, -25.0F));
  CHECK(by.norm() > 0.001);
  CHECK(std::abs(by.dot(kView.camera.X_WC.rotation().col(2))) < 1e-12);
  CHECK((pixel(kGizmo.p + by) - pixel(kGizmo.p) - Vector2f(40.0F, -25.0F)).norm() < 0.01F);
}

TEST_CASE("a drag along a ring turns by the angle that it covers, right-handed") {
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d u = Vector3d::Unit((axis + 1) % 3);
    const Vector3d v = Vector3d::Unit((axis + 2) % 3);
    const auto on_ring = [&](double angle) {
      return pixel(kGizmo.p + 0.02 * (std::cos(angle) * u + std::sin(angle) * v));
    };
    CHECK(turned_by({HandleKind::kRing, axis}, kGizmo, kView, on_ring(0.3), on_ring(0.8)) ==
          doctest::Approx(0.5).epsilon(1e-4));
    CHECK(turned_by({HandleKind::kRing, axis}, kGizmo, kView, on_ring(0.3), on_ring(-0.9)) ==
          doctest::Approx(-1.2).epsilon(1e-4));
  }
}

TEST_CASE("an axis that points at the eye and a ring seen from its edge are not offered") {
  const ViewPort above{scene::camera(scene::CameraPreset::kTop), {0.0F, 0.0F, 800.0F, 600.0F}};
  const spatial::Pose below{{above.camera.X_WC.p.x(), above.camera.X_WC.p.y(), 0.03}, Eigen::Quaterniond::Identity()};
  const auto has = [](const std::vector<HandleShape>& shapes, Handle wanted) {
    return std::any_of(shapes.begin(), shapes.end(), [&](const HandleShape& s) { return s.handle == wanted; });
  };
  const auto arrows = handle_shapes(gizmo(GizmoKind::kMove), below, above, 80.0F);
  CHECK(has(arrows, {HandleKind::kAxis, 0}));
  CHECK(has(arrows, {HandleKind::kAxis, 1}));
  CHECK_FALSE(has(arrows, {HandleKind::kAxis, 2}));
  const auto rings = handle_shapes(gizmo(GizmoKind::kTurn), below, above, 80.0F);
  CHECK(has(rings, {HandleKind::kRing, 2}));
  CHECK_FALSE(has(rings, {HandleKind::kRing, 0}));
}

TEST_CASE("a handle is under the pointer near it, and nothing is far from all of them") {
  const auto shapes = handle_shapes(gizmo(GizmoKind::kMove), kGizmo, kView, 80.0F);
  for (const HandleShape& shape : shapes) {
    CAPTURE(name_of(shape.handle));
    CHECK(handle_at(shapes, shape.grip, 9.0F) == shape.handle);
  }
  CHECK_FALSE(handle_at(shapes, pixel(kGizmo.p) + Vector2f(300.0F, 0.0F), 9.0F));
  GizmoSettings only_y = gizmo(GizmoKind::kMove);
  only_y.axis = 1;
  const auto one = handle_shapes(only_y, kGizmo, kView, 80.0F);
  REQUIRE(one.size() == 1);
  CHECK(name_of(one[0].handle) == "Y");
}

TEST_CASE("a drag of an arrow is previewed while it lasts and committed once, along that axis alone") {
  ToolDesk desk(GizmoKind::kMove);
  CHECK(text_of(desk.driver().drag("View/Gizmo/X", 30.0F, 20.0F)) == "");
  CHECK(desk.last<workbench::PreviewEdit>() != nullptr);
  const auto* move = desk.committed<MoveTool>();
  REQUIRE(move != nullptr);
  CHECK(move->at_s == 2.0);
  CHECK(std::abs(move->by_m.x()) > 1e-4);
  CHECK(move->by_m.y() == 0.0);
  CHECK(move->by_m.z() == 0.0);
  CHECK(desk.last<workbench::EndPreview>() != nullptr);
  CHECK(desk.last<workbench::SetCamera>() == nullptr);
  CHECK(std::count_if(desk.commands.begin(), desk.commands.end(), [](const workbench::Command& command) {
          return std::holds_alternative<workbench::CommitEdit>(command);
        }) == 1);
}

TEST_CASE("Escape in a drag leaves the tool where it was, and the mouse does nothing more until it is let go") {
  ToolDesk desk(GizmoKind::kMove);
  const Item handle = desk.driver().item("View/Gizmo/Y").value();
  InputQueue& input = desk.window.input();
  input.push(MouseMoved{handle.rect.centre_x(), handle.rect.centre_y()});
  CHECK(desk.driver().frames(1));
  input.push(MouseButton{0, true});
  input.push(MouseMoved{handle.rect.centre_x() + 40.0F, handle.rect.centre_y()});
  CHECK(desk.driver().frames(3));
  CHECK(desk.last<workbench::PreviewEdit>() != nullptr);
  CHECK(desk.driver().key("Escape"));
  input.push(MouseMoved{handle.rect.centre_x() + 80.0F, handle.rect.centre_y()});
  CHECK(desk.driver().frames(2));
  input.push(MouseButton{0, false});
  CHECK(desk.driver().frames(2));
  CHECK(desk.last<workbench::CommitEdit>() == nullptr);
  CHECK(desk.last<workbench::EndPreview>() != nullptr);
  CHECK(desk.last<workbench::SetCamera>() == nullptr);
}

TEST_CASE("with Ctrl held a tool moves by whole cells") {
  ToolDesk desk(GizmoKind::kMove);
  const Item handle = desk.driver().item("View/Gizmo/Z").value();
  InputQueue& input = desk.window.input();
  input.push(MouseMoved{handle.rect.centre_x(), handle.rect.centre_y()});
  input.push(KeyChanged{Key::kLeftControl, true});
  CHECK(desk.driver().frames(2));
  input.push(MouseButton{0, true});
  input.push(MouseMoved{handle.rect.centre_x(), handle.rect.centre_y() - 31.0F});
  CHECK(desk.driver().frames(3));
  input.push(MouseButton{0, false});
  input.push(KeyChanged{Key::kLeftControl, false});
  CHECK(desk.driver().frames(3));
  const auto* move = desk.committed<MoveTool>();
  REQUIRE(move != nullptr);
  const double cells = move->by_m.z() / 0.0025;
  CHECK(cells > 0.5);
  CHECK(cells == doctest::Approx(std::round(cells)));
}

TEST_CASE("a displacement that is typed is an edit on Enter, and what is no number is none") {
  ToolDesk desk(GizmoKind::kMove);
  CHECK(text_of(desk.driver().type("View/Tool/dz, mm", "2.5")) == "");
  const auto* move = desk.committed<MoveTool>();
  REQUIRE(move != nullptr);
  CHECK(move->by_m.isApprox(Vector3d(0.0, 0.0, 0.0025)));
  desk.commands.clear();
  CHECK(text_of(desk.driver().type("View/Tool/dz, mm", "far")) == "");
  CHECK(desk.last<workbench::CommitEdit>() == nullptr);
}

TEST_CASE("a turn about the tool's own axis is typed in degrees") {
  ToolDesk desk(GizmoKind::kTurn);
  CHECK(text_of(desk.driver().type("View/Tool/rx, °", "-30")) == "");
  const auto* turn = desk.committed<RotateTool>();
  REQUIRE(turn != nullptr);
  CHECK(turn->by_rad.x() == doctest::Approx(-std::numbers::pi / 6.0));
  CHECK(turn->frame == demonstration::TurnFrame::kTool);
}

TEST_CASE("arrow keys nudge a tool in hand by a cell, and without one go through time") {
  ToolDesk desk(GizmoKind::kMove);
  CHECK(desk.driver().key("Ctrl+Right"));
  REQUIRE(desk.committed<MoveTool>() != nullptr);
  CHECK(desk.committed<MoveTool>()->by_m.isApprox(Vector3d(0.0025, 0.0, 0.0)));
  CHECK(desk.last<workbench::SetPlayhead>() == nullptr);
  CHECK(desk.driver().key("Ctrl+Shift+PageDown"));
  CHECK(desk.committed<MoveTool>()->by_m.isApprox(Vector3d(0.0, 0.0, -0.0005)));
  desk.state.gizmo.kind = GizmoKind::kNone;
  desk.commands.clear();
  CHECK(desk.driver().key("Ctrl+Right"));
  CHECK(desk.last<workbench::CommitEdit>() == nullptr);
  CHECK(desk.last<workbench::SetPlayhead>() != nullptr);
}

TEST_CASE("X puts the keyboard into the field of that axis, and Escape lets go of it and then of the tool") {
  ToolDesk desk(GizmoKind::kMove);
  CHECK(desk.driver().key("Y"));
  REQUIRE(desk.last<workbench::SetGizmo>() != nullptr);
  desk.state.gizmo = desk.last<workbench::SetGizmo>()->settings;
  CHECK(desk.state.gizmo.axis == 1);
  CHECK(desk.driver().frames(4));
  for (const char digit : std::string("7.5")) {
    desk.window.input().push(Typed{static_cast<std::uint32_t>(digit)});
  }
  CHECK(desk.driver().frames(1));
  CHECK(desk.driver().key("Enter"));
  CHECK(desk.driver().frames(2));
  REQUIRE(desk.committed<MoveTool>() != nullptr);
  CHECK(desk.committed<MoveTool>()->by_m.isApprox(Vector3d(0.0, 0.0075, 0.0)));
  CHECK(desk.driver().key("Escape"));
  CHECK(desk.last<workbench::SetGizmo>()->settings.axis == -1);
  CHECK(desk.last<workbench::SetGizmo>()->settings.kind == GizmoKind::kMove);
  desk.state.gizmo = desk.last<workbench::SetGizmo>()->settings;
  CHECK(desk.driver().key("Escape"));
  CHECK(desk.last<workbench::SetGizmo>()->settings.kind == GizmoKind::kNone);
}

TEST_CASE("the grip of every arrow and ring is within the picture as long as the tool is well within it") {
  const Rect& rect = kView.rect;
  for (const GizmoKind kind : {GizmoKind::kMove, GizmoKind::kTurn}) {
    for (const Vector2f& place :
         {Vector2f(130.0F, 80.0F), Vector2f(500.0F, 75.0F), Vector2f(870.0F, 90.0F), Vector2f(120.0F, 350.0F),
          Vector2f(880.0F, 350.0F), Vector2f(130.0F, 620.0F), Vector2f(500.0F, 625.0F), Vector2f(860.0F, 615.0F)}) {
      CAPTURE(place.x());
      CAPTURE(place.y());
      const auto ray = kView.ray(place);
      const spatial::Pose tool{ray[0] + 0.2 * ray[1], Eigen::Quaterniond::Identity()};
      const auto shapes = handle_shapes(gizmo(kind), tool, kView, 78.0F);
      REQUIRE(shapes.size() >= 2);
      for (const HandleShape& shape : shapes) {
        CAPTURE(name_of(shape.handle));
        if (shape.handle.kind == HandleKind::kPlane) continue;
        CHECK(shape.grip.x() - 12.0F >= rect.x0);
        CHECK(shape.grip.x() + 12.0F <= rect.x1);
        CHECK(shape.grip.y() - 12.0F >= rect.y0);
        CHECK(shape.grip.y() + 12.0F <= rect.y1);
        CHECK(handle_at(shapes, shape.grip, 9.0F).has_value());
      }
    }
  }
}

TEST_CASE("an arrow that points the other way still moves the tool as the pointer goes") {
  const auto ray = kView.ray({500.0F, 75.0F});
  const spatial::Pose tool{ray[0] + 0.2 * ray[1], Eigen::Quaterniond::Identity()};
  const auto shapes = handle_shapes(gizmo(GizmoKind::kMove), tool, kView, 78.0F);
  const auto up = std::find_if(shapes.begin(), shapes.end(), [](const HandleShape& shape) {
    return shape.handle == Handle{HandleKind::kAxis, 2};
  });
  REQUIRE(up != shapes.end());
  CHECK(up->grip.y() > kView.pixel(tool.p)->y());
  const Vector3d by = dragged_by(up->handle, tool, kView, up->grip, up->grip + Vector2f(0.0F, -10.0F));
  CHECK(by.z() > 0.0);
}

TEST_CASE("Shift+K keeps an instant to move the tool at, in hand or not; K stops what plays and does nothing else") {
  ToolDesk desk(GizmoKind::kNone);
  CHECK(desk.driver().key("Shift+K"));
  const auto* move = desk.committed<MoveTool>();
  REQUIRE(move != nullptr);
  CHECK(move->at_s == 2.0);
  CHECK(move->by_m.isZero());
  desk.commands.clear();
  desk.state.play_speed = 1.0;
  CHECK(desk.driver().key("K"));
  CHECK(desk.last<workbench::CommitEdit>() == nullptr);
  REQUIRE(desk.last<workbench::Play>() != nullptr);
  CHECK(desk.last<workbench::Play>()->speed == 0.0);
  // Once more, out of habit.
  desk.state.play_speed = 0.0;
  CHECK(desk.driver().key("K"));
  CHECK(desk.last<workbench::CommitEdit>() == nullptr);
}

}  // namespace trocar::ui
