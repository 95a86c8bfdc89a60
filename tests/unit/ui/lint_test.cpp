// Every panel, form and menu, at every scale and in every theme: named, whole, apart, large enough.
#include "ui/widgets/lint.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "tests/support/ui_desk.h"
#include "ui/command_table.h"

namespace trocar::ui {
namespace {

constexpr std::array<float, 5> kScales{0.75F, 1.0F, 1.5F, 2.0F, 3.0F};

std::string found_on(const Desk& desk, float scale) {
  std::string words;
  for (const LintFinding& finding : lint(desk.session->items().items(), scale)) {
    words += finding.path + " " + finding.what + "; ";
  }
  return words;
}

std::set<std::string> tabs_of(const Desk& desk) {
  std::set<std::string> tabs;
  for (const Item& item : desk.session->items().items()) {
    if (item.role == "tab") tabs.insert(item.label);
  }
  return tabs;
}

void lint_every_panel(Desk& desk, float scale) {
  for (const char* keys : {"Ctrl+1", "Ctrl+2", "Ctrl+3", "Ctrl+4"}) {
    CAPTURE(keys);
    CHECK(desk.driver().key(keys));
    CHECK(desk.driver().frames(3));
    for (const std::string& tab : tabs_of(desk)) {
      CAPTURE(tab);
      CHECK(text_of(desk.driver().click("Tabs/" + tab)) == "");
      CHECK(desk.driver().frames(2));
      CHECK(found_on(desk, scale) == "");
    }
  }
}

workbench::WorkbenchState live_state() {
  workbench::WorkbenchState state = testing::made_state_with_model();
  state.live.emplace().elapsed_s = 12.3;
  return state;
}

workbench::WorkbenchState loading_state() {
  workbench::WorkbenchState state;
  state.load = workbench::LoadState::kLoading;
  state.path = "/data/a folder with a long name/and another one in it/pegs.trocar";
  return state;
}

workbench::WorkbenchState failed_state() {
  workbench::WorkbenchState state;
  state.load = workbench::LoadState::kFailed;
  state.path = "/data/pegs.trocar";
  state.load_error = "the project is damaged and was left as it is: the journal ends in the middle of a row /data/x";
  return state;
}

Item made(std::string path, Rect rect, Rect clip) {
  Item item;
  item.role = "button";
  item.label = item.path = std::move(path);
  item.rect = rect;
  item.clip = clip;
  return item;
}

}  // namespace

TEST_CASE("the lint finds what has no name, is there twice, lies on another or is too small") {
  const Rect screen{0, 0, 800, 600};
  const auto findings = lint({made("", {0, 0, 50, 30}, screen), made("a", {100, 0, 150, 30}, screen),
                              made("a", {200, 0, 250, 30}, screen), made("b", {240, 10, 290, 40}, screen),
                              made("c", {400, 0, 410, 30}, screen), made("\uf00c d", {500, 0, 550, 30}, screen)},
                             1.0F);
  std::vector<std::string> what;
  for (const LintFinding& finding : findings) what.push_back(finding.what);
  CHECK(what == std::vector<std::string>{"has no name", "is there twice", "lies on a", "is too small a target",
                                         "has a picture in its name"});
}

TEST_CASE("the item list notes what its region cuts off unless it can be scrolled to") {
  ItemLog log;
  const Rect region{0, 0, 100, 100};
  log.begin_frame();
  log.add(made("whole", {10, 10, 60, 40}, region));
  log.add(made("beside", {80, 10, 130, 40}, region));
  Item below = made("below", {10, 90, 60, 120}, region);
  log.add(below);
  below.scrolls_y = true;
  log.add(below);
  below.rect.y1 = 300;
  log.add(below);
  std::vector<bool> cut;
  for (const Item& item : log.items()) cut.push_back(item.text_clipped);
  CHECK(cut == std::vector<bool>{false, true, true, false, true});
}

TEST_CASE("every panel is whole, named and large enough at every scale, in a window of 1600 by 900 pixels") {
  for (const float scale : kScales) {
    CAPTURE(scale);
    Desk desk(testing::made_state_with_model(), scale);
    lint_every_panel(desk, scale);
  }
}

TEST_CASE("so is every panel in a small window, in every theme") {
  for (const ThemeKind theme : kThemeKinds) {
    CAPTURE(name_of(theme));
    Desk desk(testing::made_state_with_model(), 1.0F, theme);
    desk.window.resize({1024, 640});
    lint_every_panel(desk, 1.0F);
  }
}

TEST_CASE("so is every panel without a model, while recording or opening, without a project and with a broken one") {
  for (const float scale : kScales) {
    CAPTURE(scale);
    for (const auto& state :
         {testing::made_state(), live_state(), workbench::WorkbenchState{}, loading_state(), failed_state()}) {
      Desk desk(state, scale);
      lint_every_panel(desk, scale);
    }
  }
}

TEST_CASE("so is every panel with a tool in hand, in every theme") {
  for (const float scale : kScales) {
    for (const auto kind : {workbench::GizmoKind::kMove, workbench::GizmoKind::kTurn}) {
      CAPTURE(scale);
      workbench::WorkbenchState state = testing::made_state_with_model();
      state.gizmo.kind = kind;
      Desk desk(state, scale, kThemeKinds[static_cast<std::size_t>(scale) % kThemeKinds.size()]);
      lint_every_panel(desk, scale);
    }
  }
}

TEST_CASE("so is every form and every menu") {
  for (const float scale : kScales) {
    CAPTURE(scale);
    Desk desk(testing::made_state_with_model(), scale);
    Driver driver = desk.driver();
    for (const char* keys : {"Ctrl+N", "Ctrl+O", "Ctrl+I", "Ctrl+Alt+E", "Ctrl+E", "Ctrl+Shift+E", "Shift+R", "F1",
                             "Shift+/", "Ctrl+Shift+P", "Ctrl+P", "Ctrl+Q"}) {
      CAPTURE(keys);
      CHECK(driver.key(keys));
      CHECK(driver.frames(4));
      CHECK(found_on(desk, scale) == "");
      CHECK(driver.key("Escape"));
      CHECK(driver.frames(2));
    }
    if (desk.session->items().find("Menu/File") == nullptr) continue;
    for (const char* menu : {"File", "Edit", "Modify", "Label", "Select", "Tool", "View", "Transport", "Help"}) {
      CAPTURE(menu);
      CHECK(text_of(driver.click(std::string("Menu/") + menu)) == "");
      CHECK(driver.frames(3));
      CHECK(found_on(desk, scale) == "");
      CHECK(driver.key("Escape"));
      CHECK(driver.frames(2));
    }
  }
}

TEST_CASE("so are the menus in menus, and Help on every panel") {
  for (const float scale : kScales) {
    CAPTURE(scale);
    Desk desk(testing::made_state_with_model(), scale);
    Driver driver = desk.driver();
    for (const std::string_view menu : command_menus()) {
      const std::string above(menu_above(menu));
      if (above.empty()) continue;
      CAPTURE(menu);
      const std::string top = desk.session->items().find("Menu/" + above) == nullptr ? "Menu/All menus" : "";
      if (!top.empty()) CHECK(text_of(driver.click(top)) == "");
      CHECK(text_of(driver.click("Menu/" + above)) == "");
      CHECK(text_of(driver.click(above + "/" + std::string(menu))) == "");
      CHECK(driver.frames(3));
      CHECK(found_on(desk, scale) == "");
      CHECK(driver.key("Escape"));
      CHECK(driver.frames(2));
    }
    CHECK(driver.key("Ctrl+2"));
    CHECK(driver.frames(3));
    for (const std::string& tab : tabs_of(desk)) {
      CAPTURE(tab);
      CHECK(text_of(driver.click("Tabs/" + tab)) == "");
      CHECK(driver.key("F1"));
      CHECK(driver.frames(4));
      CHECK(found_on(desk, scale) == "");
      CHECK(driver.key("Escape"));
      CHECK(driver.frames(2));
    }
  }
}

TEST_CASE("so are the forms of keys and layouts, in each of their states and every theme") {
  for (const float scale : kScales) {
    CAPTURE(scale);
    Desk desk(testing::made_state_with_model(), scale,
              kThemeKinds[static_cast<std::size_t>(scale) % kThemeKinds.size()]);
    Driver driver = desk.driver();
    const auto look = [&] {
      CHECK(driver.frames(4));
      CHECK(found_on(desk, scale) == "");
    };
    CHECK(driver.key("Ctrl+P"));
    for (const char c : std::string("change keys")) desk.window.input().push(Typed{static_cast<std::uint32_t>(c)});
    CHECK(driver.frames(2));
    CHECK(driver.key("Enter"));
    look();
    CHECK(text_of(driver.type("Keys/Find", "undo")) == "");
    look();
    CHECK(text_of(driver.click("Keys/edit.undo/Add keys")) == "");
    look();
    CHECK(driver.key("Y"));
    look();
    CHECK(text_of(driver.click("Keys/Conflict/Use it for both")) == "");
    look();
    CHECK(text_of(driver.click("Keys/edit.undo/Add keys")) == "");
    CHECK(driver.key("Tab"));
    look();
    CHECK(driver.key("Escape"));
    CHECK(driver.key("Ctrl+Shift+P"));
    look();
    CHECK(text_of(driver.type("Layouts/Name", "A name that is longer than most people would think of")) == "");
    CHECK(text_of(driver.click("Layouts/Save")) == "");
    look();
    CHECK(text_of(driver.click("Named/A name that is longer than most people would think of/Rename")) == "");
    look();
    CHECK(text_of(driver.click("Rename layout/Leave it")) == "");
    CHECK(text_of(driver.click("Named/A name that is longer than most people would think of/Delete")) == "");
    look();
  }
}

TEST_CASE("a long sentence in the status line ends before the last command, at every scale") {
  for (const float scale : kScales) {
    CAPTURE(scale);
    Desk desk(testing::made_state(), scale);
    Driver driver = desk.driver();
    CHECK(text_of(driver.click("Tabs/Library")) == "");
    CHECK(driver.frames(2));
    CHECK(text_of(driver.click("Library/Trim idle")) == "");
    desk.state.done = std::string(300, 'm');
    CHECK(driver.frames(3));
    const Item hint = driver.item("Status/Hint").value();
    const Item last = driver.item("Status/Last command").value();
    CHECK(hint.value == desk.state.done);
    CHECK(hint.rect.x1 < last.rect.x0);
    CHECK(last.rect.x1 < driver.item("Status/Copy as command").value().rect.x0);
  }
}

TEST_CASE("the shortcut sheet shows the keys of every command that has some, at every scale") {
  for (const float scale : kScales) {
    CAPTURE(scale);
    Desk desk(testing::made_state(), scale);
    CHECK(desk.driver().key("Shift+/"));
    CHECK(desk.driver().frames(4));
    for (const CommandRow& row : command_table()) {
      if (row.keys.empty()) continue;
      CAPTURE(row.title);
      const Item* shown =
          desk.session->items().find("Keyboard shortcuts/" + std::string(row.menu) + "/" + std::string(row.title));
      REQUIRE(shown != nullptr);
      CHECK(shown->rect.x0 >= shown->clip.x0);
      CHECK(shown->rect.x1 <= shown->clip.x1);
    }
  }
}

}  // namespace trocar::ui
