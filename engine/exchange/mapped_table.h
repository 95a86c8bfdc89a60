/// A foreign table, read through a column map.
#pragma once

#include "engine/exchange/column_map.h"
#include "engine/exchange/imported.h"
#include "engine/exchange/number_table.h"

namespace trocar::exchange {

/// Rows that cannot be samples (a number is missing, the rotation is none, the time is not later than that of the row
/// before) are left out; `found` says how many and where the first is. An arm that the map leaves out stands at its
/// ready pose; a tool without a rotation points down. Poses from joints are where `kinematics::forward` puts them.
/// Errors: kInvalidArgument for a map that does not fit the table; kCorrupt naming the line at fault, or if fewer than
/// 2 rows, or not even half of them, can be samples.
Result<Imported> from_table(const NumberTable& table, const ColumnMap& map);

}  // namespace trocar::exchange
