#include "engine/control/pedal.h"

#include <doctest/doctest.h>

using trocar::Tick;
using trocar::control::Pedal;
using trocar::control::PedalEvent;

TEST_CASE("a press and a release each show once") {
  Pedal pedal;
  CHECK_FALSE(pedal.look(false, Tick{0}).pressed);
  CHECK(pedal.look(true, Tick{5}).pressed);
  CHECK_FALSE(pedal.look(true, Tick{10}).pressed);
  CHECK(pedal.look(false, Tick{15}).released);
  CHECK_FALSE(pedal.look(false, Tick{20}).released);
}

TEST_CASE("a quick tap never counts as a dead-man") {
  Pedal pedal;
  pedal.look(false, Tick{0});
  for (int t = 5; t < 150; t += 5) CHECK_FALSE(pedal.look(true, Tick{t}).dead_man);
  const PedalEvent up = pedal.look(false, Tick{150});
  CHECK_FALSE(up.dead_man);
  CHECK(up.tapped);
}

TEST_CASE("many quick taps do not add up to a dead-man") {
  Pedal pedal;
  for (int t = 0; t < 2000; t += 5) CHECK_FALSE(pedal.look(t / 100 % 2 == 1, Tick{t}).dead_man);
}

TEST_CASE("a held pedal becomes a dead-man after the tap time and ends it at once") {
  Pedal pedal;
  pedal.look(false, Tick{0});
  pedal.look(true, Tick{5});
  CHECK_FALSE(pedal.look(true, Tick{154}).dead_man);
  CHECK(pedal.look(true, Tick{155}).dead_man);
  const PedalEvent up = pedal.look(false, Tick{160});
  CHECK_FALSE(up.dead_man);
  CHECK_FALSE(up.tapped);
}

TEST_CASE("a pedal that was already down at the first look is no dead-man until it is pressed anew") {
  Pedal pedal;
  CHECK_FALSE(pedal.look(true, Tick{0}).pressed);
  CHECK_FALSE(pedal.look(true, Tick{1000}).dead_man);
  pedal.look(false, Tick{1005});
  pedal.look(true, Tick{1010});
  CHECK(pedal.look(true, Tick{1160}).dead_man);
}
