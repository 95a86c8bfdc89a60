/// Starts of rollouts that are listed in a file, beside those that one line of text names.
#pragma once

#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/learning/model.h"

namespace trocar::learning {

/// "file:starts.csv" beside the forms of `starts_from`.
constexpr std::string_view kStartFile = "file:";
/// Errors: those of `starts_from`; kIo, kCorrupt for the file.
Result<std::vector<spatial::CellIndex>> read_starts(std::string_view text, const Model& model);

/// A header line with the columns i, j and k among others, then one cell for each line; as `rollout_csv` writes it.
/// Errors: kCorrupt, naming the line.
Result<std::vector<spatial::CellIndex>> parse_starts(std::string_view text, const spatial::Grid& grid);

}  // namespace trocar::learning
