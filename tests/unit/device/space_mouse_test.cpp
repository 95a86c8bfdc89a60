#include "engine/device/space_mouse.h"

#include <doctest/doctest.h>

#include <cstdlib>

using namespace trocar;

TEST_CASE("a SpaceMouse is there, at rest or not, or the reason why it is not") {
  auto found = device::SpaceMouse::open();
  if (!found) {
    CHECK(found.error().code() == ErrorCode::kUnsupported);
    CHECK_FALSE(found.error().text().empty());
    return;
  }
  for (const int axis : found->look().axes) CHECK(std::abs(axis) < 10'000);
}
