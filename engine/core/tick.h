/// Simulated time: a whole number of ticks of one millisecond, never a sum of `dt`.
#pragma once

#include <compare>
#include <cstdint>

namespace trocar {

struct Tick {
  static constexpr std::int64_t kPerSecond = 1000;

  std::int64_t count = 0;

  double seconds() const { return static_cast<double>(count) / static_cast<double>(kPerSecond); }
  // clang-tidy 14 takes the 0 inside of the defaulted operator for a null pointer.
  auto operator<=>(const Tick&) const = default;  // NOLINT(modernize-use-nullptr)
};

/// The tick nearest to `seconds`; precondition: finite and below 10⁹.
inline Tick tick_at(double seconds) {
  const double scaled = seconds * static_cast<double>(Tick::kPerSecond);
  return Tick{static_cast<std::int64_t>(scaled < 0.0 ? scaled - 0.5 : scaled + 0.5)};
}

}  // namespace trocar
