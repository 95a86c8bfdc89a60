// Nodes of an HDF5 file from any bytes, each with its length in 32 bits in front: what decodes must come back from its
// own bytes, and what is accepted as robomimic's layout must make demonstrations that take every note.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

#include "engine/demonstration/edits.h"
#include "engine/exchange/robomimic.h"

namespace {

using namespace trocar;

void check_again(const exchange::TreeNode& node) {
  const std::string bytes = exchange::encode(node);
  const auto again = exchange::decode(bytes);
  if (!again || exchange::encode(*again) != bytes) __builtin_trap();
}

void check(exchange::Imported read) {
  const auto recording = std::make_shared<const demonstration::Recording>(std::move(read.recording));
  auto document = demonstration::make_demonstration({1}, "Imported", recording);
  if (!document) __builtin_trap();
  for (const demonstration::AddNote& note : read.notes) {
    document = demonstration::apply(*document, note, 1);
    if (!document) __builtin_trap();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view bytes(reinterpret_cast<const char*>(data), size);
  exchange::RobomimicReader reader({});
  while (bytes.size() >= sizeof(std::uint32_t)) {
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data(), sizeof length);
    bytes.remove_prefix(sizeof length);
    auto node = exchange::decode(bytes.substr(0, length));
    if (node) check_again(*node);
    if (node && !reader.take(std::move(*node))) return 0;
    bytes.remove_prefix(std::min<std::size_t>(length, bytes.size()));
  }
  auto all = reader.finish();
  if (!all) return 0;
  for (exchange::Imported& read : *all) check(std::move(read));
  return 0;
}
