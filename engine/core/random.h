/// A small seeded generator (xoshiro256**) that gives the same numbers on every machine and compiler.
#pragma once

#include <array>
#include <cstdint>

namespace trocar {

/// Passed in by reference, seeded by the project; never global. Threads: one at a time.
class Random {
 public:
  /// The whole state, so that a snapshot can hold it.
  using State = std::array<std::uint64_t, 4>;

  explicit Random(std::uint64_t seed);
  explicit Random(const State& state) : state_(state) {}

  std::uint64_t next();
  /// Uniform in [0, 1), 53 bits.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in 0 … n − 1, without bias; precondition: n > 0.
  std::uint32_t below(std::uint32_t n);
  /// Standard normal (polar method).
  double normal();
  /// A generator whose stream is independent of this one's; `stream` tells children apart.
  Random child(std::uint64_t stream) const;

  const State& state() const { return state_; }

 private:
  State state_;
};

}  // namespace trocar
