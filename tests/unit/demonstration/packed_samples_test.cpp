#include "engine/demonstration/packed_samples.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cstring>

#include "engine/core/random.h"
#include "tests/support/document_samples.h"

using namespace trocar;
using namespace trocar::demonstration;

namespace {

bool same(const Sample& a, const Sample& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Samples in which any bits may differ from one to the next, or none.
std::vector<Sample> any_samples(Random& random, std::size_t count) {
  std::vector<Sample> samples;
  Sample sample = testing::moving_sample(1);
  for (std::size_t i = 0; i < count; ++i) {
    sample.tick += 1 + random.below(70000);
    for (std::uint32_t change = random.below(12); change > 0; --change) {
      const std::size_t at = sizeof sample.tick + random.below(sizeof(Sample) - sizeof sample.tick);
      const auto byte = static_cast<unsigned char>(random.below(256));
      std::memcpy(reinterpret_cast<unsigned char*>(&sample) + at, &byte, 1);
    }
    samples.push_back(sample);
  }
  return samples;
}

}  // namespace

TEST_CASE("samples come out as they went in, to the bit, whatever is in them and however many there are") {
  CHECK(rc::check([](std::uint64_t seed) {
    Random random(seed);
    const std::vector<Sample> samples = any_samples(random, random.below(140));
    const PackedSamples packed(samples);
    RC_ASSERT(packed.size() == samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      RC_ASSERT(same(packed.at(i), samples[i]));
      RC_ASSERT(packed.tick(i) == samples[i].tick);
    }
  }));
}

TEST_CASE("what goes on over many slabs is all there") {
  // Of samples without anything in common a slab holds about 1,200.
  Random random(7);
  std::vector<Sample> samples = any_samples(random, 4000);
  for (Sample& sample : samples) {
    for (CompactPose& block : sample.blocks) {
      for (float& part : block.p) part = static_cast<float>(random.uniform());
      for (float& part : block.q_wxyz) part = static_cast<float>(random.uniform());
    }
  }
  const PackedSamples packed(samples);
  REQUIRE(packed.size() == samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) REQUIRE(same(packed.at(i), samples[i]));
}

TEST_CASE("a smooth motion of which the blocks stand still takes less than half of its room") {
  const std::vector<Sample> samples = testing::moving_recording(4000).samples;
  const PackedSamples packed(samples);
  CHECK(packed.bytes() < samples.size() * sizeof(Sample) / 2);
}
