#include "engine/spatial/cell_text.h"

#include <doctest/doctest.h>

using namespace trocar::spatial;

TEST_CASE("a cell is three numbers with commas between them and nothing else") {
  const auto cell = coordinates_from("3,14,0");
  REQUIRE(cell);
  CHECK(cell->x == 3);
  CHECK(cell->y == 14);
  CHECK(cell->z == 0);
  for (const char* text :
       {"", "3", "3,4", "3,4,", "3,4,5,", "3,4,5,6", "3, 4,5", "a,b,c", "3.5,4,5", "99999999999,1,1"}) {
    CAPTURE(text);
    CHECK_FALSE(coordinates_from(text));
  }
}
