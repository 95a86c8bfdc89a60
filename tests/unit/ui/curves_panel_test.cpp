// Curves and differences over time: read, seek, zoom with mouse and keyboard, choose what is shown and compared.
#include <doctest/doctest.h>

#include <string>

#include "tests/support/ui_desk.h"

namespace trocar::ui {
namespace {

workbench::WorkbenchState worked_out() {
  workbench::WorkbenchState state = testing::made_state();
  testing::work_out(state);
  return state;
}

/// The window with one panel of the Author workspace in front.
struct PlotDesk : Desk {
  explicit PlotDesk(const std::string& tab, workbench::WorkbenchState of = worked_out()) : Desk(std::move(of)) {
    CHECK(text_of(driver().click("Tabs/" + tab)) == "");
    CHECK(driver().frames(2));
  }
  std::string value(const std::string& path) {
    const Result<Item> item = driver().item(path);
    return item ? item->value : item.error().text();
  }
  void tab_to(const std::string& path) {
    for (int i = 0; i < 200 && session->ui().focus().path() != path; ++i) {
      CHECK(driver().key("Tab"));
      CHECK(driver().frames(2));
    }
    REQUIRE(session->ui().focus().path() == path);
  }
};

}  // namespace

TEST_CASE("a plot tells the values of both arms at the playhead, and under the pointer") {
  PlotDesk desk("Curves");
  const Result<Item> item = desk.driver().item("Curves/Speed");
  REQUIRE(item);
  CHECK(item->role == "plot");
  // A centimetre a second after the first second; the playhead is at 2 s.
  CHECK(item->value == "at 2.00 s, Left 10 mm/s, Right 10 mm/s, Left before 10 mm/s, Right before 10 mm/s");
  CHECK(text_of(desk.driver().hover("Curves/Speed")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(desk.value("Curves/Speed").find("at 2.00 s") == std::string::npos);
  CHECK(desk.value("Curves/Jerk").substr(0, 9) == desk.value("Curves/Speed").substr(0, 9));
}

TEST_CASE("a click on a plot moves the playhead to the time below it") {
  PlotDesk desk("Curves");
  CHECK(text_of(desk.driver().click("Curves/Speed")) == "");
  const auto* seek = desk.last<workbench::SetPlayhead>();
  REQUIRE(seek != nullptr);
  // The names on the left take more than what is free on the right.
  CHECK(seek->t_s > 2.5);
  CHECK(seek->t_s < 3.5);
}

TEST_CASE("the keyboard reaches a plot, its arrows zoom, and Enter on it presses nothing") {
  PlotDesk desk("Curves");
  desk.tab_to("Curves/Speed");
  CHECK(desk.driver().key("Up"));
  CHECK(desk.driver().frames(2));
  CHECK(desk.driver().key("Enter"));
  CHECK(desk.driver().frames(3));
  CHECK(desk.last<workbench::SetPlayhead>() == nullptr);
  // Seen through the timeline, which shows the same time: the out gate is right of what is shown.
  CHECK(desk.driver().key("Up"));
  CHECK(desk.driver().key("Up"));
  CHECK(desk.driver().frames(2));
  CHECK(text_of(desk.driver().click("Tabs/Timeline")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(text_of(desk.driver().expect_present("Timeline/Lanes", true)) == "");
  CHECK(text_of(desk.driver().expect_present("Timeline/Out gate", false)) == "");
}

TEST_CASE("choosing a curve asks the workbench for it") {
  PlotDesk desk("Curves");
  CHECK(text_of(desk.driver().click("Curves/Show/z")) == "");
  CHECK(desk.driver().frames(2));
  const auto* asked = desk.last<workbench::ShowCurves>();
  REQUIRE(asked != nullptr);
  CHECK((asked->kinds & workbench::bit(workbench::CurveKind::kZ)) != 0);
  CHECK(text_of(desk.driver().expect_present("Curves/z", true)) == "");
  for (const char* kind : {"z", "Speed", "Jerk"}) {
    CHECK(text_of(desk.driver().click(std::string("Curves/Show/") + kind)) == "");
  }
  CHECK(desk.driver().frames(2));
  CHECK(desk.last<workbench::ShowCurves>()->kinds == 0);
}

TEST_CASE("until the curves are there, the panel says that they are worked out") {
  PlotDesk desk("Curves", testing::made_state());
  CHECK(desk.last<workbench::ShowCurves>() != nullptr);
  CHECK(text_of(desk.driver().expect_present("Curves/Speed", false)) == "");
}

TEST_CASE("what a demonstration is compared with is chosen from original, others and its past") {
  PlotDesk desk("Diff");
  CHECK(desk.value("Diff/Against") == "Novice 2 · 2");
  CHECK(text_of(desk.driver().click("Diff/Against")) == "");
  CHECK(text_of(desk.driver().click("Diff/Against/Original, as it was recorded")) == "");
  CHECK(desk.driver().frames(2));
  const auto* asked = desk.last<workbench::CompareWith>();
  REQUIRE(asked != nullptr);
  CHECK(asked->settings.against == workbench::Against{});
  CHECK(text_of(desk.driver().click("Diff/Against")) == "");
  CHECK(text_of(desk.driver().click("Diff/Against/Point 1: Record Expert 1")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(desk.last<workbench::CompareWith>()->settings.against.node == 1);
}

TEST_CASE("a comparison is copied as the command that prints it") {
  PlotDesk desk("Diff");
  CHECK(text_of(desk.driver().click("Diff/Copy as command")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(desk.window.clipboard() == "trocar demo diff /data/pegs.trocar 1 --against 2 --align time");
}

TEST_CASE("why nothing can be compared is told in place of numbers") {
  workbench::WorkbenchState state = worked_out();
  state.comparison = workbench::comparison_of(
      {nullptr, state.project->demonstrations.at({1}), *state.comparing, "there is no demonstration 9"});
  PlotDesk desk("Diff", state);
  CHECK(text_of(desk.driver().expect_present("Diff/Deviation", false)) == "");
  CHECK(text_of(desk.driver().expect_present("Diff/Against", true)) == "");
}

}  // namespace trocar::ui
