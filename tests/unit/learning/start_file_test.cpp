#include "engine/learning/start_file.h"

#include <doctest/doctest.h>

using namespace trocar;
using namespace trocar::learning;

TEST_CASE("starts are read by the names of their columns, whatever else a line holds") {
  const spatial::Grid grid;
  const auto starts = parse_starts("k,end,j,i\r\n3,loops,2,1\r\n\n21,x,0,5\n", grid);
  REQUIRE(starts);
  CHECK(*starts == std::vector{grid.index({1, 2, 3}), grid.index({5, 0, 21})});
}

TEST_CASE("a file of starts that cannot be read says which line is at fault") {
  const spatial::Grid grid;
  CHECK(parse_starts("i,j\n1,2\n", grid).error().text().find("no column k") != std::string::npos);
  CHECK(parse_starts("i,j,k\n1,2,3\n1,2\n", grid).error().text().find("line 3") != std::string::npos);
  CHECK(parse_starts("i,j,k\n1,2,22\n", grid).error().text().find("line 2") != std::string::npos);
  CHECK_FALSE(parse_starts("i,j,k\n", grid));
  CHECK_FALSE(parse_starts("", grid));
}
