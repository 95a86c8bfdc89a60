// The window without a mouse: Tab from widget to widget, Enter and Space to press, and what a script may type onto.
#include <doctest/doctest.h>

#include <set>
#include <string>

#include "tests/support/ui_desk.h"

namespace trocar::ui {
namespace {

const KeyboardFocus& focus_of(Desk& desk) {
  return desk.session->ui().focus();
}

/// Presses Tab until the ring is on `path`; false if it comes round without.
bool tab_to(Desk& desk, const std::string& path) {
  std::set<std::string> seen;
  while (seen.insert(focus_of(desk).path()).second || seen.size() < 2) {
    CHECK(desk.driver().key("Tab"));
    CHECK(desk.driver().frames(2));
    if (focus_of(desk).path() == path) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("Tab goes to every button that can be pressed, and Shift+Tab back") {
  Desk desk(testing::made_state());
  CHECK_FALSE(focus_of(desk).shown());
  CHECK(desk.driver().key("Tab"));
  CHECK(focus_of(desk).shown());
  const std::string first = focus_of(desk).path();
  CHECK(desk.driver().key("Tab"));
  const std::string second = focus_of(desk).path();
  CHECK(second != first);
  CHECK(desk.driver().key("Shift+Tab"));
  CHECK(focus_of(desk).path() == first);
  for (const char* path : {"Library/Record…", "Library/Demonstrations/Novice 2", "Timeline/Play"}) {
    CAPTURE(path);
    CHECK(tab_to(desk, path));
  }
}

TEST_CASE("in every workspace Tab comes by everything that can be pressed, chosen or filled in") {
  const std::set<std::string> roles{"button", "toggle", "checkbox", "combo", "slider", "field", "row"};
  for (const char* workspace : {"Ctrl+1", "Ctrl+2", "Ctrl+3", "Ctrl+4"}) {
    CAPTURE(workspace);
    Desk desk(testing::made_state_with_model());
    CHECK(desk.driver().key(workspace));
    CHECK(desk.driver().frames(4));
    std::set<std::string> wanted;
    for (const Item& item : desk.session->items().items()) {
      if (item.enabled && roles.contains(item.role) && item.reachable()) wanted.insert(item.path);
    }
    REQUIRE(wanted.size() > 20);
    const std::size_t most = 3 * wanted.size() + 60;
    for (std::size_t i = 0; i < most && !wanted.empty(); ++i) {
      CHECK(desk.driver().key("Tab"));
      wanted.erase(focus_of(desk).path());
    }
    std::string missed;
    for (const std::string& path : wanted) missed += path + "; ";
    CHECK(missed == "");
  }
}

TEST_CASE("Enter presses what the ring is on, and the arrows go along a list") {
  Desk desk(testing::made_state());
  REQUIRE(tab_to(desk, "Library/Demonstrations/Expert 1"));
  CHECK(desk.driver().key("Down"));
  CHECK(focus_of(desk).path() == "Library/Demonstrations/Novice 2");
  CHECK(desk.driver().key("Enter"));
  CHECK(desk.driver().frames(4));
  REQUIRE(desk.last<workbench::SelectDemonstration>() != nullptr);
  CHECK(desk.last<workbench::SelectDemonstration>()->id.value == 2);
  CHECK(focus_of(desk).shown());
}

TEST_CASE("Space plays while no ring is seen, and presses while one is") {
  Desk desk(testing::made_state());
  CHECK(desk.driver().key("Space"));
  CHECK(desk.last<workbench::Play>() != nullptr);
  desk.commands.clear();
  REQUIRE(tab_to(desk, "Library/Demonstrations/Novice 2"));
  CHECK(desk.driver().key("Space"));
  CHECK(desk.driver().frames(4));
  CHECK(desk.last<workbench::Play>() == nullptr);
  CHECK(desk.last<workbench::SelectDemonstration>() != nullptr);
}

TEST_CASE("a form keeps the ring to itself, takes letters where a field is reached, and Escape ends it") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(text_of(driver.click("Library/Record…")) == "");
  CHECK(text_of(driver.click("Record/Who/Scripted")) == "");
  REQUIRE(tab_to(desk, "Record/Name"));
  desk.window.input().push(Typed{'x'});
  CHECK(driver.frames(2));
  CHECK(text_of(driver.expect_value("Record/Name", "x")) == "");
  REQUIRE(tab_to(desk, "Record/Start recording"));
  CHECK(focus_of(desk).path().starts_with("Record/"));
  CHECK(driver.key("Enter"));
  CHECK(driver.frames(4));
  REQUIRE(desk.last<workbench::RecordScripted>() != nullptr);
  CHECK(desk.last<workbench::RecordScripted>()->name == "x");
}

TEST_CASE("Tab out of a field hands over what was typed into it") {
  Desk desk(testing::made_state());
  REQUIRE(tab_to(desk, "Inspector/Demonstration/Name"));
  CHECK(desk.driver().key("Ctrl+A"));
  desk.window.input().push(Typed{'N'});
  CHECK(desk.driver().frames(2));
  CHECK(desk.driver().key("Tab"));
  CHECK(desk.driver().frames(2));
  REQUIRE(desk.last<workbench::CommitEdit>() != nullptr);
  const auto& edit = std::get<workbench::EditDemonstration>(desk.last<workbench::CommitEdit>()->edit);
  CHECK(std::get<demonstration::Rename>(edit.edit).name == "N");
}

TEST_CASE("a list that drops down is opened, walked and chosen from by keys") {
  Desk desk(testing::made_state_with_model());
  Driver driver = desk.driver();
  CHECK(text_of(driver.click("Tabs/Fields")) == "");
  REQUIRE(tab_to(desk, "Fields/Layer"));
  CHECK(driver.key("Enter"));
  CHECK(driver.frames(4));
  REQUIRE(tab_to(desk, "Fields/Layer/value"));
  CHECK(driver.key("Enter"));
  CHECK(driver.frames(4));
  REQUIRE(desk.last<workbench::SetField>() != nullptr);
  CHECK(desk.last<workbench::SetField>()->settings.layer == learning::Layer::kValue);
}

TEST_CASE("a slider takes a typed number on Enter") {
  Desk desk(testing::made_state_with_model());
  Driver driver = desk.driver();
  CHECK(text_of(driver.click("Tabs/Fields")) == "");
  REQUIRE(tab_to(desk, "Fields/z/Index"));
  CHECK(driver.key("Enter"));
  CHECK(driver.frames(4));
  CHECK(driver.key("Ctrl+A"));
  desk.window.input().push(Typed{'5'});
  CHECK(driver.frames(2));
  CHECK(driver.key("Enter"));
  CHECK(text_of(driver.expect_value("Fields/z/Index", "z = 5")) == "");
  CHECK(focus_of(desk).path() == "Fields/z/Index");
}

TEST_CASE("a click takes the ring away") {
  Desk desk(testing::made_state());
  CHECK(desk.driver().key("Tab"));
  CHECK(focus_of(desk).shown());
  CHECK(text_of(desk.driver().click("Library/Demonstrations/Novice 2")) == "");
  CHECK_FALSE(focus_of(desk).shown());
}

TEST_CASE("a script cannot type onto a button, and no letter of it becomes a command") {
  Desk desk(testing::made_state());
  const Status typed = desk.driver().type("Toolbar/Find a command…", "trim");
  REQUIRE_FALSE(typed);
  CHECK(typed.error().text() ==
        "\"Toolbar/Find a command…\" is a button and takes no text; type goes to a field or slider");
  CHECK(desk.last<workbench::CommitEdit>() == nullptr);
}

TEST_CASE("rows of the wide library can be clicked across all of their columns") {
  Desk desk(testing::made_state_with_model());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+1"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.click("Library/Demonstrations/Novice 2")) == "");
  REQUIRE(desk.last<workbench::SelectDemonstration>() != nullptr);
  CHECK(desk.last<workbench::SelectDemonstration>()->id.value == 2);
}

}  // namespace trocar::ui
