// Tables over the lattice from any bytes, as NumPy's array and as text: what is accepted has a number for each cell and
// action, and comes back the same from what is written of it.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/exchange/lattice_table.h"
#include "engine/exchange/npy.h"

namespace {

using trocar::learning::TableKind;

void check(const trocar::Result<std::vector<double>>& table, TableKind kind, const trocar::spatial::Grid& grid) {
  if (!table) return;
  const auto n = static_cast<std::size_t>(grid.n);
  const auto width = static_cast<std::size_t>(trocar::learning::table_width(kind));
  if (table->size() != n * n * n * width) __builtin_trap();
  const auto again =
      trocar::exchange::parse_table_npy(trocar::exchange::to_npy({{n * n * n, width}, *table}), kind, grid);
  if (!again) __builtin_trap();
  for (std::size_t i = 0; i < table->size(); ++i) {
    if ((*again)[i] != (*table)[i] && !std::isnan((*table)[i])) __builtin_trap();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trocar;
  static const spatial::Grid kGrid = spatial::Grid::with_cells(4);
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const TableKind kind : {TableKind::kQ, TableKind::kTheta}) {
    check(exchange::parse_table_npy(bytes, kind, kGrid), kind, kGrid);
    check(exchange::parse_table_csv(bytes, kind, kGrid), kind, kGrid);
  }
  return 0;
}
