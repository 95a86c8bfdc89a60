/// Gathers rows of numbers into an imported recording, whatever file they come from.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "engine/core/file.h"
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

/// What a `Reader` of pieces makes of a file, which is not held in memory. Errors: the reader's; kIo.
template <typename Reader>
Result<Imported> read_file_in_pieces(const std::filesystem::path& path) {
  Reader reader;
  TROCAR_RETURN_IF_ERROR(
      read_pieces(path, kPiece_bytes, [&reader](std::string_view piece) { return reader.add(piece); }));
  return reader.finish();
}

}  // namespace trocar::exchange
