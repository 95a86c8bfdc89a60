#include "engine/core/hash.h"

#include <fmt/format.h>

namespace trocar {

Hasher& Hasher::bytes(std::span<const std::byte> data) {
  for (const std::byte b : data) state_ = (state_ ^ static_cast<std::uint64_t>(b)) * 0x100000001B3ULL;
  return *this;
}

Hasher& Hasher::text(std::string_view data) {
  value(data.size());
  return bytes(std::as_bytes(std::span<const char>(data.data(), data.size())));
}

std::uint64_t Hasher::digest() const {
  std::uint64_t z = state_;
  z = (z ^ (z >> 33)) * 0xFF51AFD7ED558CCDULL;
  z = (z ^ (z >> 33)) * 0xC4CEB9FE1A85EC53ULL;
  return z ^ (z >> 33);
}

std::string to_hex(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

}  // namespace trocar
