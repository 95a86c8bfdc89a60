#include <doctest/doctest.h>

#include "engine/core/file.h"
#include "engine/workbench/importing.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/ui_desk.h"
#include "ui/command_text.h"
#include "ui/widgets/lint.h"

namespace trocar::ui {
namespace {

std::shared_ptr<const workbench::ImportView> looked_at(const workbench::ImportSettings& settings) {
  Progress progress;
  return workbench::view_of_import(settings, "2026-03-01T12:00:00Z", progress);
}

std::filesystem::path table(const testing::ScratchFolder& folder) {
  std::string text = "time_s,left_x_mm,left_y_mm,left_z_mm,left_gripper_deg\n";
  for (int i = 0; i < 50; ++i) text += std::to_string(0.1 * i) + "," + std::to_string(i) + ",-20,30,12\n";
  CHECK(write_file(folder / "hand.csv", text));
  return folder / "hand.csv";
}

/// What the workbench would answer.
void read_what_was_asked(Desk& desk) {
  const auto* read = desk.last<workbench::ReadImport>();
  REQUIRE(read != nullptr);
  desk.state.import = looked_at(read->settings);
  CHECK(desk.driver().frames(3));
}

}  // namespace

TEST_CASE("a file that is dropped on the window is read and shown, and imported when that is asked for") {
  const testing::ScratchFolder folder;
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(text_of(driver.drop(table(folder).string())) == "");
  desk.state.import_pending = true;
  CHECK(driver.frames(2));
  CHECK(text_of(driver.expect_enabled("Import/Import it", false)) == "");
  desk.state.import_pending = false;
  read_what_was_asked(desk);
  CHECK(text_of(driver.expect_value("Import/Outcome/Samples", "50")) == "");
  CHECK(text_of(driver.expect_value("Import/Map/Left/Unit", "mm")) == "");
  CHECK(text_of(driver.click("Import/Import it")) == "");
  CHECK(desk.last<workbench::MakeImport>() != nullptr);
  const std::string words = command_text(workbench::MakeImport{}, desk.state);
  CHECK(words.find("trocar demo import /data/pegs.trocar") == 0);
  CHECK(words.ends_with("--map proposed"));
}

TEST_CASE("what has been looked at is not imported while a take goes on") {
  const testing::ScratchFolder folder;
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(text_of(driver.drop(table(folder).string())) == "");
  read_what_was_asked(desk);
  CHECK(text_of(driver.expect_enabled("Import/Import it", true)) == "");
  desk.state.live.emplace().samples = 10;
  CHECK(driver.frames(2));
  CHECK(driver.item("Import/Import it").value().reason == "A transfer is being recorded");
  CHECK_FALSE(driver.click("Import/Import it"));
  CHECK(desk.last<workbench::MakeImport>() == nullptr);
}

TEST_CASE("a map that is changed is read again, and a field keeps what is typed until it is left") {
  const testing::ScratchFolder folder;
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(text_of(driver.drop(table(folder).string())) == "");
  read_what_was_asked(desk);
  CHECK(text_of(driver.click("Import/Map/Left/Unit")) == "");
  CHECK(text_of(driver.click("Import/Map/Left/Unit/cm")) == "");
  REQUIRE(desk.last<workbench::ReadImport>()->settings.map);
  CHECK(desk.last<workbench::ReadImport>()->settings.map->arms[0].position->unit == "cm");
  CHECK(text_of(driver.type("Import/Map/Frame/Move x, y, z, mm", "1, 2, 3")) == "");
  CHECK(desk.last<workbench::ReadImport>()->settings.map->frame.translation_m ==
        std::array<double, 3>{0.001, 0.002, 0.003});
  CHECK(text_of(driver.click("Import/Map/Swap the arms")) == "");
  CHECK(desk.last<workbench::ReadImport>()->settings.map->arms[1].position->unit == "cm");
}

TEST_CASE("the wizard is whole at every scale, also for what cannot be read") {
  const testing::ScratchFolder folder;
  const std::filesystem::path good = table(folder);
  const std::filesystem::path bad = folder / "bad.csv";
  CHECK(write_file(bad, "a,b\n1,2\n3,4\n"));
  for (const float scale : {0.75F, 1.0F, 1.5F, 2.0F, 3.0F}) {
    for (const std::filesystem::path& file : {good, bad}) {
      CAPTURE(scale);
      CAPTURE(file.string());
      Desk desk(testing::made_state(), scale, scale < 1.2F ? ThemeKind::kDark : ThemeKind::kLight);
      CHECK(text_of(desk.driver().drop(file.string())) == "");
      read_what_was_asked(desk);
      for (const LintFinding& finding : lint(desk.session->items().items(), scale)) {
        CHECK_MESSAGE(false, finding.path << " " << finding.what);
      }
    }
  }
}

TEST_CASE("what goes into an HDF5 file is chosen with its filter keys, and a table holds one") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(text_of(driver.key("Ctrl+Alt+E")) == "");
  CHECK(text_of(driver.expect_value("Export demonstrations/File", "/data/pegs.csv")) == "");
  CHECK(text_of(driver.click("Export demonstrations/Demonstrations/Novice 2")) == "");
  CHECK(text_of(driver.expect_value("Export demonstrations/Demonstrations/Expert 1", "off")) == "");
  CHECK(text_of(driver.click("Export demonstrations/Format/HDF5 (robomimic)")) == "");
  CHECK(text_of(driver.click("Export demonstrations/Demonstrations/Expert 1")) == "");
  CHECK(text_of(driver.type("Export demonstrations/Demonstrations/Novice 2/Filter keys", "train, valid")) == "");
  CHECK(text_of(driver.click("Export demonstrations/Export")) == "");
  const auto* out = desk.last<workbench::ExportDemonstrations>();
  REQUIRE(out != nullptr);
  CHECK(out->path == "/data/pegs.hdf5");
  CHECK(out->demonstrations == std::vector<workbench::DemonstrationId>{{1}, {2}});
  CHECK(out->masks == exchange::Masks{{"train", {1}}, {"valid", {1}}});
  CHECK(command_text(*out, desk.state) ==
        "trocar demo export /data/pegs.trocar 1 2 /data/pegs.hdf5 --format hdf5 --mask train=2 --mask valid=2");
  desk.state.exported = workbench::ExportView{out->path, false, {}, "the disk is full"};
  CHECK(driver.frames(2));
  CHECK(text_of(driver.expect_present("the disk is full", true)) == "");
}

}  // namespace trocar::ui
