/// Where rollouts start: every cell, the cells around the model's start, or the cells of a file.
#pragma once

#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/learning/model.h"

namespace trocar::app {

/// "all", "around:3" or "file:starts.csv" (a header line with the columns i, j and k, then one cell for each line).
/// Errors: kInvalidArgument for anything else, or an empty list; kIo, kCorrupt for the file.
Result<std::vector<spatial::CellIndex>> starts_from(const std::string& text, const learning::Model& model);

}  // namespace trocar::app
