// Any bytes as an HDF5 file: whatever HDF5 itself makes of them happens in its own process, and here there is an error
// or demonstrations. (For the speed of a fuzzer see tree_fuzz, which begins behind that process.)
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "engine/core/file.h"
#include "engine/demonstration/demonstration.h"
#include "engine/exchange/robomimic.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trocar;
  static const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("trocar_hdf5_fuzz_" + std::to_string(::getpid()) + ".hdf5");
  if (!write_file(path, {reinterpret_cast<const char*>(data), size})) return 0;
  auto all = exchange::read_robomimic(path, {});
  std::filesystem::remove(path);
  // Without its process nothing would be tested.
  if (!all && all.error().code() == ErrorCode::kUnsupported &&
      all.error().text().find("missing") != std::string::npos) {
    __builtin_trap();
  }
  if (!all) return 0;
  for (exchange::Imported& read : *all) {
    const auto recording = std::make_shared<const demonstration::Recording>(std::move(read.recording));
    if (!demonstration::make_demonstration({1}, "Imported", recording)) __builtin_trap();
  }
  return 0;
}
