#include "engine/demonstration/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "engine/core/hash.h"

namespace trocar::demonstration {
namespace {

// Chunks are stored as samples are in memory, so their layout is the file's.
static_assert(std::is_trivially_copyable_v<Sample> && sizeof(Sample) == 424);
static_assert(std::endian::native == std::endian::little);

/// Far beyond any recording (31 years), and safe to subtract and to turn into a double.
constexpr std::int64_t kLastTick = 1'000'000'000'000;

/// Infinity and NaN times zero are NaN, so one sum tells whether all numbers are finite, without a branch for each.
template <typename Numbers>
double poison(const Numbers& numbers) {
  double sum = 0.0;
  for (const auto number : numbers) sum += static_cast<double>(number) * 0.0;
  return sum;
}

double poison(const CompactPose& pose) {
  return poison(pose.p) + poison(pose.q_wxyz);
}

void add(Hasher& hasher, const Provenance& provenance) {
  hasher.text(provenance.operator_kind).text(provenance.skill).text(provenance.device).value(provenance.seed);
  hasher.value(provenance.block).value(provenance.goal).text(provenance.scene_hash);
  hasher.text(provenance.software);  // not `created`: the same run on another day is the same recording
}

}  // namespace

CompactPose CompactPose::from(const spatial::Pose& pose) {
  CompactPose compact;
  for (std::size_t i = 0; i < 3; ++i) compact.p[i] = static_cast<float>(pose.p[static_cast<Eigen::Index>(i)]);
  compact.q_wxyz = {static_cast<float>(pose.q.w()), static_cast<float>(pose.q.x()), static_cast<float>(pose.q.y()),
                    static_cast<float>(pose.q.z())};
  return compact;
}

spatial::Pose CompactPose::pose() const {
  const Eigen::Quaterniond q(static_cast<double>(q_wxyz[0]), static_cast<double>(q_wxyz[1]),
                             static_cast<double>(q_wxyz[2]), static_cast<double>(q_wxyz[3]));
  return {{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])}, q.normalized()};
}

spatial::Pose ArmSample::setpoint() const {
  return {{setpoint_p[0], setpoint_p[1], setpoint_p[2]},
          {setpoint_q_wxyz[0], setpoint_q_wxyz[1], setpoint_q_wxyz[2], setpoint_q_wxyz[3]}};
}

void ArmSample::set_setpoint(const spatial::Pose& X_WT, double jaw_rad_in) {
  setpoint_p = {X_WT.p.x(), X_WT.p.y(), X_WT.p.z()};
  setpoint_q_wxyz = {X_WT.q.w(), X_WT.q.x(), X_WT.q.y(), X_WT.q.z()};
  setpoint_jaw_rad = jaw_rad_in;
}

char letter(Segment segment) {
  return static_cast<char>('A' + static_cast<int>(segment));
}

std::string_view to_string(Authority authority) {
  switch (authority) {
    case Authority::kOperator:
      return "operator";
    case Authority::kAgent:
      return "agent";
    case Authority::kAssistant:
      return "assistant";
    case Authority::kHold:
      return "hold";
  }
  return "unknown";
}

std::string_view to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::kUnfinished:
      return "unfinished";
    case Outcome::kSuccess:
      return "success";
    case Outcome::kDropped:
      return "dropped";
    case Outcome::kAborted:
      return "aborted";
    case Outcome::kFault:
      return "fault";
    case Outcome::kUnknown:
      return "unknown";
  }
  return "unknown";
}

void SampleHasher::add(const Sample& sample) {
  constexpr std::size_t kWords = sizeof(Sample) / sizeof(std::uint64_t);
  static_assert(kWords * sizeof(std::uint64_t) == sizeof(Sample));
  // Independent lanes of whole words: several times as fast as byte by byte, which an hour of samples needs.
  std::array<std::uint64_t, kWords> words;
  std::memcpy(words.data(), &sample, sizeof(Sample));
  for (std::size_t i = 0; i < kWords; ++i) {
    std::uint64_t& lane = lanes_[i % lanes_.size()];
    lane = std::rotl(lane ^ words[i], 29) * 0x9FB21C651E98DF25ULL;
  }
  ++count_;
}

std::uint64_t SampleHasher::digest() const {
  Hasher hasher;
  hasher.value(count_);
  for (const std::uint64_t lane : lanes_) hasher.value(lane);
  return hasher.digest();
}

std::uint64_t hash_of(std::span<const Sample> samples) {
  SampleHasher hasher;
  for (const Sample& sample : samples) hasher.add(sample);
  return hasher.digest();
}

bool is_finite(const Sample& sample) {
  double sum = 0.0;
  for (const ArmSample& arm : sample.arms) {
    sum += poison(arm.setpoint_p) + poison(arm.setpoint_q_wxyz) + arm.setpoint_jaw_rad * 0.0;
    sum += poison(arm.measured) + static_cast<double>(arm.jaw_rad) * 0.0 + poison(arm.joints);
  }
  for (const CompactPose& block : sample.blocks) sum += poison(block);
  return sum == 0.0;
}

Status check_samples(std::span<const Sample> samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    if (!is_finite(sample)) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("sample {} has a number that is not finite", i + 1));
    }
    if (sample.tick < 0 || sample.tick > kLastTick) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("sample {} has a time out of range", i + 1));
    }
    if (i > 0 && sample.tick <= samples[i - 1].tick) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("sample {} is not later than the one before it", i + 1));
    }
    if (static_cast<int>(sample.segment) >= kSegmentCount || sample.authority > Authority::kHold) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("sample {} has an unknown label", i + 1));
    }
  }
  return {};
}

std::uint64_t content_hash(std::uint64_t samples_hash, const Provenance& provenance, std::string_view initial_world,
                           std::span<const HashMark> hashes) {
  Hasher hasher;
  hasher.value(samples_hash);
  add(hasher, provenance);
  hasher.text(initial_world).value(hashes.size());
  for (const HashMark& mark : hashes) hasher.value(mark.tick).value(mark.hash);
  return hasher.digest();
}

std::uint64_t Recording::content_hash() const {
  return demonstration::content_hash(hash_of(samples), provenance, initial_world, hashes);
}

}  // namespace trocar::demonstration
