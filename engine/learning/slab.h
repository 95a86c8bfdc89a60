/// Several layers of cells seen as one.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/learning/field.h"

namespace trocar::learning {

/// What a slab shows of the values across it.
enum class Through : std::uint8_t { kLargest, kMean };
std::string_view to_string(Through through);  ///< "largest", "mean"
/// Errors: kInvalidArgument with the names that there are.
Result<Through> through_from(std::string_view text);
const std::vector<Through>& all_through();

/// The field with the slice `index` across `axis` (0 x, 1 y, 2 z) changed: each of its cells has the largest known
/// value, or the mean of the known ones, of the `thickness` cells across, half of them on either side (of an even
/// number, one more above), as far as there are any; unknown where all of them are. Classes have neither: such a field
/// comes back as it is. Precondition: 0 ≤ index < n, thickness ≥ 1.
Field with_slab(const Field& field, int axis, int index, int thickness, Through through = Through::kLargest);

}  // namespace trocar::learning
