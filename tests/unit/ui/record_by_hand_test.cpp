// A take by hand as the window shows it: whose the keys and the mouse are, and what is said.
#include <doctest/doctest.h>

#include <string>

#include "tests/support/ui_desk.h"
#include "tests/support/ui_take.h"
#include "ui/widgets/lint.h"

namespace trocar::ui {
namespace {

using trial::HandEvent;
using workbench::HandInput;

using testing::take_state;
using testing::verdict_state;

/// All that the operator did, in order.
std::vector<HandEvent> events_of(const Desk& desk) {
  std::vector<HandEvent> events;
  for (const workbench::Command& command : desk.commands) {
    const auto* input = std::get_if<HandInput>(&command);
    if (input != nullptr) events.insert(events.end(), input->events.begin(), input->events.end());
  }
  return events;
}

template <typename Event>
int count_of(const std::vector<HandEvent>& events) {
  int found = 0;
  for (const HandEvent& event : events) found += std::holds_alternative<Event>(event) ? 1 : 0;
  return found;
}

}  // namespace

TEST_CASE("during a take a key drives its tool while it is held, and means nothing else") {
  Desk desk(take_state());
  CHECK(desk.driver().key("K"));
  CHECK(desk.last<workbench::Play>() == nullptr);
  CHECK(desk.last<workbench::CommitEdit>() == nullptr);
  const std::vector<HandEvent> events = events_of(desk);
  REQUIRE(events.size() == 2);
  const auto& down = std::get<trial::DriveTool>(events[0]);
  CHECK(down.arm == kinematics::ArmSide::kRight);
  CHECK(down.v_WT.z() < 0.0);
  CHECK(std::get<trial::DriveTool>(events[1]).v_WT.norm() == 0.0);
}

TEST_CASE("with Ctrl a key is a command's during a take as well") {
  Desk desk(take_state());
  CHECK(desk.driver().key("Ctrl+Q"));
  CHECK(events_of(desk).empty());
  CHECK(desk.session->items().find("Quit/Stay") != nullptr);
}

TEST_CASE("keys that are held when a form opens count as let go") {
  Desk desk(take_state());
  desk.window.input().push(KeyChanged{key_of('W'), true});
  CHECK(desk.driver().frames(2));
  CHECK(desk.driver().key("Ctrl+P"));
  CHECK(desk.driver().frames(2));
  const std::vector<HandEvent> events = events_of(desk);
  REQUIRE_FALSE(events.empty());
  CHECK(std::get<trial::DriveTool>(events.back()).v_WT.norm() == 0.0);
}

TEST_CASE("R arms, R ends the take, P pauses it and Space ends the countdown") {
  Desk idle(testing::made_state());
  CHECK(idle.driver().key("R"));
  CHECK(idle.last<workbench::RecordByHand>() != nullptr);
  Desk desk(take_state());
  CHECK(desk.driver().key("P"));
  CHECK(desk.driver().key("R"));
  CHECK(count_of<trial::PauseTake>(events_of(desk)) == 1);
  CHECK(count_of<trial::EndTake>(events_of(desk)) == 1);
  Desk counting(take_state(trial::Phase::kCountdown));
  CHECK(counting.driver().key("Space"));
  CHECK(count_of<trial::BeginTake>(events_of(counting)) == 1);
}

TEST_CASE("the verdict is a key or a button") {
  struct Case {
    const char* keys;
    const char* button;
    workbench::TakeVerdict verdict;
  };
  for (const Case& wanted : {Case{"Enter", "View/Take/Keep", workbench::TakeVerdict::kKeep},
                             Case{"Backspace", "View/Take/Discard and re-record", workbench::TakeVerdict::kAgain},
                             Case{"N", "View/Take/Keep and next", workbench::TakeVerdict::kKeepAndNext},
                             Case{"Delete", "View/Take/Discard the take", workbench::TakeVerdict::kDiscard}}) {
    CAPTURE(wanted.keys);
    Desk by_key(verdict_state());
    CHECK(by_key.driver().key(wanted.keys));
    REQUIRE(by_key.last<workbench::JudgeTake>() != nullptr);
    CHECK(by_key.last<workbench::JudgeTake>()->verdict == wanted.verdict);
    Desk by_button(verdict_state());
    CHECK(text_of(by_button.driver().click(wanted.button)) == "");
    REQUIRE(by_button.last<workbench::JudgeTake>() != nullptr);
    CHECK(by_button.last<workbench::JudgeTake>()->verdict == wanted.verdict);
  }
}

TEST_CASE("a tool is dragged in the plane of the camera and pushed away by the wheel") {
  Desk desk(take_state());
  CHECK(text_of(desk.driver().drag("View/Picture", 60.0F, -40.0F)) == "");
  Eigen::Vector3d by{0.0, 0.0, 0.0};
  for (const HandEvent& event : events_of(desk)) by += std::get<trial::ShiftTool>(event).by_W_m;
  CHECK(by.y() > 0.002);
  CHECK(by.z() > 0.001);
  CHECK(desk.last<workbench::SetCamera>() == nullptr);
  desk.commands.clear();
  CHECK(text_of(desk.driver().wheel("View/Picture", 2.0F)) == "");
  by.setZero();
  for (const HandEvent& event : events_of(desk)) by += std::get<trial::ShiftTool>(event).by_W_m;
  CHECK(by.norm() == doctest::Approx(0.002));
  CHECK(by.x() < -0.001);
  desk.commands.clear();
  CHECK(text_of(desk.driver().right_click("View/Picture")) == "");
  CHECK(count_of<trial::ToggleJaw>(events_of(desk)) == 1);
}

TEST_CASE("in step mode a drag is whole cells, one axis at a time") {
  workbench::WorkbenchState state = take_state();
  state.take->request.options.mode = trial::HandMode::kStep;
  Desk desk(state);
  CHECK(text_of(desk.driver().drag("View/Picture", 120.0F, 0.0F)) == "");
  const std::vector<HandEvent> events = events_of(desk);
  CHECK(count_of<trial::StepTool>(events) >= 2);
  for (const HandEvent& event : events) {
    CHECK(std::get<trial::StepTool>(event).cells == Eigen::Vector3d(Eigen::Vector3d::UnitY()));
  }
}

TEST_CASE("a waypoint is dragged along an axis by its handle") {
  workbench::WorkbenchState state = take_state();
  state.take->request.options.mode = trial::HandMode::kWaypoint;
  state.take->request.options.sources[1] = trial::ArmSource::kStill;
  Desk desk(state);
  CHECK(text_of(desk.driver().hover("View/Waypoint/Z")) == "");
  CHECK(text_of(desk.driver().drag("View/Waypoint/Z", 0.0F, -40.0F)) == "");
  const std::vector<HandEvent> events = events_of(desk);
  REQUIRE(count_of<trial::PlaceTool>(events) > 0);
  const auto& placed = std::get<trial::PlaceTool>(events.back());
  const spatial::Pose ready = kinematics::ready_pose(kinematics::ArmSide::kLeft);
  CHECK(placed.X_WT.p.z() > ready.p.z() + 0.001);
  CHECK((placed.X_WT.p - ready.p).head<2>().norm() < 1e-9);
}

TEST_CASE("what goes on is said: the time, the samples, the rate, the drops, and what an arm cannot do") {
  workbench::WorkbenchState state = take_state();
  state.live->status.arms[0].refusal = "insertion is 3.2 mm beyond its limit";
  Desk desk(state);
  CHECK(text_of(desk.driver().expect_contains(
            "View/REC", "REC  00:12.4  |  2,480 samples  |  200.0 Hz  |  0 drops  |  disk 41 GB")) == "");
  CHECK(text_of(desk.driver().expect_contains("View/Left arm", "insertion is 3.2 mm beyond")) == "");
  Desk counting(take_state(trial::Phase::kCountdown));
  CHECK(text_of(counting.driver().expect_value("View/Countdown", "Recording begins in 3")) == "");
  Desk paused(take_state(trial::Phase::kPaused));
  CHECK(text_of(paused.driver().expect_contains("View/REC", "PAUSED")) == "");
}

TEST_CASE("a gamepad drives one arm, changes to the other, and is let go when it is pulled out") {
  workbench::WorkbenchState state = take_state();
  state.take->request.gamepad = true;
  Desk desk(state);
  trial::GamepadLook pad;
  pad.axes[0] = 1.0F;
  desk.window.set_gamepad(pad);
  CHECK(desk.driver().frames(2));
  REQUIRE(events_of(desk).size() == 1);
  CHECK(std::get<trial::DriveTool>(events_of(desk)[0]).v_WT.y() > 0.01);
  pad.buttons = 1U << 3;
  desk.window.set_gamepad(pad);
  CHECK(desk.driver().frames(2));
  CHECK(std::get<trial::DriveTool>(events_of(desk).back()).arm == kinematics::ArmSide::kRight);
  desk.window.set_gamepad(std::nullopt);
  CHECK(desk.driver().frames(2));
  CHECK(std::get<trial::DriveTool>(events_of(desk).back()).v_WT.norm() == 0.0);
}

TEST_CASE("a gamepad that was not chosen drives nothing") {
  Desk desk(take_state());
  trial::GamepadLook pad;
  pad.axes[0] = 1.0F;
  desk.window.set_gamepad(pad);
  CHECK(desk.driver().frames(2));
  CHECK(events_of(desk).empty());
}

TEST_CASE("the form says why a device cannot drive, and offers one that can") {
  workbench::WorkbenchState state = testing::made_state();
  state.space_mouse_missing = "no SpaceMouse: its daemon (spacenavd) does not run";
  Desk desk(state);
  Driver driver = desk.driver();
  CHECK(driver.key("Shift+R"));
  CHECK(driver.frames(3));
  CHECK(desk.last<workbench::FindDevices>() != nullptr);
  CHECK(driver.item("Record/Gamepad")->reason == "No gamepad is connected");
  CHECK(driver.item("Record/SpaceMouse")->reason == state.space_mouse_missing);
  desk.window.set_gamepad(trial::GamepadLook{});
  CHECK(driver.frames(2));
  CHECK(text_of(driver.click("Record/Gamepad")) == "");
  CHECK(text_of(driver.click("Record/Arm")) == "");
  REQUIRE(desk.last<workbench::RecordByHand>() != nullptr);
  CHECK(desk.last<workbench::RecordByHand>()->gamepad);
  CHECK_FALSE(desk.last<workbench::RecordByHand>()->space_mouse);
}

TEST_CASE("the form arms with who drives each arm, the mode and the countdown") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(driver.key("Shift+R"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.click("Record/Right arm/Replay")) == "");
  CHECK(text_of(driver.click("Record/Mode/Step")) == "");
  CHECK(text_of(driver.type("Record/Countdown", "0")) == "");
  CHECK(text_of(driver.click("Record/Arm")) == "");
  const auto* take = desk.last<workbench::RecordByHand>();
  REQUIRE(take != nullptr);
  CHECK(take->options.sources[0] == trial::ArmSource::kHand);
  CHECK(take->options.sources[1] == trial::ArmSource::kReplay);
  CHECK(take->options.mode == trial::HandMode::kStep);
  CHECK(take->options.countdown_s == 0.0);
  CHECK(take->replayed == workbench::DemonstrationId{1});
}

TEST_CASE("the form says why a take that nobody drives cannot be armed") {
  Desk desk(testing::made_state());
  Driver driver = desk.driver();
  CHECK(driver.key("Shift+R"));
  CHECK(driver.frames(3));
  CHECK(text_of(driver.click("Record/Left arm/Rest")) == "");
  CHECK(text_of(driver.expect_enabled("Record/Arm", false)) == "");
}

TEST_CASE("every state of a take is named, whole, apart and large enough at every scale") {
  for (const float scale : {0.75F, 1.0F, 2.0F, 3.0F}) {
    for (const workbench::WorkbenchState& state :
         {take_state(trial::Phase::kLeadIn), take_state(trial::Phase::kCountdown), take_state(), verdict_state()}) {
      Desk desk(state, scale);
      CHECK(desk.driver().frames(3));
      std::string words;
      for (const LintFinding& finding : lint(desk.session->items().items(), scale)) {
        words += finding.path + " " + finding.what + "; ";
      }
      CAPTURE(scale);
      CHECK(words == "");
    }
  }
}

}  // namespace trocar::ui
