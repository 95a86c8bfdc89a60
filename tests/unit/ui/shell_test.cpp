#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "engine/demonstration/edits.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/ui_desk.h"
#include "tests/support/ui_state.h"
#include "ui/command_table.h"
#include "ui/driver/driver.h"
#include "ui/panels/inspector_panel.h"
#include "ui/window/null_window.h"

namespace trocar::ui {

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
  CHECK(text_of(driver.click("Record/Who/Scripted")) == "");
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
  CHECK(desk.window.clipboard().starts_with("trocar demo edit /data/pegs.trocar 1 trim-idle --speed-mm-s 2"));
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
  CHECK(text_of(driver.click("Train/Method")) == "");
  CHECK(text_of(driver.click("Method/eg-maxent")) == "");
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
  for (const char* menu : {"File", "Select", "View", "Transport", "Help"}) {
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

TEST_CASE("quitting asks first while a transfer is recorded, and does what is answered") {
  workbench::WorkbenchState state = testing::made_state();
  state.live.emplace().elapsed_s = 12.3;
  Desk desk(state);
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+Q"));
  CHECK_FALSE(desk.quit);
  CHECK(text_of(driver.click("Quit/Stay")) == "");
  CHECK(text_of(driver.expect_present("Quit/Stay", false)) == "");
  CHECK(driver.key("Ctrl+Q"));
  CHECK(text_of(driver.click("Quit/Discard and quit")) == "");
  CHECK(desk.quit);
  REQUIRE(desk.last<workbench::StopRecording>() != nullptr);
  CHECK_FALSE(desk.last<workbench::StopRecording>()->keep);
}

TEST_CASE("quitting asks first while a film is made, and at once when nothing runs") {
  Desk busy(testing::made_state_with_model());
  CHECK(busy.driver().key("Ctrl+Q"));
  CHECK_FALSE(busy.quit);
  CHECK(text_of(busy.driver().click("Quit/Cancel them and quit")) == "");
  CHECK(busy.quit);
  Desk idle(testing::made_state());
  CHECK(idle.driver().key("Ctrl+Q"));
  CHECK(idle.quit);
}

TEST_CASE("while a project is being opened nothing can be recorded or undone") {
  workbench::WorkbenchState state = testing::made_state();
  state.load = workbench::LoadState::kLoading;
  Desk desk(state);
  for (const char* path : {"Toolbar/Record…", "Toolbar/Undo", "Toolbar/Train…"}) {
    CHECK(desk.driver().item(path).value().reason == "The project is being opened");
  }
}

TEST_CASE("what could not be opened is said once, and can be tried again") {
  workbench::WorkbenchState state;
  state.load = workbench::LoadState::kFailed;
  state.path = "/data/pegs.trocar";
  state.load_error = "the disk is gone";
  Desk desk(state);
  int times = 0;
  for (const Item& item : desk.session->items().items()) times += item.label.find("not be opened") != std::string::npos;
  CHECK(times == 1);
  CHECK(text_of(desk.driver().click("View/Retry")) == "");
  REQUIRE(desk.last<workbench::OpenProject>() != nullptr);
  CHECK(desk.last<workbench::OpenProject>()->path == "/data/pegs.trocar");
  CHECK_FALSE(desk.last<workbench::OpenProject>()->create);
}

TEST_CASE("a segment that a gate cuts is as long in the timeline as in the inspector") {
  workbench::WorkbenchState state = testing::made_state();
  auto project = std::make_shared<workbench::Project>(*state.project);
  auto trimmed = *project->demonstrations.at({1});
  trimmed.begin_s = 1.25;
  project->demonstrations[{1}] = std::make_shared<demonstration::Demonstration>(trimmed);
  state.project = project;
  Desk desk(state);
  CHECK(text_of(desk.driver().expect_value("Timeline/Segment A", "0.75 s")) == "");
  CHECK(text_of(desk.driver().expect_value("Segments/A", "1.25–2.00 s")) == "");
}

TEST_CASE("while a transfer is recorded the timeline and the inspector do not show another one") {
  workbench::WorkbenchState state = testing::made_state();
  state.live.emplace().samples = 2480;
  Desk desk(state);
  CHECK(text_of(desk.driver().expect_present("Timeline/Lanes", false)) == "");
  CHECK(text_of(desk.driver().expect_value("Inspector/Recording/Samples", "2,480")) == "");
  CHECK(desk.driver().item("Toolbar/Undo").value().reason == "A transfer is being recorded");
}

TEST_CASE("while a take waits for its verdict no gate can be dragged") {
  Desk desk(testing::made_state());
  const Item gate = desk.driver().item("Timeline/In gate").value();
  desk.state.live.emplace().samples = 2480;
  desk.state.take.emplace().reviewing = true;
  CHECK(desk.driver().frames(2));
  CHECK_FALSE(desk.driver().drag("Timeline/In gate", 90.0F, 0.0F));
  // Nor by a mouse that does not ask what is there.
  const auto [x, y] = std::pair{0.5F * (gate.rect.x0 + gate.rect.x1), 0.5F * (gate.rect.y0 + gate.rect.y1)};
  desk.window.input().push(MouseMoved{x, y});
  CHECK(desk.driver().frames(1));
  desk.window.input().push(MouseButton{0, true});
  CHECK(desk.driver().frames(1));
  desk.window.input().push(MouseMoved{x + 90.0F, y});
  CHECK(desk.driver().frames(1));
  desk.window.input().push(MouseButton{0, false});
  CHECK(desk.driver().frames(2));
  CHECK(desk.last<workbench::CommitEdit>() == nullptr);
}

TEST_CASE("how often the window is drawn is said in the menu bar once that is asked for") {
  Desk desk(testing::made_state());
  const auto said = [&] {
    const auto& items = desk.session->items().items();
    return std::count_if(items.begin(), items.end(), [](const Item& item) {
      return item.label.size() > 4 && item.label.find(" fps") == item.label.size() - 4;
    });
  };
  CHECK(said() == 0);
  CHECK(text_of(desk.driver().click("Menu/View")) == "");
  CHECK(text_of(desk.driver().click("View/Frames per second")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(said() == 1);
  CHECK(text_of(desk.driver().click("Menu/View")) == "");
  CHECK(text_of(desk.driver().click("View/Frames per second")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(said() == 0);
}

TEST_CASE("how a demonstration ended is said to be unknown by what it is that does not tell") {
  const auto state = testing::made_state();
  const auto& shown = *state.project->demonstrations.at({1});
  CHECK(outcome_reason(shown).empty());
  auto edited = demonstration::apply(shown, demonstration::Smooth{0.0, 5.0}, 7).value();
  REQUIRE(edited.outcome_doubt() == "its motion was edited since");
  CHECK(outcome_reason(edited) ==
        "How it ends is unknown: what was recorded ended as success, and its motion was "
        "edited since; simulate it to know");
  auto recording = std::make_shared<demonstration::RecordingInfo>(*edited.recording);
  recording->outcome = demonstration::Outcome::kUnknown;
  recording->provenance.operator_kind = "imported";
  edited.recording = recording;
  CHECK(outcome_reason(edited) == "How it ends is unknown: the file that it was imported from does not tell");
}

TEST_CASE("the probe says expected visits as the layer does, and nothing twice") {
  for (const learning::Layer layer : {learning::Layer::kReward, learning::Layer::kVisits, learning::Layer::kSteps}) {
    workbench::WorkbenchState state = testing::made_state_with_model();
    auto insight = std::make_shared<workbench::ModelInsight>(*state.insight);
    insight->field = std::make_shared<learning::Field>(learning::field(*insight->entry->model, layer));
    state.insight = insight;
    state.field.layer = layer;
    Desk desk(state);
    CHECK(text_of(desk.driver().click("Tabs/Fields")) == "");
    std::set<std::string> seen;
    int visits = 0;
    for (const Item& item : desk.session->items().items()) {
      if (item.path.find("/Probe/") == std::string::npos) continue;
      CHECK(seen.insert(item.path).second);
      if (item.label.find("isits") == std::string::npos) continue;
      ++visits;
      CHECK(item.value == "1 expected");  // the probe stands at the goal, where every demonstration ends
    }
    CHECK(visits == 1);
  }
}

TEST_CASE("an export asks before it replaces a file") {
  const testing::ScratchFolder folder;
  std::ofstream(folder / "film.mp4") << "mine";
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+E"));
  CHECK(text_of(driver.type("Export video/File", (folder / "new.mp4").string())) == "");
  CHECK(text_of(driver.expect_present("Export video/Export", true)) == "");
  CHECK(text_of(driver.type("Export video/File", (folder / "film.mp4").string())) == "");
  CHECK(text_of(driver.expect_present("Export video/Export", false)) == "");
  CHECK(text_of(driver.expect_present("Export video/Replace the file", true)) == "");
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

TEST_CASE("the number of problems is always there beside a demonstration, none with another sign") {
  workbench::WorkbenchState state = testing::made_state();
  auto view = std::make_shared<workbench::ReviewView>(*state.review);
  view->review.problems.clear();
  state.review = view;
  Desk desk(state);
  CHECK(text_of(desk.driver().expect_present("Menu/0 problems", true)) == "");
  desk.state.review = testing::made_state().review;
  CHECK(desk.driver().frames(2));
  CHECK(text_of(desk.driver().expect_present("Menu/0 problems", false)) == "");
  desk.state.demonstration = {};
  desk.state.review.reset();
  CHECK(desk.driver().frames(2));
  CHECK(text_of(desk.driver().expect_present("Menu/0 problems", false)) == "");
}

TEST_CASE("at rest the speed that playing begins with is lit") {
  Desk desk(testing::made_state());
  CHECK(text_of(desk.driver().click("Menu/Workspaces/Author")) == "");
  CHECK(text_of(desk.driver().expect_value("Timeline/Speed/1×", "on")) == "");
  CHECK(text_of(desk.driver().click("Timeline/Speed/1×")) == "");
  REQUIRE(desk.last<workbench::Play>() != nullptr);
  CHECK(desk.last<workbench::Play>()->speed == 1.0);
  desk.state.play_speed = 2.0;
  CHECK(desk.driver().frames(2));
  CHECK(text_of(desk.driver().expect_value("Timeline/Speed/1×", "off")) == "");
  CHECK(text_of(desk.driver().expect_value("Timeline/Speed/2×", "on")) == "");
}

}  // namespace trocar::ui
