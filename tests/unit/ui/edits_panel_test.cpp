#include <doctest/doctest.h>

#include <algorithm>

#include "engine/demonstration/edit_sentence.h"
#include "engine/demonstration/edits.h"
#include "engine/workbench/edit_preview.h"
#include "tests/support/ui_desk.h"
#include "tests/support/ui_state.h"
#include "ui/command_text.h"
#include "ui/icons.h"

namespace trocar::ui {
namespace {

/// A desk with the form for a new edit of the chosen kind open.
struct EditDesk : Desk {
  explicit EditDesk(const std::string& kind) : Desk(testing::made_state()) {
    CHECK(text_of(driver().click("Menu/Workspaces/Author")) == "");
    CHECK(text_of(driver().click("Tabs/Edits")) == "");
    CHECK(text_of(driver().click("Edits/Kind of edit")) == "");
    CHECK(text_of(driver().click("Edits/Kind of edit/" + kind)) == "");
    CHECK(text_of(driver().click("Edits/Add edit…")) == "");
    CHECK(driver().frames(2));
  }
  int commits() const {
    return static_cast<int>(std::count_if(commands.begin(), commands.end(), [](const workbench::Command& command) {
      return std::holds_alternative<workbench::CommitEdit>(command);
    }));
  }
};

const demonstration::Smooth kSmooth{1.0, 2.0};
const demonstration::Offset kOffset{demonstration::Arms::kLeft, {0.0, 0.0, 0.002}};

workbench::WorkbenchState with_two_edits() {
  auto state = testing::made_state();
  auto edited = demonstration::apply(*state.project->demonstrations.at({1}), kSmooth, 11).value();
  edited = demonstration::apply(edited, kOffset, 12).value();
  auto project = std::make_shared<workbench::Project>(*state.project);
  project->demonstrations[{1}] = std::make_shared<const demonstration::Demonstration>(edited);
  state.project = project;
  return state;
}

struct StackDesk : Desk {
  using Desk::Desk;
  void open_stack() {
    CHECK(text_of(driver().click("Menu/Workspaces/Author")) == "");
    CHECK(text_of(driver().click("Tabs/Edits")) == "");
    CHECK(driver().frames(2));
  }
  /// As a hand does, whether it is enabled or not.
  std::string press(const Item& item) {
    window.input().push(MouseMoved{item.rect.centre_x(), item.rect.centre_y()});
    for (const bool down : {true, false}) {
      if (const Status drawn = driver().frames(1); !drawn) return drawn.error().text();
      window.input().push(MouseButton{0, down});
    }
    return text_of(driver().frames(2));
  }
};

}  // namespace

TEST_CASE("an edit is previewed while its parameters change and committed once") {
  EditDesk desk("Move");
  REQUIRE(desk.last<workbench::PreviewEdit>() != nullptr);
  CHECK(text_of(desk.driver().type("Edits/Draft/By", "0,0,2.5")) == "");
  CHECK(desk.driver().frames(2));
  const auto& previewed = std::get<demonstration::MoveTool>(desk.last<workbench::PreviewEdit>()->edit);
  CHECK(previewed.by_m == Eigen::Vector3d(0.0, 0.0, 0.0025));
  CHECK(desk.commits() == 0);
  CHECK(text_of(desk.driver().click("Edits/Draft/Apply")) == "");
  CHECK(desk.commits() == 1);
  const auto& edit = std::get<workbench::EditDemonstration>(desk.last<workbench::CommitEdit>()->edit);
  CHECK(std::get<demonstration::MoveTool>(edit.edit).by_m.z() == 0.0025);
  CHECK(desk.last<workbench::EndPreview>() != nullptr);
  CHECK(text_of(desk.driver().expect_present("Edits/Draft/Apply", false)) == "");
}

TEST_CASE("Escape leaves an edit, and nothing is committed") {
  EditDesk desk("Offset");
  CHECK(text_of(desk.driver().key("Escape")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(desk.commits() == 0);
  CHECK(desk.last<workbench::EndPreview>() != nullptr);
  CHECK(text_of(desk.driver().expect_present("Edits/Draft/Apply", false)) == "");
}

TEST_CASE("what makes no edit cannot be applied") {
  EditDesk desk("Move");
  CHECK(text_of(desk.driver().type("Edits/Draft/By", "far")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(text_of(desk.driver().expect_enabled("Edits/Draft/Apply", false)) == "");
}

TEST_CASE("when the demonstration changes below an open form, its preview is asked for again") {
  EditDesk desk("Move");
  desk.commands.clear();
  const auto shown = desk.state.project->demonstrations.at({1});
  auto project = std::make_shared<workbench::Project>(*desk.state.project);
  project->demonstrations[{1}] = std::make_shared<const demonstration::Demonstration>(*shown);
  desk.state.project = project;
  CHECK(desk.driver().frames(2));
  CHECK(desk.last<workbench::PreviewEdit>() != nullptr);
}

TEST_CASE("an edit whose span is gone says in the stack that it is passed over, and why") {
  auto state = testing::made_state();
  const auto shown = state.project->demonstrations.at({1});
  const double end_s = shown->full_duration_s();
  auto edited = demonstration::apply(*shown, demonstration::Smooth{end_s - 1.0, end_s - 0.5}, 11).value();
  edited = demonstration::apply(edited, demonstration::DeleteSpan{end_s - 2.0, end_s, true}, 12).value();
  const auto conflict = demonstration::with_stack(edited, demonstration::entry_moved(*edited.stack, 12, 0).value());
  REQUIRE_FALSE(conflict.stack->back().conflict.empty());
  const std::string words =
      "Edits/Stack/2/" + std::string(icon::kWarning) + " Conflict, passed over: " + conflict.stack->back().conflict;
  const auto shows = [&](const demonstration::Demonstration& document, bool present) {
    auto project = std::make_shared<workbench::Project>(*state.project);
    project->demonstrations[{1}] = std::make_shared<const demonstration::Demonstration>(document);
    state.project = project;
    Desk desk(state);
    CHECK(text_of(desk.driver().click("Menu/Workspaces/Author")) == "");
    CHECK(text_of(desk.driver().click("Tabs/Edits")) == "");
    CHECK(desk.driver().frames(2));
    return text_of(desk.driver().expect_present(words, present));
  };
  CHECK(shows(conflict, true) == "");
  CHECK(shows(edited, false) == "");
}

TEST_CASE("the form of a snap tells its actions, its error and the cells that it fills in") {
  EditDesk desk("Snap");
  const auto shown = desk.state.project->demonstrations.at({1});
  const demonstration::SnapToGrid snap{1.0, 2.0};
  desk.state.preview = workbench::preview_of({shown, snap, 0, ""});
  REQUIRE(desk.state.preview->error == "");
  REQUIRE(desk.state.preview->snap.size() == 1);
  CHECK(desk.driver().frames(2));
  for (const char* fact : {"Actions, left", "Error, left", "Cells, left"}) {
    CHECK(text_of(desk.driver().expect_present(std::string("Edits/Draft/") + fact, true)) == "");
  }
}

TEST_CASE("a time warp is drawn by its knots: dragged, added, shifted from the keyboard, or typed") {
  EditDesk desk("Retime");
  CHECK(text_of(desk.driver().type("Edits/Draft/From", "2")) == "");
  CHECK(text_of(desk.driver().type("Edits/Draft/To", "4")) == "");
  CHECK(text_of(desk.driver().click("Edits/Draft/Mode")) == "");
  CHECK(text_of(desk.driver().click("Edits/Draft/Mode/warp")) == "");
  CHECK(desk.driver().frames(3));
  const auto knots = [&] { return std::get<demonstration::Retime>(desk.last<workbench::PreviewEdit>()->edit).knots_s; };
  CHECK(text_of(desk.driver().expect_present("Edits/Draft/Scale", false)) == "");
  REQUIRE(knots().size() == 2);
  CHECK(knots()[0] == Eigen::Vector2d(3.0, 3.0));
  CHECK(knots()[1] == Eigen::Vector2d(4.0, 4.0));
  CHECK(text_of(desk.driver().drag("Edits/Draft/Curve/Knot 1", 0.0F, -20.0F)) == "");
  CHECK(desk.driver().frames(2));
  CHECK(knots()[0].x() == doctest::Approx(3.0).epsilon(0.02));
  CHECK(knots()[0].y() > 3.2);
  const double before_s = knots()[0].y();
  CHECK(text_of(desk.driver().click("Edits/Draft/Curve/Add knot")) == "");
  CHECK(desk.driver().frames(2));
  REQUIRE(knots().size() == 3);
  CHECK(knots()[1].y() == before_s);
  CHECK(text_of(desk.driver().click("Edits/Draft/Curve/Remove knot")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(knots().size() == 2);
  for (int i = 0; i < 300 && desk.session->ui().focus().path() != "Edits/Draft/Curve/Time warp"; ++i) {
    CHECK(text_of(desk.driver().key("Tab")) == "");
  }
  REQUIRE(desk.session->ui().focus().path() == "Edits/Draft/Curve/Time warp");
  CHECK(text_of(desk.driver().key("Down")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(knots()[0].y() == doctest::Approx(before_s - 0.04));
  CHECK(text_of(desk.driver().type("Edits/Draft/Knots", "2.5:3.1,4:5")) == "");
  CHECK(desk.driver().frames(2));
  REQUIRE(knots().size() == 2);
  CHECK(knots()[1] == Eigen::Vector2d(4.0, 5.0));
  CHECK(text_of(desk.driver().expect_value("Edits/Draft/Curve/Knot 1", "2.50 → 3.10 s")) == "");
}

TEST_CASE("what is idle is listed with a check box each, and one that is cleared stays") {
  EditDesk desk("Trim idle");
  auto preview = std::make_shared<workbench::EditPreview>();
  preview->before = desk.state.project->demonstrations.at({1});
  preview->after = preview->before;
  preview->idle = {{0.0, 1.0, 0.0, 0.9, true, false}, {4.0, 5.0, 4.1, 4.9, false, false}};
  desk.state.preview = preview;
  CHECK(desk.driver().frames(2));
  CHECK(text_of(desk.driver().click("Edits/Draft/Idle/4.00–5.00 s, inside")) == "");
  CHECK(desk.driver().frames(2));
  const auto stay = [&] { return std::get<demonstration::TrimIdle>(desk.last<workbench::PreviewEdit>()->edit).stay_s; };
  CHECK(stay() == std::vector<double>{4.5});
  auto kept = std::make_shared<workbench::EditPreview>(*preview);
  kept->idle[1].stays = true;
  desk.state.preview = kept;
  CHECK(desk.driver().frames(2));
  CHECK(text_of(desk.driver().expect_value("Edits/Draft/Idle/4.00–5.00 s, inside", "off")) == "");
  CHECK(text_of(desk.driver().click("Edits/Draft/Idle/4.00–5.00 s, inside")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(stay().empty());
}

TEST_CASE("perturbed copies are previewed, and made as one step beside the demonstration") {
  Desk desk(testing::made_state());
  CHECK(text_of(desk.driver().click("Menu/Modify")) == "");
  CHECK(text_of(desk.driver().click("Modify/Perturbed copies…")) == "");
  CHECK(desk.driver().frames(3));
  REQUIRE(desk.last<workbench::PreviewEdit>() != nullptr);
  CHECK(text_of(desk.driver().type("Edits/Draft/Sigma", "0.5")) == "");
  CHECK(text_of(desk.driver().type("Edits/Draft/Copies", "8")) == "");
  CHECK(text_of(desk.driver().click("Edits/Draft/Make copies")) == "");
  const auto* commit = desk.last<workbench::CommitEdit>();
  REQUIRE(commit != nullptr);
  const auto& copies = std::get<workbench::CopyDemonstrations>(commit->edit).copies;
  REQUIRE(copies.size() == 8);
  for (std::size_t nth = 0; nth < copies.size(); ++nth) {
    REQUIRE(copies[nth].edits.size() == 1);
    const auto& noise = std::get<demonstration::Perturb>(copies[nth].edits.front());
    CHECK(noise.sigma_m == doctest::Approx(0.0005));
    CHECK(noise.seed == 1 + nth);
  }
  const std::string typed = command_text(*commit, desk.state);
  CHECK(typed.ends_with("pegs.trocar 1 --copies 8 --perturb-mm 0.5 --period 1 --seed 1"));
}

TEST_CASE("an edit of the stack is switched off, moved and removed") {
  auto state = testing::made_state();
  const auto& shown = *state.project->demonstrations.at({1});
  auto edited = demonstration::apply(shown, demonstration::Offset{demonstration::Arms::kLeft, {0.001, 0.0, 0.0}}, 11);
  edited = demonstration::apply(*edited, demonstration::Trim{1.0, 5.0}, 12);
  auto project = std::make_shared<workbench::Project>(*state.project);
  project->demonstrations[{1}] = std::make_shared<const demonstration::Demonstration>(*edited);
  state.project = project;
  Desk desk(state);
  CHECK(text_of(desk.driver().click("Menu/Workspaces/Author")) == "");
  CHECK(text_of(desk.driver().click("Tabs/Edits")) == "");
  CHECK(text_of(desk.driver().click("Edits/Stack/1/Offset")) == "");
  const auto& off = std::get<workbench::EnableStackEntry>(desk.last<workbench::CommitEdit>()->edit);
  CHECK(off.entry == 11);
  CHECK_FALSE(off.enabled);
  CHECK(text_of(desk.driver().click("Edits/Stack/2/Earlier")) == "");
  const auto& moved = std::get<workbench::MoveStackEntry>(desk.last<workbench::CommitEdit>()->edit);
  CHECK(moved.entry == 12);
  CHECK(moved.place == 0);
  CHECK(text_of(desk.driver().click("Edits/Stack/2/Remove")) == "");
  CHECK(std::get<workbench::RemoveStackEntry>(desk.last<workbench::CommitEdit>()->edit).entry == 12);
}

TEST_CASE("rows of the stack tell edits of one kind apart by their parameters") {
  using demonstration::particulars;
  CHECK(particulars(demonstration::Smooth{1.0, 2.0}).starts_with("1.00–2.00 s of both tools over "));
  CHECK(particulars(demonstration::Trim{0.0, 8.0}) == "to 0.00–8.00 s");
  CHECK(particulars(demonstration::MoveTool{demonstration::Arms::kRight, 2.0, {0.0, 0.0, 0.0025}}) ==
        "the right tool by 0.00, 0.00, 2.50 mm at 2.00 s");
  CHECK(particulars(demonstration::Mirror{}).empty());
  CHECK(particulars(demonstration::Rename{"A of B"}) == "to A of B");
  StackDesk desk(with_two_edits());
  desk.open_stack();
  CHECK(text_of(desk.driver().expect_value("Edits/Stack/1/Particulars", particulars(kSmooth))) == "");
  CHECK(text_of(desk.driver().expect_value("Edits/Stack/2/Particulars", particulars(kOffset))) == "");
}

TEST_CASE(
    "while a take goes on or waits for its verdict nothing of the stack, the history or the gates can be changed") {
  for (const bool reviewing : {false, true}) {
    CAPTURE(reviewing);
    StackDesk desk(with_two_edits());
    desk.open_stack();
    CHECK(desk.driver().item("Edits/Stack/1/Remove").value().enabled);
    desk.state.live.emplace().samples = 10;
    desk.state.take.emplace().reviewing = reviewing;
    CHECK(desk.driver().frames(2));
    desk.commands.clear();
    const std::string reason = desk.driver().item("Toolbar/Undo").value().reason;
    CHECK(reason == "A transfer is being recorded");
    for (const char* each : {"2/Offset", "2/Change", "2/Earlier", "1/Later", "1/Remove"}) {
      CAPTURE(each);
      const Item item = desk.driver().item(std::string("Edits/Stack/") + each).value();
      CHECK(item.reason == reason);
      CHECK_FALSE(item.enabled);
      CHECK(desk.press(item) == "");
    }
    CHECK(desk.driver().item("Edits/Add edit…").value().reason == reason);
    CHECK(text_of(desk.driver().click("Tabs/History")) == "");
    CHECK(desk.driver().frames(2));
    const Item row = desk.driver().item("History/1 · Record Expert 1").value();
    CHECK(row.reason == reason);
    CHECK(desk.press(row) == "");
    for (const workbench::Command& command : desk.commands) {
      CHECK_FALSE(std::holds_alternative<workbench::CommitEdit>(command));
      CHECK_FALSE(std::holds_alternative<workbench::GoToHistory>(command));
    }
  }
}

}  // namespace trocar::ui
