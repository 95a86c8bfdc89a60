/// Gathers rows of numbers into an imported recording, whatever file they come from.
#pragma once

#include <vector>

#include "engine/exchange/columns.h"
#include "engine/exchange/imported.h"

namespace trocar::exchange {

/// Files of rows are read and written in pieces of about this size.
constexpr std::size_t kPiece_bytes = std::size_t{1} << 22U;

class RowReader {
 public:
  explicit RowReader(std::vector<const Column*> order) : order_(std::move(order)) {}

  /// Errors: kInvalidArgument saying what is wrong with this row, without its number.
  Status add(const std::vector<double>& values);
  /// Errors: kCorrupt for fewer than 2 rows.
  Result<Imported> finish();

 private:
  std::vector<const Column*> order_;
  Imported imported_;
};

}  // namespace trocar::exchange
