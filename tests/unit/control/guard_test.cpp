// The guard, rule by rule: what each one stops, and that nothing else would.
#include "engine/control/guard.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace trocar;
using namespace trocar::control;
using Eigen::Vector3d;

namespace {

constexpr Tick kPeriod{5};

/// A guard in front of an arm that does exactly what it is told, a look each tick and a command each five.
struct Gate {
  GuardSettings settings;
  Guard guard;
  GuardLook look;
  Wish wish;
  bool arm_follows = true;
  ToolCommand sent;

  explicit Gate(std::optional<Rule> left_out = std::nullopt) : settings(with(left_out)), guard(settings, place()) {
    sent = place();
    look.feedback.measured_cp = sent.X_WT;
    look.feedback.operating_state = OperatingState::kEnabled;
    look.feedback.homed = true;
    wish.command = sent;
    guard.confirm_frame(true);
  }

  static GuardSettings with(std::optional<Rule> left_out) {
    GuardSettings settings;
    settings.keep_out.push_back({{0.02, 0.0, 0.0}, 0.003, 0.026});
    if (left_out) settings.left_out.set(static_cast<std::size_t>(*left_out));
    return settings;
  }
  static ToolCommand place() { return {spatial::Pose::translation({0.0, 0.0, 0.03}), 0.0}; }

  void fresh() {
    look.now.count += 1;
    look.feedback.stamp = look.now;
    look.dead_man_stamp = look.now;
    if (arm_follows) look.feedback.measured_cp = sent.X_WT;
  }
  void armed() {
    fresh();
    REQUIRE(guard.arm(look.feedback, look.now));
  }
  /// Armed, dead-man pressed, engaged.
  void moving() {
    armed();
    guard.look(look);
    look.dead_man = true;
    send();
    REQUIRE(guard.state() == GuardState::kMoving);
  }
  /// Five ticks, then a command.
  Admitted send() {
    for (int i = 0; i < kPeriod.count; ++i) {
      fresh();
      guard.look(look);
    }
    wish.stamp = look.now;
    const Admitted admitted = guard.admit(wish);
    sent = admitted.command;
    return admitted;
  }
  /// A small way to the right of where the tool was told to be.
  Admitted shift(double metres = 0.0002) {
    wish.command = guard.setpoint();
    wish.command.X_WT.p.x() += metres;
    return send();
  }
  double x() const { return sent.X_WT.p.x(); }
};

/// What `stopped` finds true with all rules and false without this one.
template <typename Stopped>
void only_by(Rule rule, Stopped stopped) {
  Gate with;
  CHECK(stopped(with));
  Gate without(rule);
  CHECK_FALSE(stopped(without));
}

}  // namespace

TEST_CASE("commands within the limits pass to the bit") {
  Gate gate;
  gate.moving();
  for (int i = 0; i < 100; ++i) {
    const Admitted admitted = gate.shift(2e-5 * std::min(i, 20));
    CHECK_FALSE(admitted.held);
    CHECK(admitted.command.X_WT == gate.wish.command.X_WT);
  }
}

TEST_CASE("rule 1: nothing moves before it is armed and the dead-man was pressed after that") {
  only_by(Rule::kReadiness, [](Gate& gate) {
    gate.look.dead_man = true;  // held all the while
    gate.fresh();
    const bool never_armed = gate.shift(5e-5).held;
    gate.armed();
    return never_armed && gate.shift(5e-5).held && gate.shift(5e-5).held;
  });
  Gate gate;
  gate.fresh();
  gate.look.feedback.homed = false;
  CHECK(gate.guard.arm(gate.look.feedback, gate.look.now).error().text() == "the arm is not homed");
  gate.look.feedback.homed = true;
  gate.guard.confirm_frame(false);
  CHECK_FALSE(gate.guard.arm(gate.look.feedback, gate.look.now));
  gate.guard.confirm_frame(true);
  gate.look.feedback.operating_state = OperatingState::kPaused;
  CHECK_FALSE(gate.guard.arm(gate.look.feedback, gate.look.now));
  gate.look.feedback.operating_state = OperatingState::kEnabled;
  CHECK_FALSE(gate.guard.arm(gate.look.feedback, Tick{gate.look.now.count + 101}));
  CHECK(gate.guard.arm(gate.look.feedback, gate.look.now));
}

TEST_CASE("rule 2: the first command is where the tool was told to be") {
  only_by(Rule::kFirstCommand, [](Gate& gate) {
    gate.armed();
    gate.guard.look(gate.look);
    gate.look.dead_man = true;
    const Admitted first = gate.shift(0.002);
    return first.held && gate.x() == 0.0;
  });
}

TEST_CASE("rule 3: speed, acceleration, turn and jaw saturate, and a jump holds") {
  only_by(Rule::kLimits, [](Gate& gate) {
    gate.moving();
    bool within = true;
    for (int i = 0; i < 20; ++i) {
      const double before = gate.x();
      gate.shift(0.004);
      within = within && gate.x() - before <= 0.25 * 0.005 + 1e-12;
    }
    return within && gate.guard.count(Rule::kLimits) > 0;
  });
  only_by(Rule::kLimits, [](Gate& gate) {
    gate.moving();
    const Admitted jump = gate.shift(0.006);
    return jump.held && gate.x() < 0.001;
  });
  Gate gate;
  gate.moving();
  gate.wish.command.jaw_rad = 1.0;
  CHECK(gate.send().limits.jaw);
  gate.wish.command = gate.guard.setpoint();
  gate.wish.command.X_WT.q = Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Vector3d::UnitX()));
  CHECK(gate.send().limits.angular);
}

TEST_CASE("rule 4: floor and box for everyone; pegs and safe set for the agent") {
  const auto lowest = [](Gate& gate) {
    gate.moving();
    double lowest_m = 1.0;
    for (const double fall_m : {0.0004, 0.0012}) {
      gate.wish.command = Gate::place();
      for (int i = 0; i < 200; ++i) {
        gate.wish.command = gate.guard.setpoint();
        gate.wish.command.X_WT.p.z() -= fall_m;
        gate.send();
        lowest_m = std::min(lowest_m, gate.sent.X_WT.p.z());
      }
      for (int i = 0; i < 200; ++i) {
        gate.wish.command = gate.guard.setpoint();
        gate.wish.command.X_WT.p.z() += 0.0004;
        gate.send();
      }
    }
    return lowest_m >= gate.settings.tip_W.low.z() - 1e-9;
  };
  only_by(Rule::kWorkspace, lowest);
  const auto into_the_peg = [](Gate& gate, bool autonomous) {
    gate.moving();
    gate.wish.autonomous = gate.look.agent_pedal = autonomous;
    for (int i = 0; i < 20; ++i) {
      gate.wish.command = gate.guard.setpoint();
      gate.wish.command.X_WT.p.z() -= 0.0004;
      gate.send();
    }
    for (int i = 0; i < 60; ++i) gate.shift(0.0004);
    return gate.x() > 0.0171;
  };
  only_by(Rule::kWorkspace, [&](Gate& gate) { return !into_the_peg(gate, true); });
  Gate person;
  CHECK(into_the_peg(person, false));
  only_by(Rule::kWorkspace, [](Gate& gate) {
    gate.guard.set_safe_set([](const Vector3d& p) { return p.x() < 0.005; });
    gate.moving();
    gate.wish.autonomous = gate.look.agent_pedal = true;
    for (int i = 0; i < 60; ++i) gate.shift(0.0004);
    return gate.x() < 0.006;
  });
}

TEST_CASE("rule 5: the dead-man is held, and confirmed again and again") {
  only_by(Rule::kDeadMan, [](Gate& gate) {
    gate.moving();
    gate.look.dead_man = false;
    return gate.shift().held;
  });
  only_by(Rule::kDeadMan, [](Gate& gate) {
    gate.moving();
    const Tick last = gate.look.dead_man_stamp;
    for (int i = 0; i < 110; ++i) {
      gate.fresh();
      gate.look.dead_man_stamp = last;
      gate.guard.look(gate.look);
      gate.wish.stamp = gate.look.now;
      gate.wish.command = gate.guard.setpoint();
      gate.wish.command.X_WT.p.x() += 1e-5;
      if (i % 5 == 0) gate.sent = gate.guard.admit(gate.wish).command;
    }
    return gate.guard.state() == GuardState::kHeld;
  });
}

TEST_CASE("rule 5: nothing of the agent's passes while its pedal is up, whoever says that it has the arm") {
  only_by(Rule::kDeadMan, [](Gate& gate) {
    gate.moving();
    gate.wish.autonomous = true;
    const bool up = gate.shift().held;
    return up && gate.guard.state() == GuardState::kHeld;
  });
  Gate down;
  down.moving();
  down.wish.autonomous = down.look.agent_pedal = true;
  CHECK_FALSE(down.shift().held);
}

TEST_CASE("rule 6: stamps of the future and feedback that runs backwards are not fresh") {
  only_by(Rule::kAge, [](Gate& gate) {
    gate.moving();
    gate.look.feedback.stamp.count += 1000;
    gate.guard.look(gate.look);
    return gate.guard.state() == GuardState::kHeld;
  });
  only_by(Rule::kAge, [](Gate& gate) {
    gate.moving();
    gate.look.feedback.stamp.count -= 3;
    gate.guard.look(gate.look);
    return gate.guard.state() == GuardState::kHeld;
  });
  only_by(Rule::kDeadMan, [](Gate& gate) {
    gate.moving();
    gate.look.dead_man_stamp.count += 3'600'000;
    gate.guard.look(gate.look);
    return gate.guard.state() == GuardState::kHeld;
  });
}

TEST_CASE("rule 6: old feedback, old commands and stamps that do not grow hold it") {
  only_by(Rule::kAge, [](Gate& gate) {
    gate.moving();
    gate.look.now.count += 101;  // nobody said anything
    gate.look.dead_man_stamp = gate.look.now;
    gate.guard.look(gate.look);
    return gate.guard.state() == GuardState::kHeld;
  });
  only_by(Rule::kAge, [](Gate& gate) {
    gate.moving();
    for (int i = 0; i < 101; ++i) {
      gate.fresh();
      gate.guard.look(gate.look);
    }
    return gate.guard.state() == GuardState::kHeld;
  });
  only_by(Rule::kAge, [](Gate& gate) {
    gate.moving();
    gate.wish.command.X_WT.p.x() += 0.0002;
    gate.fresh();
    gate.guard.look(gate.look);
    const bool again = gate.guard.admit(gate.wish).held;
    gate.wish.stamp = Tick{0};
    return again && gate.guard.admit(gate.wish).held;
  });
}

TEST_CASE("rule 7: who commands has gone: it holds, and does not jump when they come back") {
  only_by(Rule::kDisconnect, [](Gate& gate) {
    gate.moving();
    gate.look.connected = false;
    return gate.shift().held;
  });
  Gate gate;
  gate.moving();
  gate.look.connected = false;
  gate.shift();
  gate.look.connected = true;
  const double before = gate.x();
  CHECK(gate.shift(0.003).held);  // not where it was told to be
  CHECK(gate.x() == before);
  CHECK_FALSE(gate.shift(0.0).held);
  CHECK_FALSE(gate.shift().held);
}

TEST_CASE("rule 8: an arm that does not follow is held") {
  only_by(Rule::kFollowing, [](Gate& gate) {
    gate.moving();
    gate.arm_follows = false;
    gate.look.feedback.measured_cp.p.y() += 0.0031;
    for (int i = 0; i < 45; ++i) gate.shift(0.0);
    return gate.guard.state() == GuardState::kHeld;
  });
}

TEST_CASE("rule 9: after a fault, a disable or a pause it stays disarmed") {
  for (const OperatingState state : {OperatingState::kFault, OperatingState::kDisabled, OperatingState::kPaused}) {
    only_by(Rule::kNoRearming, [state](Gate& gate) {
      gate.moving();
      gate.look.feedback.operating_state = state;
      gate.shift();
      gate.look.feedback.operating_state = OperatingState::kEnabled;
      gate.shift(0.0);
      return gate.shift().held && gate.guard.state() == GuardState::kDisarmed;
    });
  }
}

TEST_CASE("rule 10: the soft stop disarms, whatever goes on") {
  only_by(Rule::kSoftStop, [](Gate& gate) {
    gate.moving();
    gate.look.soft_stop = true;
    gate.shift();
    gate.look.soft_stop = false;
    return gate.shift().held && gate.guard.state() == GuardState::kDisarmed;
  });
}

TEST_CASE("rule 11: what is no pose is dropped and counted") {
  const auto dropped = [](Gate& gate, const ToolCommand& bad) {
    gate.moving();
    gate.wish.command = bad;
    const Admitted admitted = gate.send();
    return admitted.held && admitted.why == Rule::kMalformed && gate.guard.count(Rule::kMalformed) == 1;
  };
  ToolCommand nan = Gate::place();
  nan.X_WT.p.z() = std::numeric_limits<double>::quiet_NaN();
  ToolCommand stretched = Gate::place();
  stretched.X_WT.q.w() = 1.1;
  ToolCommand jaw = Gate::place();
  jaw.jaw_rad = std::numeric_limits<double>::infinity();
  for (const ToolCommand& bad : {nan, stretched, jaw}) {
    only_by(Rule::kMalformed, [&](Gate& gate) { return dropped(gate, bad); });
  }
}

TEST_CASE("rule 12: every change of state and every limit is in the record") {
  only_by(Rule::kRecord, [](Gate& gate) {
    gate.moving();
    gate.shift(0.004);
    gate.shift(0.006);
    bool armed = false;
    bool moving = false;
    bool limit = false;
    bool held = false;
    for (const GuardEvent& event : gate.guard.take_events()) {
      armed = armed || event.text.starts_with("armed");
      moving = moving || event.text == "moving";
      limit = limit || event.text.starts_with("at its limit");
      held = held || event.text.starts_with("held: a jump");
    }
    return armed && moving && limit && held;
  });
}
