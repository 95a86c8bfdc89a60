#include "ui/slice_grips.h"

#include <doctest/doctest.h>

#include "tests/support/ui_desk.h"
#include "ui/panels/view_panel.h"

namespace trocar::ui {
namespace {

using Eigen::Vector2f;

const ViewPort kView{scene::Camera::look_at({0.15, -0.12, 0.14}, {0.0, 0.0, 0.02}), {100.0F, 50.0F, 900.0F, 650.0F}};
const spatial::Grid kGrid;

Vector2f pixel(const Eigen::Vector3d& p_W) {
  return kView.pixel(p_W).value();
}

}  // namespace

TEST_CASE("a slice has its grip at its uppermost corner that is nearest to the eye; none that is not shown") {
  const auto grips = slice_grips(kGrid, {3, -1, 10}, kView);
  REQUIRE(grips.size() == 2);
  CHECK(grips[0].axis == 0);
  CHECK(grips[1].axis == 2);
  const double side_m = kGrid.n * kGrid.cell_m;
  // The eye is at large x, small y.
  const Eigen::Vector3d x_corner = kGrid.p_WGo + Eigen::Vector3d(3.5 * kGrid.cell_m, 0.0, side_m);
  const Eigen::Vector3d z_corner = kGrid.p_WGo + Eigen::Vector3d(side_m, 0.0, 10.5 * kGrid.cell_m);
  CHECK((grips[0].p_W - x_corner).norm() < 1e-12);
  CHECK((grips[1].p_W - z_corner).norm() < 1e-12);
  CHECK((grips[0].at - pixel(x_corner)).norm() < 1e-3F);
  CHECK(grips[0].outline.size() == 4);
}

TEST_CASE("a drag to where another slice has its corner leads there, and ends at the lattice's face") {
  for (const int axis : {0, 1, 2}) {
    CAPTURE(axis);
    std::array<int, 3> slices{-1, -1, -1};
    slices[static_cast<std::size_t>(axis)] = 8;
    const SliceGrip grip = slice_grips(kGrid, slices, kView).front();
    for (const int wanted : {8, 9, 15, 2}) {
      const Eigen::Vector3d there = grip.p_W + (wanted - 8) * kGrid.cell_m * Eigen::Vector3d::Unit(axis);
      CHECK(dragged_to(grip, kGrid, kView, grip.at, pixel(there)) == wanted);
    }
    const Eigen::Vector3d beyond = grip.p_W + 30 * kGrid.cell_m * Eigen::Vector3d::Unit(axis);
    if (const auto far = kView.pixel(beyond)) CHECK(dragged_to(grip, kGrid, kView, grip.at, *far) == kGrid.n - 1);
  }
}

TEST_CASE("in the window a slice follows its grip and the wheel") {
  workbench::WorkbenchState state = testing::made_state_with_model();
  state.field.slices = {-1, -1, 10};
  Desk desk(state);
  Driver driver(*desk.session, [&desk]() -> Status {
    desk.window.poll(0.0);
    TROCAR_ASSIGN_OR_RETURN(const ShellResult result, desk.session->frame(desk.state));
    for (const auto& command : result.commands) {
      if (const auto* field = std::get_if<workbench::SetField>(&command)) desk.state.field = field->settings;
    }
    return {};
  });
  CHECK(driver.key("Ctrl+3"));
  CHECK(driver.frames(4));
  CHECK(text_of(driver.drag("View/Slice z", 0.0F, -60.0F)) == "");
  CHECK(driver.frames(2));
  const int raised = desk.state.field.slices[2];
  CHECK(raised > 10);
  CHECK(text_of(driver.wheel("View/Slice z", 1)) == "");
  CHECK(driver.frames(2));
  CHECK(desk.state.field.slices[2] == raised + 1);
  CHECK(desk.state.field.slices[0] == -1);
}

}  // namespace trocar::ui
