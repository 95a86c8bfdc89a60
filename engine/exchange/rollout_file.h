/// Rows of rollouts as a file for other programs: one table as CSV, JSON or HDF5, with the same numbers.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "engine/core/result.h"

namespace trocar::exchange {

/// Writes the rows that `learning::rollout_csv` or `trial::physics_csv` made, by the ending of `path`:
///
/// | ending | the file |
/// | .csv | `csv` as it is |
/// | .json | one object: `about` as texts, "columns" as names, "rollouts" with one object for each row; null where
/// nothing is known | | .h5, .hdf5 | one array for each column, in its length: int64 for whole numbers, float64 (NaN
/// where nothing is known), texts; `about` as attributes of the root |
///
/// Errors: kInvalidArgument for another ending, kUnsupported without the HDF5 process, kIo.
Status write_rollout_rows(const std::string& csv, const std::map<std::string, std::string>& about,
                          const std::filesystem::path& path);

}  // namespace trocar::exchange
