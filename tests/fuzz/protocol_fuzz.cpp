// Protocols from any bytes: what is accepted has blocks that end, an order for everybody, and reads back the same.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/trial/protocol.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trocar::trial;
  const auto protocol = protocol_from_json({reinterpret_cast<const char*>(data), size});
  if (!protocol) return 0;
  const std::string text = to_json(*protocol);
  const auto again = protocol_from_json(text);
  if (!again || to_json(*again) != text) __builtin_trap();
  for (int subject = 0; subject < 4; ++subject) {
    if (order_for(*protocol, subject, 1).size() != protocol->blocks.size()) __builtin_trap();
  }
  for (const ProtocolBlock& block : protocol->blocks) {
    if (!block_over(block, 10'000, 10'000, 86'400.0)) __builtin_trap();
  }
  return 0;
}
