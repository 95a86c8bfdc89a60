#include "engine/demonstration/packed_samples.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

#include "engine/core/check.h"

namespace trocar::demonstration {
namespace {

/// Far above what a run takes, and large enough that the system takes it back when it is given up.
constexpr std::size_t kSlab_bytes = std::size_t{1} << 19U;
/// A word is read whole also where fewer of its bytes are kept.
constexpr std::size_t kSlack_bytes = sizeof(std::uint64_t);

/// The lowest `count` bytes, 1 … 8.
std::uint64_t low_bytes(std::size_t count) {
  return ~std::uint64_t{0} >> (8 * (sizeof(std::uint64_t) - count));
}

template <typename T>
T read_at(const std::byte* at) {
  static_assert(std::is_trivially_copyable_v<T>);
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

template <typename T>
std::byte* write_at(std::byte* at, const T& value, std::size_t bytes = sizeof(T)) {
  std::memcpy(at, &value, bytes);
  return at + bytes;
}

}  // namespace

PackedSamples::PackedSamples(std::span<const Sample> samples) {
  for (const Sample& sample : samples) add(sample);
  finish();
}

void PackedSamples::add(const Sample& sample) {
  open_.push_back(sample);
  ++count_;
  if (open_.size() == kRun) pack();
}

void PackedSamples::finish() {
  if (!open_.empty()) pack();
  open_.shrink_to_fit();
  runs_.shrink_to_fit();
  if (slabs_.empty()) return;
  Slab& last = slabs_.back();
  const std::size_t room = last.used + kSlack_bytes;
  if (room >= last.room) return;
  auto exact = std::make_unique<std::byte[]>(room);
  std::copy_n(last.bytes.get(), last.used, exact.get());
  for (auto run = runs_.rbegin(); run != runs_.rend(); ++run) {
    const std::ptrdiff_t place = *run - last.bytes.get();
    if (place < 0 || place >= static_cast<std::ptrdiff_t>(last.used)) break;
    *run = exact.get() + place;
  }
  last = {std::move(exact), last.used, room};
}

std::byte* PackedSamples::reserve(std::size_t bytes) {
  if (slabs_.empty() || slabs_.back().room - slabs_.back().used < bytes + kSlack_bytes) {
    slabs_.push_back({std::make_unique<std::byte[]>(kSlab_bytes), 0, kSlab_bytes});
  }
  Slab& slab = slabs_.back();
  std::byte* begin = slab.bytes.get() + slab.used;
  slab.used += bytes;
  return begin;
}

void PackedSamples::pack() {
  const std::size_t count = open_.size();
  std::array<std::array<Word, kWords>, kRun> words;
  std::memcpy(words.data(), open_.data(), count * sizeof(Sample));
  Head head;
  head.first = words[0];
  std::array<Word, kWords> differs{};
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t k = 0; k < kWords; ++k) differs[k] |= words[i][k] ^ head.first[k];
  }
  std::array<Varying, kWords> varying;
  for (std::size_t k = 0; k < kWords; ++k) {
    if (differs[k] == 0) continue;
    const auto first = static_cast<std::size_t>(std::countr_zero(differs[k])) / 8;
    const std::size_t end = sizeof(Word) - static_cast<std::size_t>(std::countl_zero(differs[k])) / 8;
    varying[head.varying++] = {static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(first),
                               static_cast<std::uint8_t>(end - first)};
    head.row_bytes = static_cast<std::uint16_t>(head.row_bytes + end - first);
  }
  std::byte* out = reserve(sizeof head + head.varying * sizeof(Varying) + head.row_bytes * (count - 1));
  runs_.push_back(out);
  out = write_at(out, head);
  for (std::size_t k = 0; k < head.varying; ++k) out = write_at(out, varying[k]);
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t k = 0; k < head.varying; ++k) {
      const Varying& of = varying[k];
      out = write_at(out, (words[i][of.word] ^ head.first[of.word]) >> (8U * of.first), of.count);
    }
  }
  open_.clear();
}

Sample PackedSamples::at(std::size_t i) const {
  const std::byte* run = runs_[i / kRun];
  Sample sample;
  auto* bytes = reinterpret_cast<std::byte*>(&sample);
  std::memcpy(bytes, run, sizeof sample);
  const std::size_t place = i % kRun;
  if (place == 0) return sample;
  const std::size_t count = read_at<std::uint16_t>(run + offsetof(Head, varying));
  const std::size_t row_bytes = read_at<std::uint16_t>(run + offsetof(Head, row_bytes));
  const std::byte* varying = run + sizeof(Head);
  const std::byte* row = varying + count * sizeof(Varying) + row_bytes * (place - 1);
  for (std::size_t k = 0; k < count; ++k) {
    const auto of = read_at<Varying>(varying + k * sizeof(Varying));
    std::byte* word = bytes + of.word * sizeof(Word);
    // From the first sample in the run, not from what was just written: that would wait for it.
    const auto first = read_at<Word>(run + of.word * sizeof(Word));
    write_at(word, first ^ ((read_at<Word>(row) & low_bytes(of.count)) << (8U * of.first)));
    row += of.count;
  }
  return sample;
}

std::int64_t PackedSamples::tick(std::size_t i) const {
  static_assert(offsetof(Sample, tick) == 0);
  const std::byte* run = runs_[i / kRun];
  auto word = read_at<Word>(run);
  const std::size_t place = i % kRun;
  const auto varying = read_at<std::uint16_t>(run + offsetof(Head, varying));
  if (place != 0 && varying != 0) {
    const auto of = read_at<Varying>(run + sizeof(Head));
    const auto row_bytes = read_at<std::uint16_t>(run + offsetof(Head, row_bytes));
    const std::byte* row = run + sizeof(Head) + varying * sizeof(Varying) + row_bytes * (place - 1);
    if (of.word == 0) word ^= (read_at<Word>(row) & low_bytes(of.count)) << (8U * of.first);
  }
  return static_cast<std::int64_t>(word);
}

std::size_t PackedSamples::bytes() const {
  std::size_t bytes = 0;
  for (const Slab& slab : slabs_) bytes += slab.room;
  return bytes + runs_.capacity() * sizeof(const std::byte*) + open_.capacity() * sizeof(Sample);
}

}  // namespace trocar::demonstration
