#include "engine/learning/slab.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace trocar;

TEST_CASE("a slab has the largest known value of the cells across it, or their mean, on every axis") {
  learning::Field field;
  field.grid = spatial::Grid::with_cells(5);
  for (int s = 0; s < field.grid.cell_count(); ++s) {
    const spatial::CellCoordinates c = field.grid.coordinates({s});
    field.values.push_back(100.0 * c.x + 10.0 * c.y + c.z);
  }
  const auto value = [](const learning::Field& of, int x, int y, int z) {
    return of.values[static_cast<std::size_t>(of.grid.index({x, y, z}).value)];
  };
  CHECK(value(learning::with_slab(field, 0, 2, 3), 2, 1, 4) == 314.0);
  CHECK(value(learning::with_slab(field, 1, 2, 3), 3, 2, 4) == 334.0);
  CHECK(value(learning::with_slab(field, 2, 2, 3), 3, 1, 2) == 313.0);
  CHECK(value(learning::with_slab(field, 2, 2, 2), 3, 1, 2) == 313.0);  // of an even number, one more above
  CHECK(value(learning::with_slab(field, 2, 4, 9), 3, 1, 4) == 314.0);  // as far as there are any
  CHECK(value(learning::with_slab(field, 2, 2, 3), 3, 1, 1) == 311.0);  // other slices stay
  CHECK(learning::with_slab(field, 2, 2, 1).values == field.values);
  CHECK(value(learning::with_slab(field, 0, 2, 3, learning::Through::kMean), 2, 1, 4) == 214.0);
  CHECK(value(learning::with_slab(field, 0, 2, 4, learning::Through::kMean), 2, 1, 4) == 264.0);

  field.values.assign(field.values.size(), std::numeric_limits<double>::quiet_NaN());
  field.values[static_cast<std::size_t>(field.grid.index({1, 1, 1}).value)] = -7.0;
  CHECK(value(learning::with_slab(field, 0, 2, 3), 2, 1, 1) == -7.0);
  CHECK(std::isnan(value(learning::with_slab(field, 0, 2, 3), 2, 1, 2)));
  // The mean is of those that are known.
  field.values[static_cast<std::size_t>(field.grid.index({2, 1, 1}).value)] = -4.0;
  CHECK(value(learning::with_slab(field, 0, 2, 3, learning::Through::kMean), 2, 1, 1) == -5.5);
  field.values[static_cast<std::size_t>(field.grid.index({2, 1, 1}).value)] = std::nan("");
  CHECK(std::isnan(value(learning::with_slab(field, 0, 2, 3, learning::Through::kMean), 2, 1, 2)));
  field.categorical = true;
  CHECK(std::isnan(value(learning::with_slab(field, 0, 2, 3), 2, 1, 1)));
}
