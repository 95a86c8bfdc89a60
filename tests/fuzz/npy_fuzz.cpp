// A NumPy array from any bytes: what is accepted must be a recording that makes a demonstration.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "engine/demonstration/demonstration.h"
#include "engine/exchange/npy.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trocar;
  auto read = exchange::from_npy({reinterpret_cast<const char*>(data), size});
  if (!read) return 0;
  const auto recording = std::make_shared<const demonstration::Recording>(std::move(read->recording));
  if (!demonstration::make_demonstration({1}, "Imported", recording)) __builtin_trap();
  return 0;
}
