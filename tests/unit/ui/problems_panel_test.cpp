#include <doctest/doctest.h>

#include <algorithm>

#include "engine/demonstration/edit_words.h"
#include "engine/review/fixes.h"
#include "tests/support/ui_desk.h"
#include "tests/support/ui_state.h"

namespace trocar::ui {
namespace {

/// The Author workspace with the problems in front; both tools of the made demonstration are in one place all along.
struct ProblemsDesk : Desk {
  explicit ProblemsDesk(const workbench::WorkbenchState& shown = testing::made_state()) : Desk(shown) {
    CHECK(text_of(driver().click("Menu/Workspaces/Author")) == "");
    CHECK(text_of(driver().click("Tabs/Problems")) == "");
    CHECK(driver().frames(2));
  }
  /// The first problem with a fix.
  const review::Problem& fixable() const {
    const auto& problems = state.review->review.problems;
    const auto found =
        std::find_if(problems.begin(), problems.end(), [](const auto& each) { return !each.fix.empty(); });
    REQUIRE(found != problems.end());
    return *found;
  }
  int commits() const {
    return static_cast<int>(std::count_if(commands.begin(), commands.end(), [](const workbench::Command& command) {
      return std::holds_alternative<workbench::CommitEdit>(command);
    }));
  }
};

workbench::WorkbenchState without_problems() {
  auto state = testing::made_state();
  auto view = std::make_shared<workbench::ReviewView>(*state.review);
  view->review.problems.clear();
  state.review = view;
  return state;
}

}  // namespace

TEST_CASE("a click on a problem goes to its begin, selects its span and spells it out") {
  ProblemsDesk desk;
  const review::Problem problem = desk.fixable();
  CHECK(text_of(desk.driver().click("Problems/List/" + problem.message)) == "");
  REQUIRE(desk.last<workbench::SetPlayhead>() != nullptr);
  CHECK(desk.last<workbench::SetPlayhead>()->t_s == problem.begin_s);
  if (problem.end_s > problem.begin_s) {
    REQUIRE(desk.last<workbench::SetSelection>() != nullptr);
    CHECK(desk.last<workbench::SetSelection>()->span->end_s == problem.end_s);
  }
  CHECK(desk.driver().frames(2));
  CHECK(text_of(desk.driver().expect_present("Problems/List/" + problem.id + "/Fix…", true)) == "");
}

TEST_CASE("while a take goes on no fix can be made, nor one that is shown already applied") {
  ProblemsDesk desk;
  const review::Problem problem = desk.fixable();
  const std::string scope = "Problems/List/" + problem.id;
  CHECK(text_of(desk.driver().click("Problems/List/" + problem.message)) == "");
  CHECK(desk.driver().frames(2));
  desk.state.live.emplace().samples = 10;
  CHECK(desk.driver().frames(2));
  desk.commands.clear();
  CHECK(desk.driver().item(scope + "/Fix…").value().reason == "A transfer is being recorded");
  CHECK(desk.driver().item("Problems/Fix all").value().reason == "A transfer is being recorded");
  CHECK_FALSE(desk.driver().click(scope + "/Fix…"));
  CHECK_FALSE(desk.driver().click("Problems/Fix all"));
  desk.state.live.reset();
  CHECK(desk.driver().frames(2));
  CHECK(text_of(desk.driver().click(scope + "/Fix…")) == "");
  CHECK(desk.driver().frames(2));
  desk.state.live.emplace().samples = 10;
  CHECK(desk.driver().frames(2));
  CHECK(desk.driver().item(scope + "/Apply fix").value().reason == "A transfer is being recorded");
  CHECK_FALSE(desk.driver().click(scope + "/Apply fix"));
  CHECK(desk.commits() == 0);
  CHECK(desk.last<workbench::FixProblems>() == nullptr);
}

TEST_CASE("a fix is previewed first and committed once") {
  ProblemsDesk desk;
  const review::Problem problem = desk.fixable();
  const std::string scope = "Problems/List/" + problem.id;
  CHECK(text_of(desk.driver().click("Problems/List/" + problem.message)) == "");
  CHECK(desk.driver().frames(2));
  CHECK(text_of(desk.driver().click(scope + "/Fix…")) == "");
  REQUIRE(desk.last<workbench::PreviewEdit>() != nullptr);
  const demonstration::Edit fix = review::edit_of_fix(problem).value();
  CHECK(demonstration::to_words(desk.last<workbench::PreviewEdit>()->edit) == demonstration::to_words(fix));
  CHECK(desk.commits() == 0);
  CHECK(desk.driver().frames(2));
  CHECK(text_of(desk.driver().click(scope + "/Apply fix")) == "");
  CHECK(desk.commits() == 1);
  const auto& edit = std::get<workbench::EditDemonstration>(desk.last<workbench::CommitEdit>()->edit);
  CHECK(demonstration::to_words(edit.edit) == demonstration::to_words(fix));
  CHECK(desk.last<workbench::EndPreview>() != nullptr);
}

TEST_CASE("Escape ends the preview of a fix, and nothing is committed") {
  ProblemsDesk desk;
  const review::Problem problem = desk.fixable();
  CHECK(text_of(desk.driver().click("Problems/List/" + problem.message)) == "");
  CHECK(desk.driver().frames(2));
  CHECK(text_of(desk.driver().click("Problems/List/" + problem.id + "/Fix…")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(text_of(desk.driver().key("Escape")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(desk.commits() == 0);
  CHECK(desk.last<workbench::EndPreview>() != nullptr);
  CHECK(text_of(desk.driver().expect_present("Problems/List/" + problem.id + "/Apply fix", false)) == "");
}

TEST_CASE("all fixes and the simulation are asked for by their buttons") {
  ProblemsDesk desk;
  CHECK(text_of(desk.driver().click("Problems/Fix all")) == "");
  REQUIRE(desk.last<workbench::FixProblems>() != nullptr);
  CHECK(desk.last<workbench::FixProblems>()->demonstration == desk.state.demonstration);
  CHECK(text_of(desk.driver().click("Problems/Simulate")) == "");
  REQUIRE(desk.last<workbench::SimulateDemonstration>() != nullptr);
}

TEST_CASE("without problems nothing can be fixed, and that is said; while they are worked out likewise") {
  ProblemsDesk none(without_problems());
  CHECK(text_of(none.driver().expect_enabled("Problems/Fix all", false)) == "");
  auto working = testing::made_state();
  working.review.reset();
  working.review_pending = true;
  ProblemsDesk desk(working);
  CHECK(text_of(desk.driver().expect_enabled("Problems/Fix all", false)) == "");
  CHECK(text_of(desk.driver().expect_enabled("Problems/Simulate", true)) == "");
}

TEST_CASE("while it is simulated it cannot be simulated again; afterwards the outcome is there") {
  auto state = testing::made_state();
  state.simulation = workbench::SimulationView{state.project->demonstrations.at({1}), {}, {}};
  ProblemsDesk running(state);
  CHECK(text_of(running.driver().expect_enabled("Problems/Simulate", false)) == "");
  review::Resimulation found;
  found.outcome = demonstration::Outcome::kDropped;
  found.sentence = "block 0 is dropped: the left arm loses it at 12.34 s at (1, 2, 30) mm";
  state.simulation->result = found;
  ProblemsDesk done(state);
  CHECK(text_of(done.driver().expect_present("Problems/Simulation/Not transferred in the simulator", true)) == "");
  CHECK(text_of(done.driver().expect_enabled("Problems/Simulate", true)) == "");
}

}  // namespace trocar::ui
