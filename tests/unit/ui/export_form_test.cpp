#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>

#include "engine/core/file.h"
#include "tests/support/ui_desk.h"
#include "ui/command_text.h"

namespace trocar::ui {

TEST_CASE("the film proposed has the demonstration's name, beside the project") {
  Desk desk(testing::made_state());
  CHECK(desk.driver().key("Ctrl+E"));
  CHECK(text_of(desk.driver().expect_value("Export video/File", "/data/Expert 1.mp4")) == "");
}

TEST_CASE("speed, camera, codec and captions of a film are asked for, and written as a command line") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+E"));
  CHECK(text_of(driver.click("Export video/Speed/4×")) == "");
  CHECK(text_of(driver.click("Export video/Camera/Side")) == "");
  CHECK(text_of(driver.click("Export video/Codec/FFV1")) == "");
  CHECK(text_of(driver.expect_value("Export video/File", "/data/Expert 1.mkv")) == "");
  CHECK(text_of(driver.click("Export video/Segments, jaws and pedals")) == "");
  CHECK(text_of(driver.click("Export video/Export")) == "");
  const auto* video = desk.last<workbench::ExportVideo>();
  REQUIRE(video != nullptr);
  CHECK(video->speed == 4.0);
  CHECK(video->camera == scene::CameraPreset::kSide);
  CHECK(video->codec == media::Codec::kFfv1);
  CHECK_FALSE(video->captions);
  const std::string words = command_text(*video, desk.state);
  CHECK(words.find("--speed 4 --camera side --codec ffv1 --no-captions") != std::string::npos);
}

TEST_CASE("a field is asked for on paper, in the colours of the window, and written as a command line") {
  Desk desk(testing::made_state_with_model());
  desk.state.field.scale = plot::ScaleKind::kSymlog;
  desk.state.field.map = plot::ColourMap::kMagma;
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+Shift+E"));
  CHECK(text_of(driver.expect_enabled("Export field/Pixels an inch", false)) == "");  // a screen has its own
  CHECK(text_of(driver.click("Export field/Width/88 mm")) == "");
  CHECK(text_of(driver.expect_enabled("Export field/Pixels an inch", true)) == "");
  CHECK(text_of(driver.type("Export field/File", "f.png")) == "");  // the project's folder is none here
  CHECK(driver.frames(2));
  CHECK(text_of(driver.click("Export field/Export")) == "");
  const auto* field = desk.last<workbench::ExportField>();
  REQUIRE(field != nullptr);
  CHECK(field->look.preset == "column");
  CHECK(field->look.dpi == 300.0);
  CHECK(field->path.extension() == ".png");
  const std::string words = command_text(*field, desk.state);
  CHECK(words.find("--montage --scale symlog --map magma --preset column --dpi 300 --out ") != std::string::npos);

  CHECK(driver.key("Ctrl+Shift+E"));
  CHECK(text_of(driver.click("Export field/Kind of file/PDF")) == "");
  CHECK(text_of(driver.expect_enabled("Export field/Pixels an inch", false)) == "");
  CHECK(text_of(driver.type("Export field/File", "f.pdf")) == "");
  CHECK(driver.frames(2));
  CHECK(text_of(driver.click("Export field/Export")) == "");
  field = desk.last<workbench::ExportField>();
  CHECK(field->path.extension() == ".pdf");
  CHECK(field->look.preset == "column");
  CHECK_FALSE(field->look.dpi);
}

TEST_CASE("a file of a field's numbers has neither paper nor colours, and one of the whole lattice no slice") {
  Desk desk(testing::made_state_with_model());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+Shift+E"));
  CHECK(text_of(driver.click("Export field/What/One slice")) == "");
  CHECK(text_of(driver.expect_enabled("Export field/Slice", true)) == "");
  CHECK(text_of(driver.click("Export field/Kind of file/VTI")) == "");
  CHECK(text_of(driver.expect_enabled("Export field/Slice", false)) == "");
  CHECK(text_of(driver.expect_enabled("Export field/Width/88 mm", false)) == "");
  CHECK(text_of(driver.type("Export field/File", "f.vti")) == "");
  CHECK(driver.frames(2));
  CHECK(text_of(driver.click("Export field/Export")) == "");
  const auto* field = desk.last<workbench::ExportField>();
  REQUIRE(field != nullptr);
  CHECK(field->path.extension() == ".vti");
  CHECK(field->slice.empty());
  CHECK(field->look == workbench::FieldFileLook{});
  CHECK(command_text(*field, desk.state).find(" --layer reward --out ") != std::string::npos);
}

TEST_CASE("the slice proposed is the panel's, and one that there is not is refused before the form closes") {
  Desk desk(testing::made_state_with_model());
  Driver driver = desk.driver();
  CHECK(text_of(driver.click("Tabs/Fields")) == "");
  CHECK(driver.frames(2));
  CHECK(driver.key("Ctrl+Shift+E"));
  CHECK(text_of(driver.click("Export field/What/One slice")) == "");
  CHECK(text_of(driver.expect_value("Export field/Slice", "z=10")) == "");  // through the goal
  CHECK(text_of(driver.type("Export field/Slice", "z=99")) == "");
  CHECK(text_of(driver.type("Export field/File", "F.PNG")) == "");
  CHECK(driver.frames(2));
  CHECK(driver.item("Export field/Export").value().reason.find("z") != std::string::npos);
  CHECK(text_of(driver.type("Export field/Slice", "y=3")) == "");
  CHECK(driver.frames(2));
  CHECK(text_of(driver.click("Export field/Export")) == "");
  const auto* field = desk.last<workbench::ExportField>();
  REQUIRE(field != nullptr);
  CHECK(field->slice == "y=3");
  CHECK(field->path == "F.PNG");
}

TEST_CASE("a Q-table is imported from an empty panel, and written as a command line") {
  const std::filesystem::path table =
      std::filesystem::temp_directory_path() / ("trocar_form_" + std::to_string(::getpid()) + ".npy");
  REQUIRE(write_file(table, "any"));  // what it holds is read by the job
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(text_of(driver.click("Tabs/Fields")) == "");
  CHECK(text_of(driver.click("Fields/Import Q-table…")) == "");
  CHECK(text_of(driver.expect_enabled("Import Q-table/Import", false)) == "");
  CHECK(text_of(driver.type("Import Q-table/File", table.string())) == "");
  CHECK(text_of(driver.click("Import Q-table/What/Reward θ")) == "");
  CHECK(text_of(driver.click("Import Q-table/Import")) == "");
  const auto* asked = desk.last<workbench::ImportTable>();
  REQUIRE(asked != nullptr);
  CHECK(asked->path == table);
  CHECK(asked->kind == learning::TableKind::kTheta);
  CHECK_FALSE(asked->demonstrations.empty());
  const std::string words = command_text(*asked, desk.state);
  CHECK(words.find("trocar model import ") == 0);
  CHECK(words.find(" --kind theta --demo 1") != std::string::npos);
  std::filesystem::remove(table);
}

TEST_CASE("the field's button is lit only while something is drawn, and draws the slice through the goal") {
  Desk desk(testing::made_state_with_model());
  Driver driver = desk.driver();
  CHECK(text_of(driver.expect_value("View/Field", "off")) == "");
  CHECK(text_of(driver.click("View/Field")) == "");
  REQUIRE(desk.last<workbench::SetField>() != nullptr);
  const workbench::FieldSettings& chosen = desk.last<workbench::SetField>()->settings;
  CHECK(chosen.visible);
  CHECK(chosen.slices[2] == 10);
  desk.state.field = chosen;
  CHECK(driver.frames(2));
  CHECK(text_of(driver.expect_value("View/Field", "on")) == "");
}

TEST_CASE("the inspector says of an exact model only what it has") {
  Desk desk(testing::made_state_with_model());
  CHECK(desk.session->items().find("Inspector/Model/Method") != nullptr);
  for (const char* name : {"Exploration ε", "Episodes", "Seed", "Fully explored"}) {
    CAPTURE(name);
    CHECK(desk.session->items().find("Inspector/Model/" + std::string(name)) == nullptr);
  }
}

TEST_CASE("a tooltip goes with the click, and stays away until the pointer has been elsewhere") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  const auto tooltip = [&] { return desk.session->ui().tooltip() == "Toolbar/Undo"; };
  CHECK(driver.hover("Toolbar/Undo"));
  CHECK(driver.frames(40));
  CHECK(tooltip());
  CHECK(driver.click("Toolbar/Undo"));
  CHECK(driver.frames(40));
  CHECK_FALSE(tooltip());
  CHECK(driver.hover("View/Picture"));
  CHECK(driver.frames(4));
  CHECK(driver.hover("Toolbar/Undo"));
  CHECK(driver.frames(40));
  CHECK(tooltip());
}

TEST_CASE("a trim that would change nothing cannot be made") {
  workbench::WorkbenchState state = testing::made_state();
  state.playhead_s = state.project->demonstrations.at({1})->begin_s;
  Desk desk(state);
  CHECK(desk.driver().key("I"));
  CHECK(desk.last<workbench::CommitEdit>() == nullptr);
  CHECK(desk.driver().key("O"));
  CHECK(desk.last<workbench::CommitEdit>() != nullptr);
}

}  // namespace trocar::ui
