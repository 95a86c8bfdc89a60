// Start sets from any bytes, as the one line of text and as the rows of a file: only cells of the lattice come of it,
// and the cells of a line, written out, are the same again.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/learning/rollout.h"
#include "engine/learning/start_file.h"
#include "engine/learning/start_set.h"

namespace {

trocar::learning::Model small_model() {
  trocar::learning::Model model;
  model.grid = trocar::spatial::Grid::with_cells(6);
  model.start = {0};
  model.goal = {100};
  model.experts = {{{0}}};
  model.safe = trocar::spatial::CellSet(model.grid, true);
  return model;
}

bool within(const std::vector<trocar::spatial::CellIndex>& cells, const trocar::spatial::Grid& grid) {
  return !cells.empty() && std::all_of(cells.begin(), cells.end(), [&grid](const auto cell) {
    return cell.value >= 0 && cell.value < grid.cell_count();
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trocar::learning;
  static const Model kModel = small_model();
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto cells = parse_starts(text, kModel.grid); cells && !within(*cells, kModel.grid)) __builtin_trap();
  auto cells = starts_from(text, kModel);
  if (!cells) return 0;
  if (!within(*cells, kModel.grid)) __builtin_trap();
  const auto again = starts_from(start_text(*cells), kModel);
  std::sort(cells->begin(), cells->end());
  cells->erase(std::unique(cells->begin(), cells->end()), cells->end());
  if (!again || *again != *cells) __builtin_trap();
  return 0;
}
