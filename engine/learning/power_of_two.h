/// Exact scaling by powers of two, for numbers whose range no double could hold.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace trocar::learning {

/// 2^k; beyond ±1022 the nearest of these two.
inline double power_of_two(int k) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(std::clamp(k, -1022, 1022) + 1023) << 52);
}

/// Precondition: `power` came from `power_of_two`.
inline double inverse_of_power_of_two(double power) {
  return std::bit_cast<double>(0x7FE0000000000000ULL - std::bit_cast<std::uint64_t>(power));
}

}  // namespace trocar::learning
