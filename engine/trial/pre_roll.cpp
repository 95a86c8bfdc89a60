#include "engine/trial/pre_roll.h"

#include <utility>

namespace trocar::trial {
namespace {

constexpr std::size_t kSamplesPerBlock = 50;
constexpr std::size_t kBlocks = 20;  // 5 s

}  // namespace

void PreRoll::add(const demonstration::Sample& sample, const simulation::World& world) {
  if (blocks_.empty() || blocks_.back().samples.size() == kSamplesPerBlock) {
    blocks_.push_back({world.snapshot().bytes, {}, {{sample.tick, world.state_hash()}}});
    if (blocks_.size() > kBlocks + 1) blocks_.pop_front();
  }
  blocks_.back().samples.push_back(sample);
}

double PreRoll::seconds() const {
  if (blocks_.empty()) return 0.0;
  return Tick{blocks_.back().samples.back().tick - blocks_.front().samples.front().tick}.seconds();
}

PreRoll::Kept PreRoll::take() {
  Kept kept;
  for (Block& block : blocks_) {
    if (kept.samples.empty()) kept.initial_world = std::move(block.world);
    kept.samples.insert(kept.samples.end(), block.samples.begin(), block.samples.end());
    kept.marks.insert(kept.marks.end(), block.marks.begin(), block.marks.end());
  }
  blocks_.clear();
  return kept;
}

}  // namespace trocar::trial
