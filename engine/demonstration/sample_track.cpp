#include "engine/demonstration/sample_track.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

#include "engine/core/check.h"

namespace trocar::demonstration {
namespace {

// The hash of a track is a polynomial over the prime field of 2^61 − 1: sum of v_i B^(n−1−i), where v_i = h_i + K
// tick_i and h_i hashes everything of a sample but its tick. So that of a slice follows from two prefixes, that of a
// joined track from its parts', and a shift by s ticks adds K s (B^(n−1) + … + 1).
constexpr std::uint64_t kPrime = (1ULL << 61U) - 1;
constexpr std::uint64_t kBase = 0x0A3B195354A39B70ULL % kPrime;
constexpr std::uint64_t kTickFactor = 0x1B03738712FAD5C9ULL % kPrime;

std::uint64_t add(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t sum = a + b;
  return sum >= kPrime ? sum - kPrime : sum;
}

std::uint64_t subtract(std::uint64_t a, std::uint64_t b) {
  return a >= b ? a - b : a + kPrime - b;
}

__extension__ using Wide = unsigned __int128;

std::uint64_t multiply(std::uint64_t a, std::uint64_t b) {
  const Wide product = static_cast<Wide>(a) * b;
  return add(static_cast<std::uint64_t>(product & kPrime), static_cast<std::uint64_t>(product >> 61U));
}

/// B^n, and B^(n−1) + … + 1.
struct Powers {
  std::uint64_t power = 1;
  std::uint64_t sum = 0;
};

Powers powers(std::size_t n) {
  Powers result;
  for (int bit = static_cast<int>(std::bit_width(n)) - 1; bit >= 0; --bit) {
    result = {multiply(result.power, result.power), add(multiply(result.sum, result.power), result.sum)};
    if (((n >> static_cast<unsigned>(bit)) & 1U) != 0) {
      result = {multiply(result.power, kBase), add(multiply(result.sum, kBase), 1)};
    }
  }
  return result;
}

std::uint64_t field_value(std::int64_t number) {
  const auto magnitude = static_cast<std::uint64_t>(number < 0 ? -number : number) % kPrime;
  return number < 0 ? subtract(0, magnitude) : magnitude;
}

std::uint64_t value_of(const Sample& sample) {
  Sample still = sample;
  still.tick = 0;
  SampleHasher hasher;
  hasher.add(still);
  return add(hasher.digest() % kPrime, multiply(kTickFactor, field_value(sample.tick)));
}

}  // namespace

SampleBlock::SampleBlock(std::span<const Sample> samples) {
  prefix_.reserve(samples.size() + 1);
  for (const Sample& sample : samples) add(sample);
  finish();
}

void SampleBlock::add(const Sample& sample) {
  samples_.add(sample);
  prefix_.push_back(demonstration::add(multiply(prefix_.back(), kBase), value_of(sample)));
}

void SampleBlock::finish() {
  samples_.finish();
  prefix_.shrink_to_fit();
}

std::shared_ptr<const SampleBlock> BlockBuilder::take() {
  block_->finish();
  return std::move(block_);
}

SampleTrack::SampleTrack(std::shared_ptr<const SampleBlock> block) {
  const std::size_t count = block->size();
  if (count == 0) return;
  table_ = std::make_shared<const Table>(Table{Piece{std::move(block), 0, count, 0, 0}});
  count_ = count;
}

SampleTrack::SampleTrack(std::span<const Sample> samples) : SampleTrack(std::make_shared<const SampleBlock>(samples)) {}

SampleTrack::SampleTrack(Table table) {
  if (table.empty()) return;
  count_ = table.back().start + table.back().count;
  table_ = std::make_shared<const Table>(std::move(table));
}

std::size_t SampleTrack::piece_of(std::size_t at, std::size_t hint) const {
  const Table& table = *table_;
  const auto holds = [&](std::size_t piece) {
    return piece < table.size() && at >= table[piece].start && at - table[piece].start < table[piece].count;
  };
  if (holds(hint)) return hint;
  if (holds(hint + 1)) return hint + 1;
  const auto after = std::partition_point(table.begin(), table.end(), [&](const Piece& p) { return p.start <= at; });
  return static_cast<std::size_t>(after - table.begin()) - 1;
}

Sample SampleTrack::operator[](std::size_t i) const {
  return *Iterator(this, i);
}

std::int64_t SampleTrack::tick(std::size_t i) const {
  TROCAR_ASSERT(i < count_);
  const std::size_t at = first_ + i;
  const Piece& piece = (*table_)[piece_of(at, 0)];
  return piece.block->tick(piece.first + at - piece.start) + piece.shift;
}

Sample SampleTrack::Iterator::operator*() const {
  TROCAR_ASSERT(index_ < track_->count_);
  const std::size_t at = track_->first_ + index_;
  piece_ = track_->piece_of(at, piece_);
  const Piece& piece = (*track_->table_)[piece_];
  Sample sample = piece.block->at(piece.first + at - piece.start);
  sample.tick += piece.shift;
  return sample;
}

SampleTrack SampleTrack::slice(std::size_t first, std::size_t count) const {
  SampleTrack part = *this;
  part.first_ = first_ + std::min(first, count_);
  part.count_ = std::min(count, count_ - std::min(first, count_));
  return part;
}

void SampleTrack::append(Table& table, Piece piece) {
  if (!table.empty()) {
    Piece& last = table.back();
    piece.start = last.start + last.count;
    if (last.block == piece.block && last.shift == piece.shift && last.first + last.count == piece.first) {
      last.count += piece.count;
      return;
    }
  } else {
    piece.start = 0;
  }
  table.push_back(std::move(piece));
}

/// The pieces of the view alone.
SampleTrack::Table SampleTrack::cut() const {
  Table result;
  if (count_ == 0) return result;
  for (std::size_t at = first_, i = piece_of(first_, 0); at < first_ + count_; ++i) {
    Piece piece = (*table_)[i];
    const std::size_t skipped = at - piece.start;
    piece.first += skipped;
    piece.count = std::min(piece.count - skipped, first_ + count_ - at);
    at += piece.count;
    append(result, std::move(piece));
  }
  return result;
}

SampleTrack SampleTrack::shifted(std::int64_t ticks) const {
  Table table = cut();
  for (Piece& piece : table) piece.shift += ticks;
  return SampleTrack(std::move(table));
}

SampleTrack SampleTrack::joined(const std::vector<SampleTrack>& parts) {
  Table table;
  for (const SampleTrack& part : parts) {
    for (Piece& piece : part.cut()) append(table, std::move(piece));
  }
  return SampleTrack(std::move(table));
}

SampleTrack SampleTrack::replaced(std::size_t first, std::size_t count, const SampleTrack& samples) const {
  return joined({slice(0, first), samples, slice(first + count, count_)});
}

std::size_t SampleTrack::lower_bound(std::int64_t tick_wanted) const {
  std::size_t low = 0;
  std::size_t high = count_;
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (tick(middle) < tick_wanted) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

std::uint64_t SampleTrack::hash() const {
  std::uint64_t total = 0;
  for (const Piece& piece : cut()) {
    const Powers of = powers(piece.count);
    const std::uint64_t before = piece.block->prefix(piece.first);
    std::uint64_t own = subtract(piece.block->prefix(piece.first + piece.count), multiply(before, of.power));
    own = add(own, multiply(multiply(kTickFactor, field_value(piece.shift)), of.sum));
    total = add(multiply(total, of.power), own);
  }
  // The length keeps tracks apart whose first samples have the value 0.
  return total ^ (static_cast<std::uint64_t>(count_) * 0x9E3779B97F4A7C15ULL);
}

std::vector<Sample> SampleTrack::to_vector() const {
  return {begin(), end()};
}

bool SampleTrack::same_pieces(const SampleTrack& other) const {
  if (count_ != other.count_) return false;
  if (table_ == other.table_ && first_ == other.first_) return true;
  const Table mine = cut();
  const Table theirs = other.cut();
  return std::equal(mine.begin(), mine.end(), theirs.begin(), theirs.end(), [](const Piece& a, const Piece& b) {
    return a.block == b.block && a.first == b.first && a.count == b.count && a.shift == b.shift;
  });
}

}  // namespace trocar::demonstration
