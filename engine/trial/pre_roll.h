/// The last seconds before a recording begins, so that they can still be kept.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "engine/demonstration/recording.h"
#include "engine/simulation/world.h"

namespace trocar::trial {

/// Threads: one at a time. Keeps at least 5 s, where there are as many, and less than a quarter of a second more.
class PreRoll {
 public:
  /// Each 5 ticks, in order. `world` as it is at the sample.
  void add(const demonstration::Sample& sample, const simulation::World& world);
  double seconds() const;

  /// What it held, from the oldest on; it is empty then.
  struct Kept {
    std::string initial_world;  ///< As before the first sample.
    std::vector<demonstration::Sample> samples;
    std::vector<demonstration::HashMark> marks;
  };
  Kept take();

 private:
  /// A quarter of a second.
  struct Block {
    std::string world;
    std::vector<demonstration::Sample> samples;
    std::vector<demonstration::HashMark> marks;
  };
  std::deque<Block> blocks_;
};

}  // namespace trocar::trial
