#include "engine/core/random.h"

#include <bit>
#include <cmath>

#include "engine/core/check.h"

namespace trocar {
namespace {

/// SplitMix64, the usual way to fill a larger state from one word.
std::uint64_t split_mix(std::uint64_t& x) {
  x += 0x9E3779B97F4A7C15ULL;
  std::uint64_t z = x;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31);
}

}  // namespace

Random::Random(std::uint64_t seed) {
  for (std::uint64_t& word : state_) word = split_mix(seed);
}

std::uint64_t Random::next() {
  const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
  const std::uint64_t t = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= t;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

std::uint32_t Random::below(std::uint32_t n) {
  TROCAR_ASSERT(n > 0);
  // Lemire's method: the high word of a product, rejecting the few values that would favour some results.
  std::uint64_t product = (next() >> 32) * n;
  if (static_cast<std::uint32_t>(product) < n) {
    const std::uint32_t threshold = (0U - n) % n;
    while (static_cast<std::uint32_t>(product) < threshold) product = (next() >> 32) * n;
  }
  return static_cast<std::uint32_t>(product >> 32);
}

double Random::normal() {
  double u = 0.0;
  double square = 0.0;
  do {
    u = uniform(-1.0, 1.0);
    const double v = uniform(-1.0, 1.0);
    square = u * u + v * v;
  } while (square >= 1.0 || square == 0.0);
  return u * std::sqrt(-2.0 * std::log(square) / square);
}

Random Random::child(std::uint64_t stream) const {
  std::uint64_t mixed = state_[0] ^ std::rotl(state_[3], 23) ^ (stream * 0xD1342543DE82EF95ULL + 1);
  return Random(split_mix(mixed));
}

}  // namespace trocar
