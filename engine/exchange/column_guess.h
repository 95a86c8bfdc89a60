/// What the columns of an unknown table may be: a map to look at, correct and use.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/exchange/column_map.h"

namespace trocar::exchange {

struct ColumnGuess {
  ColumnMap map;
  std::vector<std::string> doubts;  ///< What is likely but not certain, one sentence each.
};

/// By the names in the header; without them by the numbers: rising ones are a time, four of unit length a quaternion
/// behind its position, six and a jaw, over and over, joints. Units by names, else by sizes. Nothing if no
/// position and no joints are recognised. Errors: kCorrupt for what is no table; those of `NumberTable`.
Result<std::optional<ColumnGuess>> guess_columns_of_text(std::string_view text);
Result<std::optional<ColumnGuess>> guess_columns_of_npy(std::string_view bytes);

}  // namespace trocar::exchange
