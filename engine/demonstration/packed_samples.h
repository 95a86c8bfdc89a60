/// Samples in about a third of their room, without a loss: what stays the same for a sixth of a second is kept once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/demonstration/recording.h"

namespace trocar::demonstration {

/// A list that grows at its end. Runs of 32 samples keep their first one whole, and of the others those bytes of each
/// 8-byte word in which any of them differs from it: blocks at rest, exponents and constant rotations cost nothing.
/// Threads: one writer; any reader of what no longer grows.
class PackedSamples {
 public:
  PackedSamples() = default;
  explicit PackedSamples(std::span<const Sample> samples);

  void add(const Sample& sample);
  /// After the last sample; gives back what was reserved for more.
  void finish();

  std::size_t size() const { return count_; }
  /// Precondition: `i < size()`, and `i` is of a whole run or `finish` was called. Time: constant.
  Sample at(std::size_t i) const;
  std::int64_t tick(std::size_t i) const;
  /// Bytes that the samples take.
  std::size_t bytes() const;

 private:
  static constexpr std::size_t kRun = 32;
  using Word = std::uint64_t;
  static constexpr std::size_t kWords = sizeof(Sample) / sizeof(Word);
  static_assert(kWords * sizeof(Word) == sizeof(Sample));
  /// The bytes of a word that vary within a run.
  struct Varying {
    std::uint8_t word = 0;
    std::uint8_t first = 0;  ///< The lowest of them.
    std::uint8_t count = 0;
  };
  /// At the front of a run; the varying words follow, by their place, and then what each sample but the first has of
  /// them, as its difference (exclusive or) from the first.
  struct Head {
    std::array<Word, kWords> first;
    std::uint16_t varying = 0;
    std::uint16_t row_bytes = 0;
  };
  /// A slab holds whole runs.
  struct Slab {
    std::unique_ptr<std::byte[]> bytes;
    std::size_t used = 0;
    std::size_t room = 0;
  };

  void pack();
  std::byte* reserve(std::size_t bytes);

  std::vector<Slab> slabs_;
  std::vector<const std::byte*> runs_;
  std::vector<Sample> open_;  ///< Of the run that is not full yet.
  std::size_t count_ = 0;
};

}  // namespace trocar::demonstration
