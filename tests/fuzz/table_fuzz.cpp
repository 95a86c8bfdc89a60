// A map of columns and a table, parted by the first zero byte: what is accepted as a map must come back from its own
// JSON, and what it makes of the table must be a demonstration. Then the same table with the map that is proposed for
// it, as text and as an array.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "engine/demonstration/demonstration.h"
#include "engine/exchange/column_guess.h"
#include "engine/exchange/mapped_table.h"

namespace {

using namespace trocar;

void import(const Result<exchange::NumberTable>& table, const exchange::ColumnMap& map) {
  if (!table) return;
  auto read = exchange::from_table(*table, map);
  if (!read) return;
  const auto recording = std::make_shared<const demonstration::Recording>(std::move(read->recording));
  if (!demonstration::make_demonstration({1}, "Imported", recording)) __builtin_trap();
}

void check_again(const exchange::ColumnMap& map) {
  const std::string json = exchange::to_json(map);
  const auto again = exchange::column_map_from_json(json);
  if (!again || exchange::to_json(*again) != json) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t zero = bytes.find('\0');
  const std::string_view table = zero == std::string_view::npos ? "" : bytes.substr(zero + 1);
  if (const auto map = exchange::column_map_from_json(bytes.substr(0, zero)); map) {
    check_again(*map);
    import(exchange::NumberTable::of_text(table, exchange::TextLayout::of(*map)), *map);
    import(exchange::NumberTable::of_npy(table), *map);
  }
  if (const auto guess = exchange::guess_columns_of_text(table); guess && *guess) {
    check_again((*guess)->map);
    import(exchange::NumberTable::of_text(table, exchange::TextLayout::of((*guess)->map)), (*guess)->map);
  }
  if (const auto guess = exchange::guess_columns_of_npy(table); guess && *guess) {
    check_again((*guess)->map);
    import(exchange::NumberTable::of_npy(table), (*guess)->map);
  }
  return 0;
}
