// A script of hand movements: what is accepted ends, and asks of the link nothing that it would not carry.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/link/hand_script.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trocar;
  const auto script = link::parse_hand_script({reinterpret_cast<const char*>(data), size});
  if (!script) return 0;
  if (!(script->end_s() >= 0.0 && script->end_s() <= 3660.0)) __builtin_trap();
  for (int i = 0; i <= 20; ++i) {
    const link::HandFrame frame = script->at(script->end_s() * i / 20.0);
    const auto read = link::decode(std::string_view(link::encode(frame)).substr(4));
    if (!read || !(std::get<link::HandFrame>(*read) == frame)) __builtin_trap();
  }
  return 0;
}
