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

ClearanceChunk::ClearanceChunk(const std::vector<SampleReview>& reviews) : size_(reviews.size()) {
  const auto far = [](const Nearest& nearest) { return nearest.distance_m >= Nearest().distance_m; };
  for (std::size_t arm = 0; arm < 2; ++arm) {
    for (std::size_t kind = 0; kind < kObstacleCount; ++kind) {
      const auto nearest = [&](const SampleReview& review) -> const Nearest& { return review[arm].nearest[kind]; };
      if (std::all_of(reviews.begin(), reviews.end(), [&](const auto& each) { return far(nearest(each)); })) continue;
      Column& column = columns_[arm][kind];
      column.distance_m.reserve(size_);
      column.which.reserve(size_);
      for (const SampleReview& review : reviews) {
        column.distance_m.push_back(nearest(review).distance_m);
        column.least_m = std::min(column.least_m, static_cast<double>(nearest(review).distance_m));
        column.which.push_back({nearest(review).part, nearest(review).index});
      }
      const Which first = column.which.front();
      if (std::all_of(column.which.begin(), column.which.end(), [&](const Which& each) { return each == first; })) {
        column.which = {first};
      }
    }
    const auto within = [arm](const SampleReview& review) {
      return review[arm].reachable && review[arm].excess.joint < 0;
    };
    if (std::all_of(reviews.begin(), reviews.end(), within)) continue;
    reach_[arm].reserve(size_);
    for (const SampleReview& review : reviews) reach_[arm].push_back({review[arm].excess, review[arm].reachable});
  }
  for (const SampleReview& review : reviews) {
    for (const ToolReview& tool : review) least_m_ = std::min(least_m_, tool.least_m());
  }
}

Nearest ClearanceChunk::nearest(std::size_t i, std::size_t arm, std::size_t kind) const {
  const Column& column = columns_[arm][kind];
  if (column.distance_m.empty()) return {};
  const Which& which = column.which.size() == 1 ? column.which.front() : column.which[i];
  return {column.distance_m[i], which.part, which.index};
}

SampleReview ClearanceChunk::operator[](std::size_t i) const {
  SampleReview review;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    for (std::size_t kind = 0; kind < kObstacleCount; ++kind) review[arm].nearest[kind] = nearest(i, arm, kind);
    if (reach_[arm].empty()) continue;
    review[arm].excess = reach_[arm][i].excess;
    review[arm].reachable = reach_[arm][i].reachable;
  }
  return review;
}

std::size_t ClearanceChunk::bytes() const {
  std::size_t bytes = sizeof(ClearanceChunk);
  for (std::size_t arm = 0; arm < 2; ++arm) {
    for (const Column& column : columns_[arm]) {
      bytes += column.distance_m.capacity() * sizeof(float) + column.which.capacity() * sizeof(Which);
    }
    bytes += reach_[arm].capacity() * sizeof(Reach);
  }
  return bytes;
}

SampleReview ClearanceCurve::operator[](std::size_t i) const {
  const std::size_t chunk = chunk_of(i);
  return (*chunks_[chunk])[i - starts_[chunk]];
}

Nearest ClearanceCurve::nearest(std::size_t i, std::size_t arm, std::size_t kind) const {
  const std::size_t chunk = chunk_of(i);
  return chunks_[chunk]->nearest(i - starts_[chunk], arm, kind);
}

std::size_t ClearanceCurve::chunk_of(std::size_t i) const {
  const auto after = std::upper_bound(starts_.begin(), starts_.end(), i);
  return static_cast<std::size_t>(after - starts_.begin()) - 1;
}

std::vector<std::size_t> ClearanceCurve::nearer_than(double below_m, std::size_t arm, std::size_t kind) const {
  // At the horizon nothing is known to be near.
  below_m = std::min(below_m, static_cast<double>(Nearest().distance_m));
  std::vector<std::size_t> found;
  for (std::size_t c = 0; c < chunks_.size(); ++c) {
    const ClearanceChunk& chunk = *chunks_[c];
    if (chunk.least_m(arm, kind) >= below_m) continue;
    for (std::size_t i = 0; i < chunk.size(); ++i) {
      if (static_cast<double>(chunk.nearest(i, arm, kind).distance_m) < below_m) found.push_back(starts_[c] + i);
    }
  }
  return found;
}

std::vector<std::size_t> ClearanceCurve::perhaps_beyond_reach(std::size_t arm) const {
  std::vector<std::size_t> found;
  for (std::size_t c = 0; c < chunks_.size(); ++c) {
    if (chunks_[c]->within_reach(arm)) continue;
    for (std::size_t i = 0; i < chunks_[c]->size(); ++i) found.push_back(starts_[c] + i);
  }
  return found;
}

double ClearanceCurve::least_m() const {
  double least_m = kHorizon_m;
  for (const auto& chunk : chunks_) least_m = std::min(least_m, chunk->least_m());
  return least_m;
}

std::shared_ptr<const ClearanceChunk> ClearanceStore::find(std::uint64_t key) {
  const std::scoped_lock lock(mutex_);
  if (const auto found = places_.find(key); found != places_.end()) {
    kept_.splice(kept_.begin(), kept_, found->second);
    return found->second->chunk;
  }
  const auto gone = let_go_.find(key);
  if (gone == let_go_.end()) return nullptr;
  std::shared_ptr<const ClearanceChunk> chunk = gone->second.lock();
  let_go_.erase(gone);
  if (chunk) add(key, chunk);
  return chunk;
}

void ClearanceStore::keep(std::uint64_t key, const std::shared_ptr<const ClearanceChunk>& chunk) {
  const std::scoped_lock lock(mutex_);
  if (!places_.contains(key)) add(key, chunk);
}

void ClearanceStore::add(std::uint64_t key, std::shared_ptr<const ClearanceChunk> chunk) {
  bytes_ += chunk->bytes();
  kept_.push_front({key, std::move(chunk)});
  places_[key] = kept_.begin();
  while (bytes_ > budget_bytes_) {
    const Kept& last = kept_.back();
    bytes_ -= last.chunk->bytes();
    let_go_[last.key] = last.chunk;
    places_.erase(last.key);
    kept_.pop_back();
  }
  if (let_go_.size() < swept_at_) return;
  std::erase_if(let_go_, [](const auto& each) { return each.second.expired(); });
  swept_at_ = std::max<std::size_t>(1024, 2 * let_go_.size());
}

std::size_t ClearanceStore::count() const {
  const std::scoped_lock lock(mutex_);
  return kept_.size();
}

std::size_t ClearanceStore::bytes() const {
  const std::scoped_lock lock(mutex_);
  return bytes_;
}

ClearanceCurve ClearanceMaker::make(const Demonstration& document) {
  ClearanceCurve curve;
  worked_out_ = 0;
  std::vector<Sample> waiting;
  std::vector<SampleReview> reviews;
  std::uint64_t content = 0;
  const auto finish = [&] {
    if (waiting.empty()) return;
    const std::uint64_t key = mixed(content, static_cast<std::uint64_t>(document.block) + 1);
    std::shared_ptr<const ClearanceChunk> chunk = store_->find(key);
    if (!chunk) {
      Sweep sweep(document.block);
      reviews.clear();
      for (const Sample& sample : waiting) reviews.push_back(sweep.next(sample));
      worked_out_ += waiting.size();
      chunk = std::make_shared<const ClearanceChunk>(reviews);
      store_->keep(key, chunk);
    }
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
  return curve;
}

}  // namespace trocar::review
