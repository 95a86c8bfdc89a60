/// Several layers of cells seen as one.
#pragma once

#include "engine/learning/field.h"

namespace trocar::learning {

/// The field with the slice `index` across `axis` (0 x, 1 y, 2 z) changed: each of its cells has the largest known
/// value of the `thickness` cells across, half of them on either side (of an even number, one more above), as far as
/// there are any; unknown where all of them are. Classes have no largest: such a field comes back as it is.
/// Precondition: 0 ≤ index < n, thickness ≥ 1.
Field with_slab(const Field& field, int axis, int index, int thickness);

}  // namespace trocar::learning
