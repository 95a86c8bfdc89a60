/// Tables over the lattice in files: Q of each cell and action, or θ of each cell.
///
/// The order of the numbers is x, y, z, action, the last running fastest, with the actions +x, -x, +y, -y, +z, -z.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/learning/imported_model.h"

namespace trocar::exchange {

/// What every help says of the order: "n×n×n×6 in the order x, y, z, action …".
std::string table_order(learning::TableKind kind);

/// Of n×n×n×6 or n³×6 (θ: n×n×n, n³ or n³×1), real or whole numbers of 4 or 8 bytes. NaN where nothing is known.
/// Errors: kCorrupt, with the shapes expected and found; kUnsupported for other numbers.
Result<std::vector<double>> parse_table_npy(std::string_view bytes, learning::TableKind kind,
                                            const spatial::Grid& grid);
/// With a header line "i,j,k,+x,-x,+y,-y,+z,-z" (θ: "i,j,k,theta", or "value" as in a field's CSV), columns in any
/// order and others among them: a row for each cell that is known. Without one: n³ rows of 6 numbers (θ: 1) in the
/// order of the cells. An empty cell and "nan" are unknown. Errors: kCorrupt, naming the line.
Result<std::vector<double>> parse_table_csv(std::string_view text, learning::TableKind kind, const spatial::Grid& grid);

/// By the ending: .npy or .csv. Errors: kInvalidArgument for another; kIo; those of the parsers.
Result<std::vector<double>> read_table(const std::filesystem::path& path, learning::TableKind kind,
                                       const spatial::Grid& grid);
/// What `read_table` gives back, bit for bit but for the kind of NaN: .npy of n×n×n×6 or n×n×n, or .csv with a header.
/// Errors: kInvalidArgument for another ending; kIo.
Status write_table(const std::vector<double>& table, learning::TableKind kind, const spatial::Grid& grid,
                   const std::filesystem::path& path);

}  // namespace trocar::exchange
