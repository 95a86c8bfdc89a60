#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/core/random.h"
#include "engine/trial/arm_drive.h"
#include "engine/trial/eyes.h"
#include "engine/trial/sampling.h"
#include "engine/trial/skill.h"
#include "engine/trial/transfer_session.h"

using namespace trocar;
using control::ToolCommand;
using kinematics::ArmSide;
using trial::ArmDrive;
using trial::HandSample;

TEST_CASE("a tool driven out of reach holds at the edge and follows back without a jump") {
  const ToolCommand start{kinematics::ready_pose(ArmSide::kLeft), 0.0};
  ArmDrive drive(ArmSide::kLeft, start);
  const auto model = kinematics::psm_model(ArmSide::kLeft);
  HandSample hand;
  Tick now;
  Eigen::Vector3d last = start.X_WT.p;
  double largest_step_m = 0.0;
  // Turns the tool upwards, which no wrist can, and back.
  for (int i = 0; i <= 1200; ++i) {
    const double angle = 1.5 * (1.0 - std::cos(2.0 * 3.14159265358979 * i / 1200.0));
    hand.X_DH.q = Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()));
    hand.X_DH.p.y() = 0.05 * std::sin(2.0 * 3.14159265358979 * i / 1200.0);
    const ToolCommand out = drive.advance(hand, now);
    REQUIRE(kinematics::inverse(model, out.X_WT).has_value());
    largest_step_m = std::max(largest_step_m, (out.X_WT.p - last).norm());
    last = out.X_WT.p;
    now.count += 5;
  }
  CHECK(drive.unreachable() > 0);
  CHECK(largest_step_m < 0.0005);
}

TEST_CASE("commands between two setpoints end at the second one bit for bit") {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const auto setpoint = [&] {
      ToolCommand command;
      command.X_WT.p = {random.normal(), random.normal(), random.normal()};
      command.X_WT.q =
          Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
      command.jaw_rad = random.normal();
      return command;
    };
    const ToolCommand a = setpoint();
    const ToolCommand b = setpoint();
    const ToolCommand end = trial::between(a, b, 5, 5);
    CHECK(end.X_WT == b.X_WT);
    CHECK(end.jaw_rad == b.jaw_rad);
    const ToolCommand early = trial::between(a, b, 1, 5);
    CHECK((early.X_WT.p - a.X_WT.p - 0.2 * (b.X_WT.p - a.X_WT.p)).norm() < 1e-15);
  }
}

TEST_CASE("a sample keeps the setpoints bit for bit") {
  Random random(4);
  trial::SampleContext context;
  for (ToolCommand& setpoint : context.setpoints) {
    setpoint.X_WT.p = {random.normal(), random.normal(), random.normal()};
    setpoint.X_WT.q =
        Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
    setpoint.jaw_rad = random.normal();
  }
  const demonstration::Sample sample = trial::make_sample(simulation::WorldState{}, context);
  for (std::size_t i = 0; i < 2; ++i) {
    const ToolCommand kept = trial::recorded_setpoint(sample.arms[i]);
    CHECK(kept.X_WT == context.setpoints[i].X_WT);
    CHECK(kept.jaw_rad == context.setpoints[i].jaw_rad);
  }
}

TEST_CASE("a sample's flags tell the clutch and who holds the target") {
  simulation::WorldState state;
  trial::SampleContext context;
  context.block = 2;
  context.clutch_pedal = true;
  state.blocks[2].jaw_contact[1] = {true, true};
  state.blocks[3].jaw_contact[0] = {true, true};
  CHECK(trial::make_sample(state, context).flags == (demonstration::kClutchPedal | demonstration::kRightHolds));
}

TEST_CASE("what is seen is exactly as old as the visual delay") {
  trial::Eyes eyes(0, 0.1);
  simulation::WorldState state;
  for (int i = 0; i < 100; ++i) {
    state.arms[0].X_WT.p.x() = i;
    const double seen = eyes.look(state).tool(ArmSide::kLeft).p.x();
    CHECK(seen == std::max(0, i - 20));
  }
  // One metre a sample is 200 m/s.
  CHECK(eyes.tool_speed_m_s(ArmSide::kLeft) == doctest::Approx(200.0));
}

TEST_CASE("a skill has one name, and a word that is none is refused") {
  using trial::Skill;
  for (const Skill skill : {Skill::kExpert, Skill::kTrained, Skill::kNovice}) {
    CHECK(trial::skill_from(trial::to_string(skill)).value() == skill);
  }
  const auto unknown = trial::skill_from("wizard");
  REQUIRE_FALSE(unknown.has_value());
  CHECK(unknown.error().code() == ErrorCode::kInvalidArgument);
}

TEST_CASE("a transfer of a block, to a goal or in a time that does not exist is refused") {
  for (const trial::TransferOptions& options :
       {trial::TransferOptions{.block = 6}, trial::TransferOptions{.block = -1}, trial::TransferOptions{.goal = 6},
        trial::TransferOptions{.time_limit_s = 0.0}, trial::TransferOptions{.time_limit_s = std::nan("")}}) {
    const auto session = trial::TransferSession::create(options);
    REQUIRE_FALSE(session.has_value());
    CHECK(session.error().code() == ErrorCode::kInvalidArgument);
  }
}
