#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>

#include "tests/support/ui_desk.h"
#include "tests/support/ui_state.h"

namespace trocar::ui {
namespace {

using workbench::CommitEdit;
using workbench::PlanBatch;

/// The Library workspace, its table worked out.
struct LibraryDesk : Desk {
  explicit LibraryDesk(const workbench::WorkbenchState& shown = testing::made_state()) : Desk(shown) {
    CHECK(driver().key("Ctrl+1"));
    CHECK(driver().frames(3));
  }
  bool shows(const char* path) { return driver().expect_present(path, true).has_value(); }
  std::string click(const char* path) {
    std::string words = text_of(driver().click(path));
    CHECK(driver().frames(2));
    return words;
  }
  void take_plan() {
    const PlanBatch* asked = last<PlanBatch>();
    REQUIRE(asked != nullptr);
    Progress progress;
    state.batch = workbench::plan_batch({state.project, asked->demonstrations, asked->words}, progress);
    CHECK(driver().frames(2));
  }
};

workbench::WorkbenchState many_rows(int count) {
  workbench::WorkbenchState state = testing::made_state();
  auto project = std::make_shared<workbench::Project>(*state.project);
  const auto first = project->demonstrations.begin()->second;
  for (int i = 10; i < 10 + count; ++i) {
    auto copy = std::make_shared<demonstration::Demonstration>(*first);
    copy->id = {i};
    copy->name = "Copy " + std::to_string(i);
    project->demonstrations[copy->id] = copy;
  }
  state.project = project;
  state.library = workbench::LibraryMaker().make({project, {}}, 1'000'000);
  return state;
}

}  // namespace

TEST_CASE("a filter shows what answers it, and a wrong one says why and leaves the rows as they are") {
  LibraryDesk desk;
  CHECK(desk.shows("Demonstrations/Novice 2"));
  CHECK(text_of(desk.driver().type("Filter/Query", "outcome:success")) == "");
  CHECK(desk.driver().frames(2));
  CHECK_FALSE(desk.shows("Demonstrations/Novice 2"));
  CHECK(desk.shows("Demonstrations/Expert 1"));
  CHECK(text_of(desk.driver().type("Filter/Query", "outcome:")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(desk.shows("Demonstrations/Expert 1"));
  CHECK(text_of(desk.driver().type("Filter/Query", "nobody")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(desk.click("Demonstrations/Show all") == "");
  CHECK(desk.shows("Demonstrations/Novice 2"));
}

TEST_CASE("a chip is put into the filter and taken out by a click") {
  LibraryDesk desk;
  CHECK(desk.click("Chips/outcome:success") == "");
  CHECK(text_of(desk.driver().expect_value("Filter/Query", "outcome:success")) == "");
  CHECK_FALSE(desk.shows("Demonstrations/Novice 2"));
  CHECK(desk.click("Chips/outcome:success") == "");
  CHECK(desk.shows("Demonstrations/Novice 2"));
}

TEST_CASE("an act on several is planned first, shown for each, and committed once") {
  LibraryDesk desk;
  CHECK(desk.click("Demonstrations/Choose all") == "");
  CHECK(desk.click("Batch/Bad") == "");
  REQUIRE(desk.last<PlanBatch>() != nullptr);
  CHECK(desk.last<PlanBatch>()->demonstrations.size() == 2);
  CHECK(text_of(desk.driver().expect_enabled("Batch/Apply", false)) == "");
  desk.take_plan();
  CHECK(desk.last<CommitEdit>() == nullptr);
  CHECK(text_of(desk.driver().expect_contains("Batch/Novice 2 2", "flag bad")) == "");
  CHECK(desk.click("Batch/Apply") == "");
  REQUIRE(desk.last<CommitEdit>() != nullptr);
  CHECK(std::get<workbench::Batch>(desk.last<CommitEdit>()->edit).edits.size() == 2);
  CHECK(std::count_if(desk.commands.begin(), desk.commands.end(),
                      [](const auto& each) { return std::holds_alternative<CommitEdit>(each); }) == 1);
  CHECK(desk.last<PlanBatch>()->words.empty());
}

TEST_CASE("Escape and another choice end what was planned") {
  LibraryDesk desk;
  CHECK(desk.click("Novice 2/Choose") == "");
  CHECK(desk.click("Batch/Remove") == "");
  CHECK(desk.driver().key("Escape"));
  CHECK(desk.driver().frames(2));
  CHECK(desk.shows("Batch/Remove"));
  CHECK(desk.click("Batch/Remove") == "");
  CHECK(desk.click("Expert 1/Choose") == "");
  CHECK(desk.shows("Batch/Remove"));
  CHECK(desk.last<CommitEdit>() == nullptr);
}

TEST_CASE("a click on a column sorts by it, a second one the other way round") {
  LibraryDesk desk;
  CHECK(desk.click("Columns/Length") == "");
  CHECK(text_of(desk.driver().expect_value("Columns/Length", "falling")) == "");
  CHECK(desk.click("Columns/Length") == "");
  CHECK(text_of(desk.driver().expect_value("Columns/Length", "rising")) == "");
}

TEST_CASE("what lies in the trash is listed and restored") {
  workbench::WorkbenchState state = testing::made_state();
  auto project = std::make_shared<workbench::Project>(*state.project);
  project->trash[{2}] = project->demonstrations.at({2});
  project->demonstrations.erase({2});
  state.project = project;
  state.library = workbench::LibraryMaker().make({project, {}}, 1'000'000);
  LibraryDesk desk(state);
  CHECK(desk.click("Trash/Novice 2/Restore") == "");
  REQUIRE(desk.last<CommitEdit>() != nullptr);
  CHECK(std::get<workbench::RestoreDemonstration>(desk.last<CommitEdit>()->edit).demonstration ==
        workbench::DemonstrationId{2});
}

TEST_CASE("while a take goes on no filter is saved or forgotten, and nothing leaves the trash") {
  workbench::WorkbenchState state = testing::made_state();
  auto project = std::make_shared<workbench::Project>(*state.project);
  project->trash[{2}] = project->demonstrations.at({2});
  project->demonstrations.erase({2});
  project->filters["long"] = "length>3";
  state.project = project;
  state.library = workbench::LibraryMaker().make({project, {}}, 1'000'000);
  LibraryDesk desk(state);
  const auto refused = [&](const char* path) {
    CAPTURE(path);
    CHECK(desk.driver().frames(2));
    CHECK(desk.driver().item(path).value().enabled);
    desk.state.live.emplace().samples = 10;
    CHECK(desk.driver().frames(2));
    CHECK(desk.driver().item(path).value().reason == "A transfer is being recorded");
    CHECK_FALSE(desk.driver().click(path));
    desk.state.live.reset();
  };
  refused("Trash/Novice 2/Restore");
  CHECK(text_of(desk.driver().type("Filter/Query", "length<3")) == "");
  CHECK(text_of(desk.driver().type("Filter/Filter name", "short")) == "");
  refused("Filter/Save");
  CHECK(text_of(desk.driver().type("Filter/Query", "length>3")) == "");
  refused("Filter/Forget");
  CHECK(desk.last<CommitEdit>() == nullptr);
}

TEST_CASE("of a thousand rows only those in sight are drawn") {
  LibraryDesk desk(many_rows(1000));
  const auto& items = desk.session->items().items();
  const auto rows = std::count_if(items.begin(), items.end(), [](const Item& item) { return item.label == "Choose"; });
  CHECK(rows > 3);
  CHECK(rows < 60);
}

TEST_CASE("the table without rows says that they are being gathered") {
  workbench::WorkbenchState state = testing::made_state();
  state.library = nullptr;
  state.library_on = false;
  LibraryDesk desk(state);
  REQUIRE(desk.last<workbench::ShowLibrary>() != nullptr);
  CHECK(desk.last<workbench::ShowLibrary>()->on);
  CHECK_FALSE(desk.shows("Demonstrations/Expert 1"));
}

TEST_CASE("the history goes to a point, compares with it, names it and asks for the pictures in sight") {
  LibraryDesk desk;
  CHECK(desk.click("Tabs/History") == "");
  REQUIRE(desk.last<workbench::SketchHistory>() != nullptr);
  CHECK(desk.last<workbench::SketchHistory>()->nodes == std::vector<std::int64_t>{2, 1});
  CHECK(desk.click("History/1 · Record Expert 1/Compare with") == "");
  const bool compared = std::any_of(desk.commands.begin(), desk.commands.end(), [](const auto& each) {
    const auto* compare = std::get_if<workbench::CompareWith>(&each);
    return compare != nullptr && compare->settings.against.node == 1;
  });
  CHECK(compared);
  CHECK(desk.click("Tabs/History") == "");
  CHECK(desk.click("History/1 · Record Expert 1") == "");
  REQUIRE(desk.last<workbench::GoToHistory>() != nullptr);
  CHECK(desk.last<workbench::GoToHistory>()->node == 1);
  CHECK(desk.driver().key("Ctrl+S"));
  REQUIRE(desk.last<workbench::NameCheckpoint>() != nullptr);
  CHECK(desk.last<workbench::NameCheckpoint>()->node == 2);
}

TEST_CASE("the history is searched by what was done and by the names of points") {
  workbench::WorkbenchState state = testing::made_state();
  state.checkpoints[1] = "Before smoothing";
  LibraryDesk desk(state);
  CHECK(desk.click("Tabs/History") == "");
  CHECK(text_of(desk.driver().type("History/Search", "smoothing")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(desk.shows("History/1 · Record Expert 1"));
  CHECK_FALSE(desk.shows("History/2 · Record Novice 2"));
}

}  // namespace trocar::ui
