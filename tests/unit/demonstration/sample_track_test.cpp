#include "engine/demonstration/sample_track.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cstring>

#include "engine/core/random.h"
#include "tests/support/document_samples.h"

using namespace trocar;
using namespace trocar::demonstration;

namespace {

std::vector<Sample> samples_of(int count) {
  return testing::moving_recording(count).samples;
}

bool same(const SampleTrack& track, const std::vector<Sample>& expected) {
  const std::vector<Sample> all = track.to_vector();
  return all.size() == expected.size() && std::memcmp(all.data(), expected.data(), all.size() * sizeof(Sample)) == 0;
}

}  // namespace

TEST_CASE("any cutting, joining, shifting and replacing does what it does to a plain vector") {
  CHECK(rc::check([](std::uint64_t seed) {
    Random random(seed);
    std::vector<Sample> plain = samples_of(60);
    SampleTrack track(plain);
    for (int round = 0; round < 12; ++round) {
      const auto first = random.below(static_cast<std::uint32_t>(plain.size()));
      const auto count = random.below(static_cast<std::uint32_t>(plain.size() - first)) / 2;
      const auto begin = plain.begin() + first;
      if (random.below(2) == 0) {
        std::vector<Sample> other(begin, begin + count);
        for (Sample& sample : other) sample.flags += 16;
        std::copy(other.begin(), other.end(), begin);
        track = track.replaced(first, count, SampleTrack(other));
      } else {
        const std::int64_t shift = 5 * std::int64_t{random.below(100)};
        for (auto it = begin + count; it != plain.end(); ++it) it->tick += shift;
        plain.erase(begin, begin + count);
        track = SampleTrack::joined({track.slice(0, first), track.slice(first + count, track.size()).shifted(shift)});
      }
      RC_ASSERT(same(track, plain));
      // The same content hashes the same, however it came about.
      RC_ASSERT(track.hash() == SampleTrack(plain).hash());
      if (plain.size() < 4) break;
    }
  }));
}

TEST_CASE("one bit of one sample, one tick, and the order of two samples change the hash") {
  const std::vector<Sample> plain = samples_of(40);
  const std::uint64_t hash = SampleTrack(plain).hash();
  std::vector<Sample> other = plain;
  other[17].arms[1].joints[5] = std::nextafter(other[17].arms[1].joints[5], 1.0F);
  CHECK(SampleTrack(other).hash() != hash);
  other = plain;
  other[17].tick += 1;
  CHECK(SampleTrack(other).hash() != hash);
  other = plain;
  std::swap(other[3].flags, other[4].flags);
  std::swap(other[3].arms, other[4].arms);
  CHECK(SampleTrack(other).hash() != hash);
  CHECK(SampleTrack(plain).shifted(5).hash() != hash);
  CHECK(SampleTrack(plain).slice(0, 39).hash() != hash);
}

TEST_CASE("a slice and a shift share the samples of their track") {
  const SampleTrack track(samples_of(1000));
  CHECK(track.slice(0, 1000).same_pieces(track));
  CHECK(SampleTrack::joined({track.slice(0, 500), track.slice(500, 500)}).same_pieces(track));
  CHECK_FALSE(track.shifted(5).same_pieces(track));
  CHECK(track.shifted(5).shifted(-5).same_pieces(track));
}

TEST_CASE("the first sample at or after a tick is found across pieces") {
  const SampleTrack track(samples_of(10));
  const SampleTrack gap = SampleTrack::joined({track.slice(0, 5), track.slice(5, 5).shifted(100)});
  CHECK(gap.lower_bound(-1) == 0);
  CHECK(gap.lower_bound(20) == 4);
  CHECK(gap.lower_bound(21) == 5);
  CHECK(gap.lower_bound(125) == 5);
  CHECK(gap.lower_bound(1000) == 10);
}
