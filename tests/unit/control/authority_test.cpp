// Who moves the arm: the rules one by one, and a million random events that must not break any.
#include "engine/control/authority.h"

#include <doctest/doctest.h>

#include "engine/core/random.h"

using namespace trocar;
using control::AuthorityMachine;
using control::ControlLook;
using control::ControlState;

namespace {

/// A machine whose trial has begun, one look each tick.
struct Machine {
  AuthorityMachine machine;
  ControlLook now;

  Machine() {
    now.agent_may = true;
    step();
    now.begin = true;
    step();
    now.begin = false;
  }
  ControlState step(int ticks = 1) {
    for (int i = 0; i < ticks; ++i) {
      ++now.now.count;
      machine.look(now);
    }
    return machine.state();
  }
};

}  // namespace

TEST_CASE("from disconnected to ready, one condition after the other") {
  AuthorityMachine machine;
  ControlLook look;
  look.connected = look.homed = look.checked = look.armed = look.scene_ready = false;
  const auto step = [&] {
    ++look.now.count;
    return machine.look(look);
  };
  CHECK(step() == ControlState::kDisconnected);
  look.connected = true;
  CHECK(step() == ControlState::kConnected);
  look.homed = true;
  CHECK(step() == ControlState::kHomed);
  look.checked = true;
  CHECK(step() == ControlState::kChecked);
  look.armed = true;
  CHECK(step() == ControlState::kArmed);
  look.scene_ready = true;
  CHECK(step() == ControlState::kReady);
  look.begin = true;
  CHECK(step() == ControlState::kOperator);
}

TEST_CASE(
    "the agent has the arm while the left pedal is held, and the operator has it back in the tick of the release") {
  Machine m;
  CHECK(m.machine.state() == ControlState::kOperator);
  m.now.agent_pedal = true;
  CHECK(m.step(150) == ControlState::kOperator);  // so far it could be a tap
  CHECK(m.step() == ControlState::kAgent);
  CHECK(m.step(5000) == ControlState::kAgent);
  m.now.agent_pedal = false;
  CHECK(m.step() == ControlState::kOperator);
  CHECK(m.machine.changed());
  CHECK(m.machine.hand_overs() == 2);
}

TEST_CASE("a tap moves nothing") {
  Machine m;
  m.now.agent_pedal = true;
  CHECK(m.step(149) == ControlState::kOperator);
  m.now.agent_pedal = false;
  CHECK(m.step() == ControlState::kOperator);
  CHECK(m.machine.agent_pedal().tapped);
  CHECK(m.machine.hand_overs() == 0);
}

TEST_CASE("a pedal that was down from the beginning is no dead-man") {
  AuthorityMachine machine;
  ControlLook look;
  look.agent_pedal = look.agent_may = look.begin = true;
  for (int i = 0; i < 1000; ++i) {
    ++look.now.count;
    CHECK(machine.look(look) != ControlState::kAgent);
  }
  CHECK(machine.agent_pedal_stuck());
}

TEST_CASE("both pedals: the tool holds") {
  Machine m;
  m.now.agent_pedal = true;
  m.step(200);
  m.now.clutch_pedal = true;
  CHECK(m.step() == ControlState::kClutch);
  m.now.agent_pedal = false;
  m.step();
  m.now.clutch_pedal = false;
  CHECK(m.step() == ControlState::kOperator);
}

TEST_CASE("after a hold, and after its segment, the agent needs another press") {
  Machine m;
  m.now.agent_pedal = true;
  m.step(200);
  SUBCASE("stale data") {
    m.now.fresh = false;
    CHECK(m.step() == ControlState::kHold);
    m.now.fresh = true;
  }
  SUBCASE("link cut") {
    m.now.connected = false;
    CHECK(m.step() == ControlState::kHold);
    m.now.connected = true;
  }
  SUBCASE("the clock runs backwards") {
    m.now.now.count -= 500;
    CHECK(m.step() == ControlState::kHold);
    m.step(600);
  }
  SUBCASE("the segment is the operator's") {
    m.now.agent_may = false;
    CHECK(m.step() == ControlState::kOperator);
    m.now.agent_may = true;
  }
  CHECK(m.step(1000) == ControlState::kOperator);
  m.now.agent_pedal = false;
  m.step();
  m.now.agent_pedal = true;
  CHECK(m.step(200) == ControlState::kAgent);
}

TEST_CASE("stop works in every state, and only a new arming leads out of it") {
  for (int state = 0; state < 5; ++state) {
    Machine m;
    if (state == 1) m.now.agent_pedal = true;
    if (state == 2) m.now.clutch_pedal = true;
    if (state == 3) m.now.fresh = false;
    if (state == 4) m.now.ended = true;
    m.step(300);
    m.now.stop = true;
    CHECK(m.step() == ControlState::kStopped);
    m.now.stop = false;
    m.now.fresh = true;
    m.now.ended = false;
    CHECK(m.step(100) == ControlState::kStopped);
    m.now.armed = false;
    CHECK(m.step() == ControlState::kChecked);
    m.now.armed = true;
    CHECK(m.step() == ControlState::kReady);
  }
}

TEST_CASE("no sequence of events gives the agent the arm without a held pedal") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    AuthorityMachine machine;
    ControlLook look;
    // What the pedal did, kept apart from the machine's own book.
    bool seen_up = false;
    std::int64_t down_since = -1;
    bool spoiled = true;
    for (int i = 0; i < 25'000; ++i) {
      look.begin = look.reset = look.stop = false;
      look.now.count += 1;
      switch (random.below(400)) {
        case 0:
          look.now.count += static_cast<std::int64_t>(random.below(2000)) - 1000;
          break;
        case 1:
          look.connected = !look.connected;
          break;
        case 2:
          look.fresh = !look.fresh;
          break;
        case 3:
          look.fault = random.below(4) == 0;
          break;
        case 4:
          look.stop = random.below(4) == 0;
          break;
        case 5:
          look.armed = !look.armed;
          break;
        case 6:
          look.ended = !look.ended;
          break;
        case 7:
          look.reset = true;
          break;
        case 8:
          look.agent_may = !look.agent_may;
          break;
        case 9:
          look.clutch_pedal = !look.clutch_pedal;
          break;
        case 10:
          look.homed = random.below(8) != 0;
          break;
        case 11:
          look.scene_ready = random.below(4) != 0;
          break;
        default:
          break;
      }
      if (random.below(90) == 0) look.begin = true;
      if (random.below(150) == 0) look.agent_pedal = !look.agent_pedal;
      if (!look.agent_pedal) {
        seen_up = true;
        down_since = -1;
        spoiled = false;
      } else if (down_since < 0) {
        down_since = look.now.count;
      }
      const ControlState state = machine.look(look);
      if (state == ControlState::kAgent) {
        REQUIRE(look.agent_pedal);
        REQUIRE(seen_up);
        REQUIRE(look.now.count - down_since >= control::kTap.count);
        REQUIRE(look.agent_may);
        REQUIRE_FALSE(look.clutch_pedal);
        REQUIRE(look.fresh);
        REQUIRE(look.connected);
        REQUIRE(look.armed);
        REQUIRE_FALSE(look.fault);
        REQUIRE_FALSE(look.stop);
        REQUIRE_FALSE(spoiled);
      }
      if (look.agent_pedal && (state == ControlState::kHold || state == ControlState::kStopped)) spoiled = true;
      if (look.stop) REQUIRE(state == ControlState::kStopped);
    }
  }
}
