/// The samples of an effective trajectory: a persistent sequence that edits cut, join and shift without copying
/// samples.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <vector>

#include "engine/demonstration/packed_samples.h"

namespace trocar::demonstration {

/// A run of samples that never changes, packed, with what makes the hash of any part of it cheap.
class SampleBlock {
 public:
  explicit SampleBlock(std::span<const Sample> samples);

  std::size_t size() const { return samples_.size(); }
  Sample at(std::size_t i) const { return samples_.at(i); }
  std::int64_t tick(std::size_t i) const { return samples_.tick(i); }
  /// The polynomial of the first `count` samples; see `SampleTrack::hash`.
  std::uint64_t prefix(std::size_t count) const { return prefix_[count]; }
  /// What it takes of memory.
  std::size_t bytes() const { return samples_.bytes() + prefix_.capacity() * sizeof(std::uint64_t); }

 private:
  friend class BlockBuilder;
  SampleBlock() = default;
  void add(const Sample& sample);
  void finish();

  PackedSamples samples_;
  std::vector<std::uint64_t> prefix_{0};  ///< One more than there are samples.
};

/// Makes a block of samples that come one by one, so that they are nowhere together unpacked.
class BlockBuilder {
 public:
  BlockBuilder() : block_(new SampleBlock) {}
  void add(const Sample& sample) { block_->add(sample); }
  std::size_t size() const { return block_->size(); }
  /// Once, at the end.
  std::shared_ptr<const SampleBlock> take();

 private:
  std::shared_ptr<SampleBlock> block_;
};

/// Immutable value; copies and slices share everything. A sample is handed out by value, its tick as the track has it.
/// Threads: any, as for `shared_ptr<const T>`.
class SampleTrack {
 public:
  SampleTrack() = default;
  /// Of whole samples, by increasing tick. Precondition: not null.
  explicit SampleTrack(std::shared_ptr<const SampleBlock> block);
  explicit SampleTrack(std::span<const Sample> samples);

  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  /// Precondition: `i < size()`; so for `front()` and `back()`.
  Sample operator[](std::size_t i) const;
  std::int64_t tick(std::size_t i) const;
  Sample front() const { return (*this)[0]; }
  Sample back() const { return (*this)[count_ - 1]; }

  /// `count` samples from `first`, cut at the end of the track. Time: constant.
  SampleTrack slice(std::size_t first, std::size_t count) const;
  /// Every sample `ticks` later. Time: by the number of pieces.
  SampleTrack shifted(std::int64_t ticks) const;
  /// One after the other; the caller sees to it that ticks increase. Time: by the number of pieces.
  static SampleTrack joined(const std::vector<SampleTrack>& parts);
  /// `samples` in place of the `count` from `first`. Time: by the number of pieces.
  SampleTrack replaced(std::size_t first, std::size_t count, const SampleTrack& samples) const;
  /// The index of the first sample at or after `tick`; `size()` if there is none.
  std::size_t lower_bound(std::int64_t tick) const;

  /// Of the samples and their ticks, however they are cut into pieces.
  std::uint64_t hash() const;
  /// Samples by value, for who needs them in one place.
  std::vector<Sample> to_vector() const;
  /// True if both show the same samples of the same blocks in the same pieces.
  bool same_pieces(const SampleTrack& other) const;

  /// The blocks that it shows parts of, each at least once.
  template <typename Visit>
  void visit_blocks(const Visit& visit) const {
    if (!table_) return;
    for (const Piece& piece : *table_) visit(*piece.block);
  }

  class Iterator {
   public:
    using iterator_category = std::random_access_iterator_tag;
    using value_type = Sample;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = Sample;

    Iterator() = default;
    Iterator(const SampleTrack* track, std::size_t index) : track_(track), index_(index) {}
    Sample operator*() const;
    Sample operator[](difference_type n) const { return *(*this + n); }
    Iterator& operator+=(difference_type n) {
      index_ = static_cast<std::size_t>(static_cast<difference_type>(index_) + n);
      return *this;
    }
    Iterator& operator-=(difference_type n) { return *this += -n; }
    Iterator& operator++() { return *this += 1; }
    Iterator& operator--() { return *this += -1; }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    Iterator operator--(int) {
      const Iterator before = *this;
      --*this;
      return before;
    }
    friend Iterator operator+(Iterator it, difference_type n) { return it += n; }
    friend Iterator operator+(difference_type n, Iterator it) { return it += n; }
    friend Iterator operator-(Iterator it, difference_type n) { return it -= n; }
    friend difference_type operator-(const Iterator& a, const Iterator& b) {
      return static_cast<difference_type>(a.index_) - static_cast<difference_type>(b.index_);
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.index_ == b.index_; }
    friend auto operator<=>(const Iterator& a, const Iterator& b) { return a.index_ <=> b.index_; }

   private:
    const SampleTrack* track_ = nullptr;  ///< Outlives the iterator.
    std::size_t index_ = 0;
    mutable std::size_t piece_ = 0;  ///< Where the last sample was found.
  };
  Iterator begin() const { return {this, 0}; }
  Iterator end() const { return {this, count_}; }

 private:
  struct Piece {
    std::shared_ptr<const SampleBlock> block;
    std::size_t first = 0;   ///< In the block.
    std::size_t count = 0;   ///< Never 0.
    std::int64_t shift = 0;  ///< Ticks that its samples are later than in the block.
    std::size_t start = 0;   ///< In the table.
  };
  using Table = std::vector<Piece>;

  explicit SampleTrack(Table table);
  /// The piece that holds the table's sample `at`, looked for from `hint` on.
  std::size_t piece_of(std::size_t at, std::size_t hint) const;
  Table cut() const;
  static void append(Table& table, Piece piece);

  std::shared_ptr<const Table> table_;
  std::size_t first_ = 0;  ///< Of the view, in the table.
  std::size_t count_ = 0;
};

}  // namespace trocar::demonstration
