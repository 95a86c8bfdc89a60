// What can be done to a demonstration: once in the window, once on the command line, and both alike.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "engine/demonstration/clip.h"
#include "engine/demonstration/edit_words.h"
#include "tests/support/ui_desk.h"
#include "ui/command_table.h"
#include "ui/command_text.h"

namespace trocar::ui {
namespace {

using demonstration::Demonstration;
using demonstration::Edit;

/// What has to be typed so that the edit does something, by the labels of its form.
const std::map<std::string, std::vector<std::pair<std::string, std::string>>, std::less<>> kTyped{
    {"trim", {{"From", "1.5"}, {"To", "5"}}},
    {"rename", {{"Name", "Another"}}},
    {"delete", {{"From", "2"}, {"To", "3"}}},
    {"splice", {{"Clip from", "1"}, {"Clip to", "2"}}},
    {"overdub", {{"Clip from", "1"}, {"Clip to", "2"}}},
    {"bridge", {{"From", "2"}, {"To", "3"}}},
    {"move", {{"By", "0,0,2.5"}}},
    {"rotate", {{"By", "0,0,10"}}},
    {"offset", {{"By", "1,2,3"}}},
    {"retime", {{"Scale", "2"}}},
    {"snap", {{"From", "1"}, {"To", "2"}}},
    {"jaw", {{"Jaw", "20"}}},
    {"retarget", {{"Block", "1"}, {"Goal", "2"}}},
    {"note", {{"Text", "Here it slips"}}},
    {"remove-note", {{"Note", "77"}}},
    {"label", {{"From", "1"}, {"To", "2.5"}}},
};

/// With a note, and a block that is known.
workbench::WorkbenchState made() {
  workbench::WorkbenchState state = testing::made_state();
  auto recording = std::make_shared<demonstration::Recording>(*testing::made_recording(1));
  recording->provenance.block = 0;
  recording->provenance.goal = 0;
  Demonstration plain = demonstration::make_demonstration({1}, "Expert 1", recording).value();
  demonstration::AddNote note;
  note.text = "A word";
  note.from_s = note.to_s = 1.0;
  auto project = std::make_shared<workbench::Project>(*state.project);
  project->demonstrations[{1}] = std::make_shared<const Demonstration>(demonstration::apply(plain, note, 77).value());
  state.project = project;
  state.review.reset();
  return state;
}

const CommandRow* row_of(std::string_view name, const workbench::WorkbenchState& state) {
  for (const CommandRow& row : command_table()) {
    if (!row.id.starts_with("modify.")) continue;
    if (!row.reason_now(state).empty()) continue;
    for (const Request& request : row.run(state)) {
      const auto* begin = std::get_if<BeginEdit>(&request);
      if (begin != nullptr && demonstration::name_of(begin->edit) == name) return &row;
    }
  }
  return nullptr;
}

/// The words after "trocar demo edit PROJECT DEMO".
Edit typed_on_the_command_line(const workbench::CommitEdit& commit, const workbench::WorkbenchState& state) {
  std::vector<std::string> words = demonstration::split_words(command_text(commit, state)).value();
  REQUIRE(words.size() > 5);
  CHECK(std::vector<std::string>(words.begin(), words.begin() + 3) ==
        std::vector<std::string>{"trocar", "demo", "edit"});
  words.erase(words.begin(), words.begin() + 5);
  const Result<Edit> edit = demonstration::edit_from_words(words);
  if (!edit) FAIL(edit.error().text());
  return *edit;
}

std::uint64_t hash_after(Edit edit, const Demonstration& before) {
  const auto find_clip = [&before](auto* taking) {
    if (taking == nullptr) return;
    taking->clip = std::make_shared<const demonstration::Clip>(
        demonstration::clip_of(before, taking->clip_from_s, taking->clip_to_s).value());
  };
  find_clip(std::get_if<demonstration::Splice>(&edit));
  find_clip(std::get_if<demonstration::Overdub>(&edit));
  const Result<Demonstration> after = demonstration::apply(before, edit, 99);
  if (!after) FAIL(after.error().text());
  return after->hash();
}

}  // namespace

TEST_CASE("each kind of edit has a form in the window and a word on the command line, and both make the same") {
  for (const Edit& kind : demonstration::default_edits()) {
    const std::string name(demonstration::name_of(kind));
    CAPTURE(name);
    Desk desk(made());
    Driver driver = desk.driver();
    CHECK(text_of(driver.key("Ctrl+2")) == "");
    const CommandRow* row = row_of(name, desk.state);
    REQUIRE(row != nullptr);
    CHECK(text_of(driver.click("Menu/" + std::string(row->menu))) == "");
    CHECK(text_of(driver.click(std::string(row->menu) + "/" + std::string(row->title))) == "");
    CHECK(driver.frames(3));
    if (const auto typed = kTyped.find(name); typed != kTyped.end()) {
      for (const auto& [label, text] : typed->second) {
        CAPTURE(label);
        CHECK(text_of(driver.type("Edits/Draft/" + label, text)) == "");
      }
    }
    CHECK(desk.last<workbench::PreviewEdit>() != nullptr);
    CHECK(text_of(driver.click("Edits/Draft/Apply")) == "");
    const auto* commit = desk.last<workbench::CommitEdit>();
    REQUIRE(commit != nullptr);
    const Edit& in_window = std::get<workbench::EditDemonstration>(commit->edit).edit;
    CHECK(demonstration::name_of(in_window) == name);
    const Edit on_line = typed_on_the_command_line(*commit, desk.state);
    const Demonstration& before = *desk.state.project->demonstrations.at({1});
    // Proposing labels needs distances, and gripper events need grippers, that these samples do not have.
    if (name == "propose-labels" || name == "jaw-events") continue;
    CHECK(hash_after(in_window, before) == hash_after(on_line, before));
  }
}

TEST_CASE("the keys of the operations open their forms or act at once") {
  struct Expected {
    const char* keys;
    const char* edit;
    bool at_once;
  };
  for (const Expected& one :
       {Expected{"Ctrl+B", "bridge", false}, Expected{"Ctrl+M", "smooth", false},
        Expected{"Ctrl+Shift+M", "simplify", false}, Expected{"Ctrl+G", "snap", false}, Expected{"S", "retime", false},
        Expected{"Ctrl+Alt+R", "revert", false}, Expected{"Shift+M", "note", false}, Expected{"F2", "rename", false},
        Expected{"M", "note", true}, Expected{";", "jaw", true}, Expected{"'", "jaw", true},
        Expected{"1", "label", true}, Expected{"5", "label", true}, Expected{"Shift+3", "label", true},
        Expected{"Ctrl+Shift+T", "trim-idle", true}}) {
    CAPTURE(one.keys);
    workbench::WorkbenchState state = made();
    state.selection = workbench::TimeSpan{2.0, 3.0};
    Desk desk(state);
    CHECK(text_of(desk.driver().key("Ctrl+2")) == "");
    CHECK(text_of(desk.driver().key(one.keys)) == "");
    CHECK(desk.driver().frames(3));
    const auto* commit = desk.last<workbench::CommitEdit>();
    CHECK((commit != nullptr) == one.at_once);
    if (!one.at_once) {
      REQUIRE(desk.last<workbench::PreviewEdit>() != nullptr);
      CHECK(demonstration::name_of(desk.last<workbench::PreviewEdit>()->edit) == one.edit);
      CHECK(text_of(desk.driver().key("Escape")) == "");
      CHECK(desk.last<workbench::CommitEdit>() == nullptr);
    } else if (commit != nullptr) {
      CHECK(demonstration::name_of(std::get<workbench::EditDemonstration>(commit->edit).edit) == one.edit);
    }
  }
}

TEST_CASE("a form begins at what is selected, and Enter commits it once no field is typed in") {
  workbench::WorkbenchState state = made();
  state.selection = workbench::TimeSpan{2.0, 3.0};
  Desk desk(state);
  Driver driver = desk.driver();
  CHECK(text_of(driver.key("Ctrl+2")) == "");
  CHECK(text_of(driver.key("Ctrl+B")) == "");
  CHECK(driver.frames(3));
  CHECK(text_of(driver.expect_value("Edits/Draft/From", "2.000")) == "");
  CHECK(text_of(driver.type("Edits/Draft/To", "3.5")) == "");
  CHECK(desk.last<workbench::CommitEdit>() == nullptr);
  CHECK(text_of(driver.key("Enter")) == "");
  REQUIRE(desk.last<workbench::CommitEdit>() != nullptr);
  const auto& edit = std::get<workbench::EditDemonstration>(desk.last<workbench::CommitEdit>()->edit).edit;
  CHECK(std::get<demonstration::Bridge>(edit).to_s == 3.5);
}

TEST_CASE("a bridge by policy asks for the model, and by no other way") {
  workbench::WorkbenchState state = testing::made_state_with_model();
  state.selection = workbench::TimeSpan{2.0, 3.0};
  Desk desk(state);
  Driver driver = desk.driver();
  CHECK(text_of(driver.key("Ctrl+2")) == "");
  CHECK(text_of(driver.key("Ctrl+B")) == "");
  CHECK(driver.frames(3));
  CHECK(text_of(driver.expect_present("Edits/Draft/Model", false)) == "");
  CHECK(text_of(driver.click("Edits/Draft/Shape")) == "");
  CHECK(text_of(driver.click("Edits/Draft/Shape/policy")) == "");
  CHECK(driver.frames(2));
  CHECK(text_of(driver.click("Edits/Draft/Model")) == "");
  CHECK(text_of(driver.click("Edits/Draft/Model/exact A · 3")) == "");
  CHECK(text_of(driver.click("Edits/Draft/Apply")) == "");
  REQUIRE(desk.last<workbench::CommitEdit>() != nullptr);
  const auto& edit = std::get<workbench::EditDemonstration>(desk.last<workbench::CommitEdit>()->edit).edit;
  CHECK(std::get<demonstration::Bridge>(edit).model == 3);
  CHECK(command_text(*desk.last<workbench::CommitEdit>(), state).find("--shape policy") != std::string::npos);
}

}  // namespace trocar::ui
