/// A 64-bit hash (FNV-1a over bytes, finished by an avalanche) for states, documents and provenance; not for security.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace trocar {

class Hasher {
 public:
  Hasher& bytes(std::span<const std::byte> data);
  Hasher& text(std::string_view data);
  /// For numbers and enumerations: their exact bit pattern (so −0.0 and 0.0 differ).
  template <typename T>
  Hasher& value(const T& number) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    return bytes(std::as_bytes(std::span<const T, 1>(&number, 1)));
  }
  std::uint64_t digest() const;

 private:
  std::uint64_t state_ = 0xCBF29CE484222325ULL;
};

/// Sixteen lower-case hexadecimal digits.
std::string to_hex(std::uint64_t hash);

}  // namespace trocar
