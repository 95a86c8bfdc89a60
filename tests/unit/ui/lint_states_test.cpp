// The lint on what opens only now and then: every form of an edit, a take from countdown to verdict, the record form in
// each of its choices, every lane and every unit of the ruler, an act on several demonstrations.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "engine/demonstration/edit_fields.h"
#include "engine/demonstration/edit_words.h"
#include "tests/support/ui_desk.h"
#include "tests/support/ui_take.h"
#include "ui/widgets/lint.h"

namespace trocar::ui {
namespace {

constexpr std::array<float, 5> kLintedScales{0.75F, 1.0F, 1.5F, 2.0F, 3.0F};

std::string findings_on(const Desk& desk, float scale) {
  std::string words;
  for (const LintFinding& finding : lint(desk.session->items().items(), scale)) {
    words += finding.path + " " + finding.what + "; ";
  }
  return words;
}

ThemeKind any_theme(float scale) {
  return kThemeKinds[static_cast<std::size_t>(scale) % kThemeKinds.size()];
}

/// With a span selected, on which an edit or a take can begin.
struct SpanDesk : Desk {
  explicit SpanDesk(float scale) : Desk(testing::made_state(), scale, any_theme(scale)) {
    state.selection = workbench::TimeSpan{2.0, 3.0};
  }
};

std::vector<std::string> titles_of_edits() {
  std::vector<std::string> titles;
  demonstration::for_each_edit([&](const auto* edit) {
    titles.emplace_back(demonstration::title_of(std::remove_pointer_t<decltype(edit)>::kName));
  });
  return titles;
}

}  // namespace

TEST_CASE("the form of every edit is whole, named and large enough at every scale") {
  for (const float scale : kLintedScales) {
    CAPTURE(scale);
    SpanDesk desk(scale);
    Driver driver = desk.driver();
    CHECK(driver.key("Ctrl+2"));
    CHECK(driver.frames(3));
    CHECK(text_of(driver.click("Tabs/Edits")) == "");
    int forms = 0;
    for (const std::string& title : titles_of_edits()) {
      CAPTURE(title);
      CHECK(text_of(driver.click("Edits/Kind of edit")) == "");
      CHECK(driver.frames(2));
      CHECK(text_of(driver.click("Edits/Kind of edit/" + title)) == "");
      CHECK(text_of(driver.click("Edits/Add edit…")) == "");
      CHECK(driver.frames(3));
      CHECK(findings_on(desk, scale) == "");
      forms += desk.session->items().find("Edits/Draft/Apply") != nullptr ? 1 : 0;
      CHECK(driver.key("Escape"));
      CHECK(driver.frames(3));
    }
    CHECK(forms > 15);
  }
}

TEST_CASE("so is the window from the countdown to the verdict") {
  for (const float scale : kLintedScales) {
    CAPTURE(scale);
    for (const auto& state : {testing::take_state(trial::Phase::kCountdown), testing::take_state(),
                              testing::take_state(trial::Phase::kPaused), testing::verdict_state()}) {
      Desk desk(state, scale, any_theme(scale));
      CHECK(desk.driver().key("Ctrl+2"));
      CHECK(desk.driver().frames(4));
      for (const char* panel : {"View", "Timeline", "Curves", "Inspector"}) {
        CAPTURE(panel);
        if (desk.session->items().find(std::string("Tabs/") + panel) == nullptr) continue;
        CHECK(text_of(desk.driver().click(std::string("Tabs/") + panel)) == "");
        CHECK(desk.driver().frames(3));
        CHECK(findings_on(desk, scale) == "");
      }
    }
  }
}

TEST_CASE("so is the record form in each of its choices, and its button stays in sight") {
  for (const float scale : kLintedScales) {
    CAPTURE(scale);
    SpanDesk desk(scale);
    Driver driver = desk.driver();
    CHECK(driver.key("Shift+R"));
    CHECK(driver.frames(6));
    for (const char* choice : {"Record/Right arm/Replay", "Record/Left arm/Rest", "Record/Mode/Waypoint"}) {
      CHECK(text_of(driver.click(choice)) == "");
      CHECK(driver.frames(4));
      CHECK(findings_on(desk, scale) == "");
      const Item arm = driver.item("Record/Arm").value();
      CHECK(arm.reachable());
      CHECK(arm.rect.y1 <= 900.0F);
    }
    CHECK(text_of(driver.click("Record/Who/Scripted")) == "");
    CHECK(driver.frames(4));
    CHECK(findings_on(desk, scale) == "");
    CHECK(driver.item("Record/Start recording").value().reachable());
  }
}

TEST_CASE("so is a timeline with every lane and every ruler, in a low tile too") {
  for (const float scale : kLintedScales) {
    CAPTURE(scale);
    Desk desk(testing::made_state_with_model(), scale, any_theme(scale));
    Driver driver = desk.driver();
    CHECK(driver.key("Ctrl+2"));
    CHECK(driver.frames(3));
    CHECK(text_of(driver.click("Tabs/Timeline")) == "");
    for (int i = 0; i < kRulerUnitCount; ++i) {
      CHECK(driver.key("Shift+N"));
      CHECK(driver.frames(3));
      CHECK(findings_on(desk, scale) == "");
    }
    CHECK(text_of(driver.click("Timeline/Lanes shown…")) == "");
    CHECK(driver.frames(3));
    CHECK(findings_on(desk, scale) == "");
    for (const char* lane : {"x", "y", "z", "Speed", "Acceleration", "Jerk", "Clearance"}) {
      CHECK(text_of(driver.click(std::string("Lanes shown/") + lane)) == "");
    }
    CHECK(driver.key("Escape"));
    CHECK(driver.frames(3));
    CHECK(findings_on(desk, scale) == "");
  }
}

TEST_CASE("lanes that do not fit are scrolled to by the bar beside them and by the wheel over their names") {
  Desk desk(testing::made_state_with_model());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+2"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.click("Timeline/Lanes shown…")) == "");
  for (const char* lane : {"x", "y", "z", "Speed", "Acceleration", "Jerk", "Clearance"}) {
    CHECK(text_of(driver.click(std::string("Lanes shown/") + lane)) == "");
  }
  CHECK(driver.key("Escape"));
  CHECK(driver.frames(3));
  CHECK(desk.session->items().find("Timeline/Clearance") == nullptr);
  CHECK(text_of(driver.drag("Timeline/Scroll lanes", 0.0F, 400.0F)) == "");
  CHECK(driver.frames(2));
  CHECK(desk.session->items().find("Timeline/Clearance") != nullptr);
  CHECK(desk.session->items().find("Timeline/Pictures") == nullptr);
  // Nothing was selected or moved by that.
  CHECK(desk.last<workbench::SetSelection>() == nullptr);
  const Rect lanes = driver.item("Timeline/Lanes").value().rect;
  desk.window.input().push(MouseMoved{lanes.x0 + 10.0F, lanes.centre_y()});
  CHECK(driver.frames(2));
  desk.window.input().push(MouseWheel{0.0F, 40.0F});
  CHECK(driver.frames(3));
  CHECK(desk.session->items().find("Timeline/Pictures") != nullptr);
}

TEST_CASE("the lanes ask for the curves that they show, together with those of the Curves panel") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+2"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.click("Timeline/Lanes shown…")) == "");
  CHECK(text_of(driver.click("Lanes shown/Clearance")) == "");
  CHECK(driver.key("Escape"));
  CHECK(driver.frames(2));
  REQUIRE(desk.last<workbench::ShowCurves>() != nullptr);
  CHECK((desk.last<workbench::ShowCurves>()->kinds & workbench::bit(workbench::CurveKind::kClearance)) != 0);
  REQUIRE(desk.last<workbench::ShowFilmstrip>() != nullptr);
  CHECK(desk.last<workbench::ShowFilmstrip>()->count > 2);
}

TEST_CASE("while a take is recorded the timeline has its lanes") {
  Desk desk(testing::take_state());
  Driver driver = desk.driver();
  CHECK(driver.key("Ctrl+2"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.expect_value("Timeline/Live lanes", "5.0 s")) == "");
}

}  // namespace trocar::ui
