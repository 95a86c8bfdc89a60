#include "engine/review/clearance.h"

#include <algorithm>
#include <cstring>

#include "engine/core/hash.h"
#include "engine/review/sweep.h"

namespace trocar::review {
namespace {

using demonstration::Demonstration;
using demonstration::Sample;

constexpr std::size_t kLongestChunk = 512;
/// One sample in so many ends a chunk, by what it holds: after an edit, chunks begin where they began before.
constexpr std::uint64_t kUsualChunk = 128;

std::uint64_t mixed(std::uint64_t state, std::uint64_t word) {
  state = (state ^ word) * 0x9E3779B97F4A7C15ULL;
  return state ^ (state >> 29U);
}

/// Of all that a sample's review depends on: everything but when it is.
std::uint64_t content_of(const Sample& sample) {
  constexpr std::size_t kFirst = sizeof(sample.tick);
  constexpr std::size_t kWords = (offsetof(Sample, flags) - kFirst) / sizeof(std::uint64_t);
  static_assert(offsetof(Sample, flags) == kFirst + kWords * sizeof(std::uint64_t));
  std::array<std::uint64_t, kWords> words;
  std::memcpy(words.data(), reinterpret_cast<const std::byte*>(&sample) + kFirst, sizeof(words));
  std::array<std::uint64_t, 2> lanes{1, 2};
  for (std::size_t i = 0; i + 1 < kWords; i += 2) {
    lanes[0] = mixed(lanes[0], words[i]);
    lanes[1] = mixed(lanes[1], words[i + 1]);
  }
  if (kWords % 2 != 0) lanes[0] = mixed(lanes[0], words[kWords - 1]);
  return mixed(mixed(lanes[0], lanes[1]), sample.flags & (demonstration::kLeftHolds | demonstration::kRightHolds));
}

}  // namespace

double ToolReview::least_m() const {
  float least = nearest.front().distance_m;
  for (const Nearest& each : nearest) least = std::min(least, each.distance_m);
  return static_cast<double>(least);
}

const SampleReview& ClearanceCurve::operator[](std::size_t i) const {
  const auto after = std::upper_bound(starts_.begin(), starts_.end(), i);
  const auto chunk = static_cast<std::size_t>(after - starts_.begin()) - 1;
  return (*chunks_[chunk])[i - starts_[chunk]];
}

ClearanceCurve ClearanceMaker::make(const Demonstration& document) {
  ClearanceCurve curve;
  decltype(known_) used;
  worked_out_ = 0;
  std::vector<Sample> waiting;
  std::uint64_t content = 0;
  const auto finish = [&] {
    if (waiting.empty()) return;
    const std::uint64_t key = mixed(content, static_cast<std::uint64_t>(document.block) + 1);
    auto found = known_.find(key);
    std::shared_ptr<const ClearanceCurve::Chunk> chunk = found == known_.end() ? nullptr : found->second;
    if (!chunk) {
      Sweep sweep(document.block);
      auto made = std::make_shared<ClearanceCurve::Chunk>();
      made->reserve(waiting.size());
      for (const Sample& sample : waiting) made->push_back(sweep.next(sample));
      worked_out_ += waiting.size();
      chunk = std::move(made);
    }
    used[key] = chunk;
    curve.starts_.push_back(curve.size_);
    curve.size_ += chunk->size();
    curve.chunks_.push_back(std::move(chunk));
    waiting.clear();
    content = 0;
  };
  for (const Sample& sample : document.gated()) {
    const std::uint64_t of_sample = content_of(sample);
    waiting.push_back(sample);
    content = mixed(content, of_sample);
    if (of_sample % kUsualChunk == 0 || waiting.size() == kLongestChunk) finish();
  }
  finish();
  // What this version does not show is forgotten, so that the memory is that of one demonstration.
  known_ = std::move(used);
  return curve;
}

}  // namespace trocar::review
