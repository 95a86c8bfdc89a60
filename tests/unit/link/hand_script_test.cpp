// Hands without a device: by a script, and as a demonstration went.
#include "engine/link/hand_script.h"

#include <doctest/doctest.h>

#include <numbers>

#include "engine/control/tool_mapping.h"
#include "engine/link/replayed_hand.h"
#include "tests/support/trial_agents.h"

using namespace trocar;
using namespace trocar::link;

TEST_CASE("a script moves, turns, grips and presses as it says") {
  const auto script = parse_hand_script(
      "# a remark\n0.5 agent down\n\n1 move 0.01 0 -0.02 over 0.5  # and another\n1 turn 0 0 30 over 0.5\n"
      "1.2 agent up\r\n1.3 grip -20 over 0.2\n1.6 clutch down\n1.7 clutch up\n1.8 clutch down\n2 away\n2.5 back\n3 "
      "end\n");
  REQUIRE(script);
  CHECK(script->end_s() == 3.0);
  CHECK(script->at(0.0) == HandFrame{});
  CHECK_FALSE(script->at(0.499).agent_pedal);
  CHECK(script->at(0.5).agent_pedal);
  CHECK(script->at(0.5).agent_presses == 1);
  CHECK_FALSE(script->at(1.2).agent_pedal);
  CHECK(script->at(1.25).left.X_DH.p.isApprox(Eigen::Vector3d(0.005, 0.0, -0.01)));
  const HandFrame last = script->at(10.0);
  CHECK(last.left.X_DH.p.isApprox(Eigen::Vector3d(0.01, 0.0, -0.02)));
  CHECK(spatial::angle_between(last.left.X_DH.q, Eigen::Quaterniond::Identity()) ==
        doctest::Approx(std::numbers::pi / 6.0));
  CHECK(last.left.grip_rad == doctest::Approx(-std::numbers::pi / 9.0));
  CHECK(last.clutch_presses == 2);
  CHECK(last.clutch_pedal);
  CHECK_FALSE(script->at(2.2).present);
  CHECK(last.present);
}

TEST_CASE("movements that overlap add up, and each begins and ends at rest") {
  const auto script = parse_hand_script("0 move 0.1 0 0 over 1\n0.5 move -0.1 0.1 0 over 1").value();
  CHECK(script.end_s() == 1.5);
  CHECK(script.at(2.0).left.X_DH.p.isApprox(Eigen::Vector3d(0.0, 0.1, 0.0)));
  CHECK(script.at(0.01).left.X_DH.p.norm() < 2e-6);
  CHECK((script.at(1.49).left.X_DH.p - script.at(1.5).left.X_DH.p).norm() < 2e-6);
}

TEST_CASE("a script that makes no sense is refused by its line") {
  for (const char* wrong : {"hello", "1", "-1 end", "nan end", "1 agent", "1 agent sideways", "1 move 1 0 0 over 1",
                            "1 move 0 0 over 1", "1 move 0 0 0 over 0", "1 move 0 0 0 over 61", "1 move 0 0 0 in 1",
                            "1 grip 20", "1 grip 20 over 1 2", "1 turn 0 0 nan over 1", "4000 end", "1 away now"}) {
    CAPTURE(wrong);
    const auto script = parse_hand_script(std::string("0 agent down\n") + wrong);
    REQUIRE_FALSE(script);
    CHECK(script.error().text().starts_with("line 2: "));
  }
  CHECK_FALSE(parse_hand_script("2 agent down\n1 agent up"));
  CHECK_FALSE(parse_hand_script("2 end\n3 agent up"));
  CHECK(parse_hand_script("")->end_s() == 0.0);
}

TEST_CASE("a replayed hand leads the tool along the demonstration's setpoints") {
  const auto shown = std::make_shared<const demonstration::Demonstration>(testing::scripted_transfer(1));
  for (const double scale : {0.1, 0.2, 0.5}) {
    const auto hand = ReplayedHand::create(shown, scale).value();
    CHECK(hand.end_s() == shown->duration_s());
    std::array mappings{control::ToolMapping(control::display_rotation(), scale),
                        control::ToolMapping(control::display_rotation(), scale)};
    const demonstration::Sample first = shown->samples.front();
    mappings[0].engage(hand.at(0.0).left.X_DH, first.arms[0].setpoint());
    mappings[1].engage(hand.at(0.0).right.X_DH, first.arms[1].setpoint());
    double worst_m = 0.0;
    double worst_rad = 0.0;
    for (std::size_t i = 0; i < shown->samples.size(); i += 3) {
      const demonstration::Sample sample = shown->samples[i];
      const HandFrame frame = hand.at(shown->time_of(sample));
      for (std::size_t arm = 0; arm < 2; ++arm) {
        const OneHand& one = arm == 0 ? frame.left : frame.right;
        const spatial::Pose X_WT = mappings.at(arm).map(one.X_DH);
        worst_m = std::max(worst_m, (X_WT.p - sample.arms.at(arm).setpoint().p).norm());
        worst_rad = std::max(worst_rad, spatial::angle_between(X_WT.q, sample.arms.at(arm).setpoint().q));
        CHECK(one.grip_rad == sample.arms.at(arm).setpoint_jaw_rad);
      }
      CHECK(decode(std::string_view(encode(frame)).substr(4)));
    }
    CHECK(worst_m < 1e-12);
    CHECK(worst_rad < 1e-7);
  }
  CHECK_FALSE(ReplayedHand::create(shown, 0.05));
}
