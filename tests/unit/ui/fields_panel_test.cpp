#include <doctest/doctest.h>

#include <algorithm>

#include "tests/support/ui_desk.h"

using namespace trocar;
using namespace trocar::ui;

namespace {

/// Commands of the panel change the state, as in the workbench.
struct FieldsDesk : Desk {
  explicit FieldsDesk(workbench::WorkbenchState shown = testing::made_state_with_model()) : Desk(std::move(shown)) {
    CHECK(text_of(driver().click("Tabs/Fields")) == "");
    CHECK(text_of(driver().key("Ctrl+Space")) == "");  // the whole window
    CHECK(driver().frames(3));
  }
  Driver follow() {
    return Driver(*session, [this]() -> Status {
      window.poll(0.0);
      TROCAR_ASSIGN_OR_RETURN(const ShellResult result, session->frame(state));
      for (const auto& command : result.commands) {
        if (const auto* field = std::get_if<workbench::SetField>(&command)) state.field = field->settings;
        if (const auto* layers = std::get_if<workbench::SetFieldLayers>(&command)) state.field_layers = layers->layers;
      }
      copied = window.clipboard();
      return {};
    });
  }
  std::string copied;
};

}  // namespace

TEST_CASE("scale, map and the reader's eyes are chosen from lists") {
  FieldsDesk desk;
  Driver driver = desk.follow();
  CHECK(text_of(driver.click("Fields/Scale")) == "");
  CHECK(text_of(driver.click("Scale/rank")) == "");
  CHECK(desk.state.field.scale == plot::ScaleKind::kRank);
  CHECK(text_of(driver.click("Fields/Map")) == "");
  CHECK(text_of(driver.click("Map/magma")) == "");
  CHECK(desk.state.field.map == plot::ColourMap::kMagma);
  CHECK(text_of(driver.click("Fields/Map")) == "");
  CHECK(text_of(driver.click("Map/auto colours")) == "");
  CHECK_FALSE(desk.state.field.map);
  CHECK(text_of(driver.click("Fields/Seen with")) == "");
  CHECK(text_of(driver.click("Seen with/deutan")) == "");
  CHECK(desk.state.field.vision == plot::ColourVision::kDeutan);
}

TEST_CASE("drawings in the view are switched, and bring what they need with them") {
  FieldsDesk desk;
  Driver driver = desk.follow();
  CHECK(text_of(driver.expect_present("Fields/Threshold", false)) == "");
  CHECK(text_of(driver.click("Fields/Voxels")) == "");
  CHECK(desk.state.field.voxels);
  CHECK(driver.frames(2));
  CHECK(text_of(driver.expect_present("Fields/Threshold", true)) == "");
  CHECK(text_of(driver.click("Fields/Surface")) == "");
  CHECK(text_of(driver.click("Fields/Volume")) == "");
  CHECK(text_of(driver.click("Fields/Streamlines")) == "");
  CHECK(desk.state.field.iso_surface);
  CHECK(desk.state.field.volume);
  CHECK(desk.state.field.streamlines);
  CHECK(driver.frames(2));
  CHECK(text_of(driver.type("Fields/Starts", "face:z1")) == "");
  CHECK(desk.state.field.streamline_starts == "face:z1");
  CHECK(text_of(driver.click("Fields/Glyphs")) == "");
  CHECK(text_of(driver.click("Glyphs/stars")) == "");
  CHECK(desk.state.field.glyphs == workbench::Glyphs::kStars);
}

TEST_CASE("fields are kept in the view as layers, hidden, shown alone, moved, taken up again and taken off") {
  FieldsDesk desk;
  Driver driver = desk.follow();
  CHECK(text_of(driver.expect_enabled("Fields/Layers/Keep in the view", false)) == "");
  CHECK(text_of(driver.click("Fields/Volume")) == "");
  CHECK(text_of(driver.click("Fields/Layers/Keep in the view")) == "");
  REQUIRE(desk.state.field_layers.size() == 1);
  CHECK(desk.state.field_layers[0].volume);
  CHECK_FALSE(desk.state.field.volume);
  CHECK(text_of(driver.click("Fields/Mask")) == "");
  CHECK(text_of(driver.click("Mask/the safe set")) == "");
  CHECK(desk.state.field.mask == learning::FieldMask::kSafe);
  CHECK(text_of(driver.click("Fields/Voxels")) == "");
  CHECK(text_of(driver.click("Fields/Layers/Keep in the view")) == "");
  REQUIRE(desk.state.field_layers.size() == 2);
  CHECK(text_of(driver.expect_present("Fields/Layers/2/reward · voxels · safe", true)) == "");
  CHECK(text_of(driver.click("Fields/Layers/1/reward · volume")) == "");
  CHECK_FALSE(desk.state.field_layers[0].visible);
  CHECK(text_of(driver.click("Fields/Layers/1/Solo")) == "");
  CHECK(desk.state.field_layers[0].visible);
  CHECK_FALSE(desk.state.field_layers[1].visible);
  CHECK_FALSE(desk.state.field.visible);
  CHECK(text_of(driver.click("Fields/Layers/1/Solo")) == "");
  CHECK(desk.state.field_layers[1].visible);
  CHECK(desk.state.field.visible);
  CHECK(text_of(driver.click("Fields/Layers/1/Down")) == "");
  CHECK(desk.state.field_layers[1].volume);
  CHECK(text_of(driver.click("Fields/Layers/2/Swap")) == "");
  CHECK(desk.state.field.volume);
  CHECK_FALSE(desk.state.field_layers[1].volume);
  CHECK(text_of(driver.click("Fields/Layers/1/Remove")) == "");
  CHECK(desk.state.field_layers.size() == 1);
}

TEST_CASE("a limit of the colours follows the mouse, and a double click fits it again") {
  FieldsDesk desk;
  Driver driver = desk.follow();
  const double low = desk.state.insight->field->low();
  const double high = desk.state.insight->field->high();
  CHECK(text_of(driver.drag("Fields/Colour bar/Low limit", 200.0F, 0.0F)) == "");
  REQUIRE(desk.state.field.limits);
  CHECK((*desk.state.field.limits)[0] > low);
  CHECK((*desk.state.field.limits)[0] < high);
  CHECK((*desk.state.field.limits)[1] == doctest::Approx(high));
  CHECK(text_of(driver.double_click("Fields/Colour bar/Low limit")) == "");
  CHECK_FALSE(desk.state.field.limits);
}

TEST_CASE("a cell is pinned, compared, copied and taken off") {
  FieldsDesk desk;
  Driver driver = desk.follow();
  CHECK(text_of(driver.click("Fields/Probe/Pin")) == "");
  CHECK(text_of(driver.expect_present("Fields/Probe/Pinned/1, 10, 10", true)) == "");
  CHECK(driver.held("Shift", true));
  CHECK(text_of(driver.click("Fields/z/Slice")) == "");
  CHECK(driver.held("Shift", false));
  CHECK(text_of(driver.expect_present("Fields/Probe/Pinned/2 pinned cells", true)) == "");
  CHECK(text_of(driver.hover("Fields/z/Slice")) == "");
  CHECK(driver.key("Ctrl+C"));
  CHECK(desk.copied.starts_with("i,j,k,index,x_mm,y_mm,z_mm,reward,theta,v,q+x,"));
  CHECK(std::count(desk.copied.begin(), desk.copied.end(), '\n') == 3);
  CHECK(text_of(driver.click("Fields/Probe/Pinned/1, 10, 10")) == "");
  CHECK(text_of(driver.expect_present("Fields/Probe/Pinned/1 pinned cell", true)) == "");
}

TEST_CASE("X, Y and Z show one slice alone, the wheel steps it and with Shift makes it thicker") {
  FieldsDesk desk;
  desk.state.field.slices = {-1, -1, 10};
  Driver driver = desk.follow();
  CHECK(text_of(driver.hover("Fields/z/Slice")) == "");
  CHECK(driver.key("Z"));
  CHECK(driver.frames(2));
  CHECK(text_of(driver.expect_present("Fields/x/Slice", false)) == "");
  CHECK(text_of(driver.wheel("Fields/z/Slice", 1.0F)) == "");
  CHECK(desk.state.field.slices[2] == 11);
  CHECK(driver.held("Shift", true));
  CHECK(text_of(driver.wheel("Fields/z/Slice", 1.0F)) == "");
  CHECK(text_of(driver.wheel("Fields/z/Slice", 1.0F)) == "");
  CHECK(driver.held("Shift", false));
  CHECK(desk.state.field.slabs[2] == 3);
  CHECK(desk.state.field.slices[2] == 11);
  CHECK(text_of(driver.expect_value("Fields/z/Slice", "11 of 3")) == "");
  CHECK(driver.key("Z"));
  CHECK(driver.frames(2));
  CHECK(text_of(driver.expect_present("Fields/x/Slice", true)) == "");
}

TEST_CASE("a tile of the montage is the slice from then on") {
  FieldsDesk desk;
  desk.state.field.slices = {-1, -1, 10};
  Driver driver = desk.follow();
  CHECK(text_of(driver.click("Fields/Mode/Montage")) == "");
  CHECK(driver.frames(2));
  CHECK(text_of(driver.expect_present("Fields/Montage/z = 21", true)) == "");
  CHECK(text_of(driver.click("Fields/Montage/z = 4")) == "");
  CHECK(desk.state.field.slices[2] == 4);
  CHECK(driver.frames(2));
  CHECK(text_of(driver.expect_value("Fields/z/Slice", "4")) == "");
}

TEST_CASE("a field of a demonstration that was edited since says that it is stale") {
  workbench::WorkbenchState state = testing::made_state_with_model();
  FieldsDesk fresh(state);
  CHECK(text_of(fresh.follow().expect_present("Fields/stale", false)) == "");
  auto insight = std::make_shared<workbench::ModelInsight>(*state.insight);
  insight->stale = true;
  state.insight = insight;
  FieldsDesk desk(state);
  CHECK(text_of(desk.follow().expect_present("Fields/stale", true)) == "");
}

TEST_CASE("what a cloud hides is chosen, drawn by its knots, and typed") {
  FieldsDesk desk;
  Driver driver = desk.follow();
  CHECK(text_of(driver.expect_present("Fields/Cloud/Curve", false)) == "");
  CHECK(text_of(driver.click("Fields/Volume")) == "");
  CHECK(driver.frames(2));
  CHECK_FALSE(desk.state.field.opacity_curve);
  CHECK(text_of(driver.expect_value("Fields/Cloud/Opacity curve", "automatic")) == "");
  CHECK(text_of(driver.click("Fields/Cloud/Opacity curve")) == "");
  CHECK(text_of(driver.click("Opacity curve/only the highest")) == "");
  CHECK(desk.state.field.opacity_curve == plot::opacity_curve(plot::OpacityPreset::kHighest));
  CHECK(driver.frames(2));
  CHECK(text_of(driver.expect_value("Fields/Cloud/Knot 1", "0.80 → 0.00")) == "");
  CHECK(text_of(driver.drag("Fields/Cloud/Knot 1", -100.0F, -20.0F)) == "");
  CHECK(driver.frames(2));
  REQUIRE(desk.state.field.opacity_curve);
  const plot::OpacityKnot moved = desk.state.field.opacity_curve->knots[0];
  CHECK(moved.position < 0.79);
  CHECK(moved.height > 0.1);
  CHECK(desk.state.field.opacity_curve->knots[1] == plot::OpacityKnot{0.95, 1.0});
  CHECK(text_of(driver.expect_value("Fields/Cloud/Opacity curve", "as drawn")) == "");
  // Never beyond its neighbour.
  CHECK(text_of(driver.drag("Fields/Cloud/Knot 1", 2000.0F, 0.0F)) == "");
  CHECK(desk.state.field.opacity_curve->knots[0].position == doctest::Approx(0.94));
  CHECK(text_of(driver.double_click("Fields/Cloud/Curve")) == "");
  CHECK(driver.frames(2));
  REQUIRE(desk.state.field.opacity_curve->knots.size() == 3);
  CHECK(desk.state.field.opacity_curve->knots[0].position == doctest::Approx(0.5).epsilon(0.03));
  CHECK(driver.frames(60));  // else it were a fourth click
  CHECK(text_of(driver.double_click("Fields/Cloud/Knot 1")) == "");
  CHECK(desk.state.field.opacity_curve->knots.size() == 2);
  CHECK(driver.frames(2));
  CHECK(text_of(driver.click("Fields/Cloud/Add knot")) == "");
  CHECK(desk.state.field.opacity_curve->knots.size() == 2);  // no room between them
  CHECK(text_of(driver.type("Fields/Cloud/Knots", "0:0/0.5:0.2/1:1")) == "");
  CHECK(driver.frames(2));
  CHECK(desk.state.field.opacity_curve == plot::opacity_curve_from("0:0/0.5:0.2/1:1").value());
  CHECK(text_of(driver.click("Fields/Cloud/Add knot")) == "");
  CHECK(driver.frames(2));
  CHECK(desk.state.field.opacity_curve->knots.size() == 4);
  CHECK(text_of(driver.click("Fields/Cloud/Remove knot")) == "");
  CHECK(driver.frames(2));
  CAPTURE(plot::to_string(*desk.state.field.opacity_curve));
  CHECK(desk.state.field.opacity_curve == plot::opacity_curve_from("0:0/0.5:0.2/1:1").value());
  CHECK(text_of(driver.type("Fields/Cloud/Knots", "hill")) == "");
  CHECK(driver.frames(2));
  CHECK(desk.state.field.opacity_curve == plot::opacity_curve_from("0:0/0.5:0.2/1:1").value());
  CHECK(text_of(driver.click("Fields/Cloud/Opacity curve")) == "");
  CHECK(text_of(driver.click("Opacity curve/automatic")) == "");
  CHECK_FALSE(desk.state.field.opacity_curve);
}
