#include "engine/workbench/time_left.h"

#include <doctest/doctest.h>

using trocar::workbench::TimeLeft;

TEST_CASE("what is left follows from the pace since the first step, and is not known before the second") {
  TimeLeft left;
  left.look(100.0, 0.0, false);  // it begins: reading, opening
  left.look(105.0, 0.1, false);
  CHECK_FALSE(left.left_s());
  left.look(107.0, 0.2, false);  // a tenth in two seconds
  CHECK(left.left_s().value() == doctest::Approx(16.0));
  left.look(108.0, 0.2, false);  // between two steps nothing new is known
  CHECK(left.left_s().value() == doctest::Approx(16.0));
  left.look(109.0, 0.3, false);
  CHECK(left.left_s().value() == doctest::Approx(14.0));
  left.look(123.0, 1.0, false);
  CHECK(left.left_s().value() == doctest::Approx(0.0));
}

TEST_CASE("a pause does not count as work") {
  TimeLeft left;
  left.look(0.0, 0.1, false);
  left.look(1.0, 0.2, true);
  CHECK(left.left_s().value() == doctest::Approx(8.0));
  left.look(500.0, 0.2, true);
  left.look(1000.0, 0.2, false);
  left.look(1001.0, 0.3, false);
  CHECK(left.left_s().value() == doctest::Approx(7.0));
}
