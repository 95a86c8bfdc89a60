// The trials' workspace: what is asked for, the runner's screen, stop in every state, the list and the results.
#include <doctest/doctest.h>

#include "tests/support/ui_desk.h"
#include "ui/command_text.h"
#include "ui/panels/authority_band.h"

namespace trocar::ui {
namespace {

using control::ControlState;
using demonstration::Segment;
using workbench::TrialsPhase;

workbench::TrialsView one_block(trial::Mode mode) {
  workbench::TrialsView view;
  trial::ProtocolBlock block;
  block.name = "Shared 1";
  block.instructions = "Hold the left pedal.";
  block.mode = mode;
  block.transfers = 6;
  view.blocks = {block};
  view.phase = TrialsPhase::kRunning;
  return view;
}

/// A transfer that goes on, in the state that is asked for.
workbench::WorkbenchState running(ControlState control, Segment segment = Segment::kA) {
  workbench::WorkbenchState state = testing::made_state_with_model();
  state.trials = one_block(trial::Mode::kShared);
  workbench::LiveView live;
  live.segment = segment;
  trial::TrialStatus status;
  status.state = control;
  status.agent_pedal = control == ControlState::kAgent;
  status.agent_presses = 2;
  status.tool_speed_m_s = 0.05;
  live.trial = status;
  state.live = live;
  return state;
}

struct TrialsDesk : Desk {
  explicit TrialsDesk(workbench::WorkbenchState of, float scale = 1.0F) : Desk(std::move(of), scale) {
    CHECK(driver().key("Ctrl+5"));
    CHECK(driver().frames(3));
    CHECK(text_of(driver().click("Tabs/Trials")) == "");
    CHECK(driver().frames(2));
  }
  std::string value(const std::string& path) {
    const Result<Item> item = driver().item(path);
    return item ? item->value : "";
  }
};

}  // namespace

TEST_CASE("what is set is what is asked for, and is a command line") {
  TrialsDesk desk(testing::made_state_with_model());
  CHECK(text_of(desk.driver().type("Trials/Setup/Transfers", "3")) == "");
  CHECK(text_of(desk.driver().type("Trials/Setup/Seed", "7")) == "");
  CHECK(text_of(desk.driver().type("Trials/Setup/Delay", "ar1:20:5")) == "");
  CHECK(desk.driver().frames(2));
  // The only model was learned at block 0.
  CHECK(desk.driver().item("Trials/Setup/Start")->reason.find("no model serves block 1") != std::string::npos);
  CHECK(text_of(desk.driver().click("Trials/Setup/Blocks in turn")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(text_of(desk.driver().click("Trials/Setup/Start")) == "");
  const auto* start = desk.last<workbench::StartTrials>();
  REQUIRE(start != nullptr);
  CHECK(start->plan.options.mode == trial::Mode::kShared);
  CHECK(start->plan.transfers == 3);
  CHECK(start->plan.seed == 7);
  CHECK_FALSE(start->person);
  const std::string words = command_text(*start, desk.state);
  CHECK(words.find("trocar trial run /data/pegs.trocar --mode SC --transfers 3 --delay-ms ar1:20:5") == 0);
  CHECK(words.find("--seed 7") != std::string::npos);
}

TEST_CASE("what cannot be run is said where it would be started") {
  workbench::WorkbenchState state = testing::made_state();
  auto project = std::make_shared<workbench::Project>(*state.project);
  project->models.clear();
  state.project = project;
  TrialsDesk desk(state);
  const auto start = desk.driver().item("Trials/Setup/Start");
  REQUIRE(start);
  CHECK_FALSE(start->enabled);
  CHECK(start->reason.find("needs a model") != std::string::npos);
  CHECK(text_of(desk.driver().click("Trials/Setup/Mode/MT  manual")) == "");
  CHECK(text_of(desk.driver().type("Trials/Setup/Delay", "soon")) == "");
  CHECK(desk.driver().frames(2));
  CHECK(desk.driver().item("Trials/Setup/Start")->reason.find("a delay is") != std::string::npos);
}

TEST_CASE("the band says who has the arm, in which segment and who is next, in every state") {
  for (const float scale : {0.75F, 1.0F, 2.0F}) {
    for (int i = 0; i < control::kControlStates; ++i) {
      const auto state = static_cast<ControlState>(i);
      TrialsDesk desk(running(state), scale);
      const std::string band = desk.value("Trials/Runner/Authority");
      CHECK(band.starts_with(band_word(state, Segment::kA)));
      CHECK(band.find("in A, next: OPERATOR in B") != std::string::npos);
      CHECK(desk.value("Trials/Runner/States/" + std::string(control::to_string(state))) == "lit");
    }
  }
  TrialsDesk last(running(ControlState::kOperator, Segment::kE));
  CHECK(last.value("Trials/Runner/Authority").starts_with("ASSISTANT in E"));
  TrialsDesk agent(running(ControlState::kAgent, Segment::kC));
  CHECK(agent.value("Trials/Runner/Authority").starts_with("AGENT in C"));
  CHECK(agent.value("Trials/Runner/AGENT: hold to run") == "down");
}

TEST_CASE("Esc stops in every state of a trial, whatever has the keyboard") {
  for (int i = 0; i < control::kControlStates; ++i) {
    TrialsDesk desk(running(static_cast<ControlState>(i)));
    desk.commands.clear();
    CHECK(desk.driver().key("Escape"));
    CHECK(desk.driver().frames(2));
    CHECK(desk.last<workbench::StopTrial>() != nullptr);
  }
}

TEST_CASE("Space is the left pedal of a person, let go when the key is") {
  workbench::WorkbenchState state = running(ControlState::kOperator);
  state.trials->request.person = true;
  TrialsDesk desk(state);
  desk.commands.clear();
  CHECK(text_of(desk.driver().held("Space", true)) == "");
  CHECK(desk.driver().frames(2));
  const auto pedal = [&desk] {
    const auto* input = desk.last<workbench::HandInput>();
    const auto* held = input == nullptr ? nullptr : std::get_if<trial::HoldAgentPedal>(&input->events.back());
    return held == nullptr ? std::optional<bool>() : std::optional<bool>(held->down);
  };
  CHECK(pedal() == true);
  CHECK(text_of(desk.driver().held("Space", false)) == "");
  CHECK(desk.driver().frames(2));
  CHECK(pedal() == false);
}

TEST_CASE("a person drags the tool of a trial in the view, and not that of a console's trial") {
  for (const bool by_console : {false, true}) {
    CAPTURE(by_console);
    workbench::WorkbenchState state = running(ControlState::kOperator);
    state.trials->request.person = !by_console;
    state.trials->request.person_assists = by_console;
    if (by_console) state.trials->request.console_port = std::uint16_t{5005};
    TrialsDesk desk(state);
    desk.commands.clear();
    CHECK(text_of(desk.driver().drag("View/Picture", 60.0F, -40.0F)) == "");
    const auto* input = desk.last<workbench::HandInput>();
    REQUIRE((input == nullptr) == by_console);
    if (by_console) continue;
    const auto& shift = std::get<trial::ShiftTool>(input->events.back());
    CHECK(shift.arm == kinematics::ArmSide::kLeft);
    CHECK(shift.by_W_m.norm() > 0.0);
    CHECK(desk.last<workbench::SetCamera>() == nullptr);
  }
}

TEST_CASE("the start of a rollout is where the next trials begin, until it is forgotten") {
  workbench::WorkbenchState state = testing::made_state_with_model();
  state.trial_start = workbench::FromCell{{8, 9, 16}};
  TrialsDesk desk(state);
  CHECK(desk.value("Trials/Setup/Tool begins in") == "cell 8, 9, 16");
  CHECK(text_of(desk.driver().click("Trials/Setup/Start")) == "");
  const auto* start = desk.last<workbench::StartTrials>();
  REQUIRE(start != nullptr);
  REQUIRE(start->from);
  CHECK(command_text(*start, desk.state).find("--from-cell 8,9,16") != std::string::npos);
  CHECK(text_of(desk.driver().click("Trials/Setup/Begin where it is ready")) == "");
  REQUIRE(desk.last<workbench::SetTrialStart>() != nullptr);
  CHECK_FALSE(desk.last<workbench::SetTrialStart>()->from);
}

TEST_CASE("what a console or a person drives is not passed off as a script's command line") {
  const workbench::WorkbenchState state = testing::made_state_with_model();
  workbench::StartTrials trials;
  trials.console_port = std::uint16_t{5005};
  trials.person_assists = true;
  const std::string words = command_text(trials, state);
  CHECK(words.find("--operator tcp --listen 5005 --assist") != std::string::npos);
  CHECK(words.find("--skill") == std::string::npos);
  trials.protocol = "sim";
  CHECK(command_text(trials, state).empty());
  workbench::StartTrials assisted;
  assisted.person_assists = true;
  CHECK(command_text(assisted, state).empty());
}

TEST_CASE("a block says what is left of it, also while a transfer goes on, and a rest how long it still is") {
  workbench::WorkbenchState state = running(ControlState::kOperator);
  state.trials->blocks.front().time_s = 300.0;
  state.trials->block_s = 40.0;
  state.live->world.tick = Tick{20'000};
  state.live->lateness.add(2'500'000);
  state.live->lateness.add(10'000);
  TrialsDesk desk(state);
  CHECK(desk.value("Trials/Runner/Block").find("4:00.0 left") != std::string::npos);
  CHECK(desk.value("Trials/Runner/Ticks late by 1 ms or more") == "1 of 2, worst 2.5 ms");
  workbench::WorkbenchState resting = testing::made_state_with_model();
  resting.trials = one_block(trial::Mode::kShared);
  resting.trials->phase = TrialsPhase::kResting;
  resting.trials->rest_s = 60.0;
  resting.trials->rest_left_s = 41.3;
  CHECK(TrialsDesk(resting).value("Trials/Runner/Rest") == "42 s left of 60");
}

}  // namespace trocar::ui
