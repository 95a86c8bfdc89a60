// Which keys mean what: presets, changes, conflicts, settings that are odd, and the form that changes them.
#include "ui/keymap.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/support/ui_desk.h"
#include "ui/command_table.h"

namespace trocar::ui {
namespace {

Chord chord(std::string_view words) {
  return chord_from(words).value();
}

KeyChoices changed(std::string_view id, std::vector<Chord> chords) {
  return with_chords({}, id, std::move(chords));
}

KeyChoices read(std::string_view text, std::vector<std::string>& warnings) {
  Diagnostics diagnostics;
  KeyChoices choices = key_choices_from_json(text, diagnostics);
  warnings = diagnostics.warnings();
  return choices;
}

std::size_t changes_of(const Desk& desk) {
  return desk.session->settings().keys.changed.size();
}

}  // namespace

TEST_CASE("without a choice every command has the table's keys") {
  const Keymap keymap;
  for (const CommandRow& row : command_table()) {
    CAPTURE(row.id);
    std::vector<Chord> expected;
    for (const std::string_view keys : row.keys) expected.push_back(chord(keys));
    const auto chords = keymap.chords(row.id);
    CHECK(std::equal(chords.begin(), chords.end(), expected.begin(), expected.end()));
  }
  CHECK(keymap.shown("help.palette") == "Ctrl+P");
  CHECK(keymap.all("help.palette") == "Ctrl+P, Ctrl+K");
  CHECK(keymap.shown("no.command").empty());
}

TEST_CASE("a key can be called by what it writes with Shift") {
  CHECK(chord("?") == chord("Shift+/"));
  CHECK(chord("Ctrl+?") == chord("Ctrl+Shift+/"));
  CHECK(chord(":") == chord("Shift+;"));
  CHECK_FALSE(chord_from("¿"));
}

TEST_CASE("a preset names commands that exist, by chords that can be read, and no chord twice in a context") {
  for (const KeyPreset preset : kKeyPresets) {
    CAPTURE(name_of(preset));
    CHECK(key_preset_from(name_of(preset)) == preset);
    std::set<std::pair<std::string_view, std::string>> seen;
    for (const PresetRow& row : rows_of(preset)) {
      CAPTURE(row.id);
      const CommandRow& of_table = command(row.id);
      for (const std::string_view keys : row.keys) {
        if (keys.empty()) continue;
        CHECK(cannot_bind(chord(keys)) == "");
        CHECK(to_text(chord(keys)) == keys);
        CHECK(seen.insert({of_table.context, std::string(keys)}).second);
      }
    }
  }
}

TEST_CASE("in every preset a chord means one command in each context, and what the preset names has its keys") {
  for (const KeyPreset preset : kKeyPresets) {
    CAPTURE(name_of(preset));
    const Keymap keymap(KeyChoices{preset, {}});
    std::set<std::pair<std::string_view, std::string>> seen;
    for (const CommandRow& row : command_table()) {
      for (const Chord& one : keymap.chords(row.id)) CHECK(seen.insert({row.context, to_text(one)}).second);
    }
    for (const PresetRow& row : rows_of(preset)) CHECK(keymap.shown(row.id) == row.keys.front());
    CHECK(keymap.refused().empty());
  }
}

TEST_CASE("what the user changes wins over preset and table, and gives back what it took when it is reset") {
  KeyChoices choices = changed("edit.split", {chord("Ctrl+Z")});
  CHECK(Keymap(choices).shown("edit.split") == "Ctrl+Z");
  CHECK(Keymap(choices).shown("edit.undo").empty());
  CHECK(Keymap(choices).changed("edit.split"));
  choices = with_reset(choices, "edit.split");
  CHECK(choices == KeyChoices{});
  CHECK(Keymap(choices).shown("edit.undo") == "Ctrl+Z");
}

TEST_CASE("the keys that a command has anyway are no change, and no keys at all are one") {
  CHECK(changed("edit.undo", {chord("Ctrl+Z")}) == KeyChoices{});
  const KeyChoices none = changed("edit.undo", {});
  CHECK(none.changed.size() == 1);
  CHECK(Keymap(none).chords("edit.undo").empty());
}

TEST_CASE("a clash is the same chord in the same context, or in one that holds at the same time") {
  const Keymap keymap;
  const auto same = keymap.clashes("edit.split", chord("Ctrl+Z"));
  REQUIRE(same.size() == 1);
  CHECK(same.front().command == "edit.undo");
  CHECK_FALSE(same.front().both);
  const auto over = keymap.clashes("edit.split", chord("Ctrl+Up"));
  REQUIRE(over.size() == 1);
  CHECK(over.front().command == "tool.nudge_y");
  CHECK(over.front().both);
  CHECK(keymap.clashes("edit.split", chord("Ctrl+Shift+Alt+F12")).empty());
}

TEST_CASE("Tab and Escape cannot be given away, other keys can") {
  CHECK_FALSE(cannot_bind(chord("Tab")).empty());
  CHECK_FALSE(cannot_bind(chord("Ctrl+Tab")).empty());
  CHECK_FALSE(cannot_bind(chord("Escape")).empty());
  for (const char* words : {"Keypad7", "Ctrl+\\", "`", "Shift+Escape", "KeypadPlus"}) {
    CAPTURE(words);
    CHECK(cannot_bind(chord(words)).empty());
    CHECK(to_text(chord(words)) == words);
  }
}

TEST_CASE("choices of keys survive being written and read") {
  KeyChoices choices{KeyPreset::kNle, {}};
  choices = with_chords(choices, "edit.undo", {chord("F5"), chord("Ctrl+Z")});
  choices = with_chords(choices, "view.ghosts", {});
  std::vector<std::string> warnings;
  CHECK(read(to_json(choices), warnings) == choices);
  CHECK(warnings.empty());
}

TEST_CASE("odd keys in the settings are named, and the rest is kept") {
  std::vector<std::string> warnings;
  const KeyChoices choices = read(
      R"({"preset":"emacs","changed":{"edit.undo":["Ctrl+Nothing","F5"],"no.command":["F6"],"edit.redo":["F5"],
          "edit.split":7,"view.ghosts":["F6"],"transport.play":["Escape"]}})",
      warnings);
  CHECK(choices.preset == KeyPreset::kDefault);
  CHECK(Keymap(choices).all("edit.undo") == "F5");
  CHECK(Keymap(choices).shown("view.ghosts") == "F6");
  CHECK(Keymap(choices).shown("edit.split") == "B");
  CHECK(Keymap(choices).shown("edit.redo") == "Ctrl+Shift+Z");
  CHECK(Keymap(choices).shown("transport.play") == "Space");
  const std::vector<std::string> expected{
      "the settings name the keys \"emacs\", which do not exist",
      "the settings give \"edit.split\" no list of keys; it keeps its own",
      "the settings give \"edit.undo\" a key that was left out: no key is named \"Nothing\"",
      "the settings give keys to \"no.command\", which is no command; they were left out",
      "the settings give \"transport.play\" a key that was left out: Escape leaves what was begun",
      "in the settings F5 is to be \"Undo\" and \"Redo\" at once; it stays \"Undo\""};
  CHECK(warnings == expected);
  read("[1, 2", warnings);
  CHECK(warnings.size() == 1);
}

TEST_CASE("keys are changed by pressing others, and then hold, and are shown, everywhere") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+P"));
  for (const char c : std::string("change keys")) desk.window.input().push(Typed{static_cast<std::uint32_t>(c)});
  CHECK(driver.frames(2));
  CHECK(driver.key("Enter"));
  CHECK(driver.frames(4));
  CHECK(text_of(driver.click("Keys/edit.undo/Add keys")) == "");
  CHECK(text_of(driver.expect_present("Keys/Press the keys for “Undo”; Esc leaves it as it is", true)) == "");
  CHECK(driver.key("Ctrl+F5"));
  CHECK(driver.frames(3));
  CHECK(desk.last<workbench::Undo>() == nullptr);
  CHECK(text_of(driver.click("Keys/edit.undo/Ctrl+Z")) == "");
  CHECK(driver.key("Escape"));
  CHECK(text_of(driver.expect_present("Keys/edit.undo/Add keys", false)) == "");
  CHECK(desk.driver().item("Toolbar/Undo").value().shortcut == "Ctrl+F5");
  CHECK(driver.key("Ctrl+Z"));
  CHECK(desk.last<workbench::Undo>() == nullptr);
  CHECK(driver.key("Ctrl+F5"));
  CHECK(desk.last<workbench::Undo>() != nullptr);
  CHECK(driver.key("Shift+/"));
  CHECK(text_of(driver.expect_value("Keyboard shortcuts/Edit/Undo", "Ctrl+F5")) == "");
}

TEST_CASE("keys that mean something else are taken only when that is said") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(text_of(driver.click("Menu/Help")) == "");
  CHECK(text_of(driver.click("Help/Change keys…")) == "");
  CHECK(driver.frames(4));
  CHECK(text_of(driver.click("Keys/edit.undo/Add keys")) == "");
  CHECK(driver.key("Ctrl+R"));
  CHECK(text_of(driver.expect_present("Keys/Conflict/Use it for both", false)) == "");
  CHECK(text_of(driver.click("Keys/Conflict/Leave it there")) == "");
  CHECK(changes_of(desk) == 0);
  CHECK(text_of(driver.click("Keys/edit.undo/Add keys")) == "");
  CHECK(driver.key("Ctrl+R"));
  CHECK(text_of(driver.click("Keys/Conflict/Take it from there")) == "");
  CHECK(driver.frames(3));
  CHECK(text_of(driver.expect_value("Keys/edit.undo/Undo", "Ctrl+Z, Ctrl+R")) == "");
  CHECK(text_of(driver.expect_value("Keys/demo.verify/Verify replay", "")) == "");
  CHECK(text_of(driver.click("Keys/edit.undo/Reset")) == "");
  CHECK(text_of(driver.click("Keys/Reset all")) == "");
  CHECK(driver.frames(3));
  CHECK(changes_of(desk) == 0);
  CHECK(text_of(driver.expect_value("Keys/demo.verify/Verify replay", "Ctrl+R")) == "");
}

TEST_CASE("keys that hold only with a tool in hand can be used for both") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(text_of(driver.click("Menu/Help")) == "");
  CHECK(text_of(driver.click("Help/Change keys…")) == "");
  CHECK(driver.frames(4));
  CHECK(text_of(driver.type("Keys/Find", "split")) == "");
  CHECK(driver.frames(3));
  CHECK(text_of(driver.expect_present("Keys/edit.undo/Add keys", false)) == "");
  CHECK(text_of(driver.click("Keys/edit.split/Add keys")) == "");
  CHECK(driver.key("Y"));
  CHECK(text_of(driver.click("Keys/Conflict/Use it for both")) == "");
  CHECK(driver.frames(3));
  CHECK(text_of(driver.expect_value("Keys/edit.split/Split at playhead", "B, Y")) == "");
  CHECK(changes_of(desk) == 1);
}

TEST_CASE("a preset is chosen in the form, and Escape and Tab are refused with the reason") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(text_of(driver.click("Menu/Help")) == "");
  CHECK(text_of(driver.click("Help/Change keys…")) == "");
  CHECK(driver.frames(4));
  CHECK(text_of(driver.click("Keys/Preset/Blender-like")) == "");
  CHECK(driver.frames(3));
  CHECK(text_of(driver.expect_value("Keys/help.palette/Command palette…", "F3, Ctrl+P")) == "");
  CHECK(text_of(driver.click("Keys/edit.undo/Add keys")) == "");
  CHECK(driver.key("Tab"));
  CHECK(driver.frames(2));
  CHECK(changes_of(desk) == 0);
  CHECK(text_of(driver.click("Keys/edit.undo/Add keys")) == "");
  CHECK(driver.key("Escape"));
  CHECK(text_of(driver.expect_present("Keys/edit.undo/Add keys", true)) == "");
  CHECK(text_of(driver.expect_present("Keys/Press the keys for “Undo”; Esc leaves it as it is", false)) == "");
}

}  // namespace trocar::ui
