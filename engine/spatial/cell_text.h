/// Cells as people type them.
#pragma once

#include <string_view>

#include "engine/core/result.h"
#include "engine/spatial/grid.h"

namespace trocar::spatial {

/// "3,4,5". Whether it lies in a lattice is not asked. Errors: kInvalidArgument.
Result<CellCoordinates> coordinates_from(std::string_view text);

}  // namespace trocar::spatial
