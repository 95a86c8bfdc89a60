#include <doctest/doctest.h>

#include <algorithm>

#include "tests/support/ui_state.h"
#include "ui/command_table.h"
#include "ui/driver/driver.h"
#include "ui/window/null_window.h"

namespace trocar::ui {
namespace {

/// The window on a state that commands do not change, unless a test does.
struct Desk {
  explicit Desk(workbench::WorkbenchState shown, float scale = 1.0F) : state(std::move(shown)) {
    Settings settings;
    settings.scale = scale;
    session = std::move(Session::create(window, settings).value());
    CHECK(driver().frames(4));
  }
  Driver driver() {
    return Driver(*session, [this]() -> Status {
      window.poll(0.0);
      TROCAR_ASSIGN_OR_RETURN(const ShellResult result, session->frame(state));
      commands.insert(commands.end(), result.commands.begin(), result.commands.end());
      quit = quit || result.quit;
      return {};
    });
  }
  template <typename Command>
  const Command* last() const {
    const Command* found = nullptr;
    for (const auto& command : commands) {
      if (const auto* match = std::get_if<Command>(&command)) found = match;
    }
    return found;
  }

  workbench::WorkbenchState state;
  NullWindow window{{1600, 900}};
  std::unique_ptr<Session> session;
  std::vector<workbench::Command> commands;
  bool quit = false;
};

std::string text_of(const Status& status) {
  return status ? "" : status.error().text();
}

}  // namespace

TEST_CASE("without a project the view offers to make one, and the chooser opens") {
  Desk desk({});
  CHECK(text_of(desk.driver().click("View/New project…")) == "");
  CHECK(text_of(desk.driver().expect_present("New project/Create", true)) == "");
}

TEST_CASE("a project that failed to open says why in the view") {
  workbench::WorkbenchState state;
  state.load = workbench::LoadState::kFailed;
  state.load_error = "this is no project /data/x";
  Desk desk(state);
  CHECK(desk.session->items().find("View/this is no project /data/x") != nullptr);
}

TEST_CASE("the record form posts what was chosen") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(text_of(driver.click("Library/Record…")) == "");
  CHECK(text_of(driver.click("Record/Skill/Novice")) == "");
  CHECK(text_of(driver.type("Record/Seed", "42")) == "");
  CHECK(text_of(driver.type("Record/Name", "Versuch ä")) == "");
  CHECK(text_of(driver.click("Record/Start recording")) == "");
  const auto* record = desk.last<workbench::RecordScripted>();
  REQUIRE(record != nullptr);
  CHECK(record->options.seed == 42);
  CHECK(record->options.skill == trial::Skill::kNovice);
  CHECK(record->name == "Versuch ä");
  CHECK(record->realtime);
  CHECK(text_of(driver.expect_present("Record/Start recording", false)) == "");
}

TEST_CASE("clicking a demonstration selects it") {
  Desk desk(testing::made_state());
  CHECK(text_of(desk.driver().click("Library/Demonstrations/Novice 2")) == "");
  REQUIRE(desk.last<workbench::SelectDemonstration>() != nullptr);
  CHECK(desk.last<workbench::SelectDemonstration>()->id.value == 2);
}

TEST_CASE("dragging the in gate previews with the playhead and commits one trim on release") {
  Desk desk(testing::made_state());
  CHECK(text_of(desk.driver().drag("Timeline/In gate", 90.0F, 0.0F)) == "");
  int edits = 0;
  for (const auto& command : desk.commands) {
    edits += std::holds_alternative<workbench::CommitEdit>(command) ? 1 : 0;
  }
  CHECK(edits == 1);
  const auto& edit = std::get<workbench::EditDemonstration>(desk.last<workbench::CommitEdit>()->edit);
  const auto& trim = std::get<demonstration::Trim>(edit.edit);
  CHECK(trim.from_s > 0.3);
  CHECK(trim.from_s < 2.0);
  CHECK(trim.to_s == doctest::Approx(7.0));
  CHECK(desk.last<workbench::SetPlayhead>() != nullptr);
}

TEST_CASE("Escape during a drag of a gate trims nothing") {
  Desk desk(testing::made_state());
  const Item gate = desk.driver().item("Timeline/In gate").value();
  Driver driver = desk.driver();
  InputQueue& input = desk.window.input();
  input.push(MouseMoved{gate.rect.centre_x(), gate.rect.centre_y()});
  CHECK(driver.frames(1));
  input.push(MouseButton{0, true});
  input.push(MouseMoved{gate.rect.centre_x() + 80.0F, gate.rect.centre_y()});
  CHECK(driver.frames(3));
  CHECK(driver.key("Escape"));
  input.push(MouseButton{0, false});
  CHECK(driver.frames(2));
  CHECK(desk.last<workbench::CommitEdit>() == nullptr);
}

TEST_CASE("keys act as the command table says, and not while a field is typed in") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+Z"));
  CHECK(desk.last<workbench::Undo>() != nullptr);
  CHECK(driver.key("Space"));
  REQUIRE(desk.last<workbench::Play>() != nullptr);
  CHECK(desk.last<workbench::Play>()->speed == 1.0);
  desk.commands.clear();
  CHECK(driver.click("Inspector/Demonstration/Name"));
  CHECK(driver.key("I"));
  CHECK(driver.key("Delete"));
  CHECK(desk.last<workbench::CommitEdit>() == nullptr);
}

TEST_CASE("a disabled command says why, in the list and to whoever clicks it") {
  workbench::WorkbenchState state = testing::made_state();
  state.undoable = false;
  Desk desk(state);
  CHECK(desk.driver().item("Toolbar/Undo").value().reason == "Nothing to undo");
  const Status clicked = desk.driver().click("Toolbar/Undo");
  REQUIRE_FALSE(clicked);
  CHECK(clicked.error().code() == ErrorCode::kCheckFailed);
}

TEST_CASE("the palette finds a command by its words and Enter does it") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+P"));
  CHECK(text_of(driver.expect_present("Palette/Command", true)) == "");
  for (const char c : std::string("top cam")) desk.window.input().push(Typed{static_cast<std::uint32_t>(c)});
  CHECK(driver.frames(2));
  CHECK(driver.key("Enter"));
  REQUIRE(desk.last<workbench::SetCameraPreset>() != nullptr);
  CHECK(desk.last<workbench::SetCameraPreset>()->preset == scene::CameraPreset::kTop);
}

TEST_CASE("the last act is shown as a command line and can be copied") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(text_of(driver.click("Library/Trim idle")) == "");
  CHECK(driver.key("Ctrl+Shift+C"));
  CHECK(desk.window.clipboard().starts_with("trocar demo edit /data/pegs.trocar 1 trim --from 0."));
}

TEST_CASE("dragging in the picture orbits, the wheel zooms") {
  Desk desk(testing::made_state());
  const scene::OrbitCamera before = desk.state.orbit;
  CHECK(desk.driver().drag("View/Picture", 60.0F, 0.0F));
  REQUIRE(desk.last<workbench::SetCamera>() != nullptr);
  CHECK(desk.last<workbench::SetCamera>()->orbit.azimuth_rad != before.azimuth_rad);
  CHECK(desk.driver().wheel("View/Picture", 2.0F));
  CHECK(desk.last<workbench::SetCamera>()->orbit.distance_m < before.distance_m);
}

TEST_CASE("the train form posts the chosen demonstrations and options") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(text_of(driver.click("Tabs/Train")) == "");
  CHECK(text_of(driver.click("Train/Method/eg-maxent")) == "");
  CHECK(text_of(driver.type("Train/Episodes", "500")) == "");
  CHECK(text_of(driver.click("Train/Demonstrations/Novice 2")) == "");
  CHECK(text_of(driver.click("Train/Train")) == "");
  const auto* train = desk.last<workbench::TrainModel>();
  REQUIRE(train != nullptr);
  CHECK(train->demonstrations == std::vector<workbench::DemonstrationId>{{1}});
  CHECK(train->options.episodes == 500);
  CHECK(train->options.method == learning::Method::kEgMaxent);
}

TEST_CASE("the fields panel shows the goal's cell and a click cuts elsewhere") {
  Desk desk(testing::made_state_with_model());
  Driver driver = desk.driver();
  CHECK(text_of(driver.click("Tabs/Fields")) == "");
  CHECK(text_of(driver.expect_present("Fields/Probe/Cell 1, 10, 10", true)) == "");
  CHECK(text_of(driver.click("Fields/z/3-D")) == "");
  REQUIRE(desk.last<workbench::SetField>() != nullptr);
  CHECK(desk.last<workbench::SetField>()->settings.slices[2] == 10);
}

TEST_CASE("every menu opens, and an item of it does what it says") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  for (const char* menu : {"File", "View", "Transport", "Help"}) {
    CHECK(text_of(driver.click(std::string("Menu/") + menu)) == "");
    CHECK(driver.frames(2));
    CHECK(text_of(driver.expect_value(std::string("Menu/") + menu, "open")) == "");
    CHECK(driver.key("Escape"));
    CHECK(text_of(driver.expect_value(std::string("Menu/") + menu, "")) == "");
  }
  CHECK(text_of(driver.click("Menu/Edit")) == "");
  CHECK(text_of(driver.click("Edit/Delete demonstration")) == "");
  CHECK(desk.last<workbench::CommitEdit>() != nullptr);
}

TEST_CASE("a layer is chosen from the list") {
  Desk desk(testing::made_state_with_model());
  Driver driver = desk.driver();
  CHECK(text_of(driver.click("Tabs/Fields")) == "");
  CHECK(text_of(driver.click("Fields/Layer")) == "");
  CHECK(text_of(driver.click("Layer/margin")) == "");
  REQUIRE(desk.last<workbench::SetField>() != nullptr);
  CHECK(desk.last<workbench::SetField>()->settings.layer == learning::Layer::kMargin);
}

TEST_CASE("no widget of any workspace is cut off, at 100 and at 150 per cent") {
  for (const float scale : {1.0F, 1.5F}) {
    Desk desk(testing::made_state_with_model(), scale);
    desk.window.resize({static_cast<int>(1600.0F * scale), static_cast<int>(900.0F * scale)});
    for (const char* keys : {"Ctrl+1", "Ctrl+2", "Ctrl+3", "Ctrl+4"}) {
      CHECK(desk.driver().key(keys));
      CHECK(desk.driver().frames(3));
      for (const Item& item : desk.session->items().items()) {
        CAPTURE(item.path);
        CAPTURE(scale);
        CHECK_FALSE(item.text_clipped);
      }
    }
  }
}

TEST_CASE("what is not on screen is answered with what is most like it") {
  Desk desk(testing::made_state());
  const Status clicked = desk.driver().click("Library/Rekord");
  REQUIRE_FALSE(clicked);
  CHECK(clicked.error().code() == ErrorCode::kNotFound);
  CHECK(clicked.error().text().find("Library/Record…") != std::string::npos);
}

TEST_CASE("the list of items is JSON with every field") {
  Desk desk(testing::made_state());
  const std::string json = desk.session->items().to_json();
  for (const char* key : {"\"path\"", "\"role\"", "\"rect\"", "\"enabled\"", "\"visible\""}) {
    CHECK(json.find(key) != std::string::npos);
  }
}

TEST_CASE("every command is reachable by the keyboard through the palette") {
  for (const CommandRow& row : command_table()) {
    CAPTURE(row.id);
    const auto found =
        search_commands(row.title.ends_with("…") ? row.title.substr(0, row.title.size() - 3) : row.title);
    CHECK(std::find(found.begin(), found.end(), &row) != found.end());
  }
}

}  // namespace trocar::ui
