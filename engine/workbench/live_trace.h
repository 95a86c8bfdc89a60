/// What a recording that goes on has of lanes over time: few points, however long it gets.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/demonstration/recording.h"

namespace trocar::workbench {

struct LivePoint {
  double t_s = 0.0;  ///< Since the first sample.
  std::array<float, 2> jaw_rad{};
  std::array<float, 2> speed_m_s{};
  std::uint32_t flags = 0;
  demonstration::Authority authority = demonstration::Authority::kOperator;
  demonstration::Segment segment = demonstration::Segment::kA;
};

struct LiveTrace {
  std::vector<LivePoint> points;  ///< By time; the last one is of the newest sample that was taken in.
};

/// Takes every n-th sample, and from each time that these are too many every 2n-th. Threads: one at a time.
class LiveTracer {
 public:
  static constexpr std::size_t kMost = 4096;

  void add(std::span<const demonstration::Sample> samples);
  /// Null before the first sample; the same one until there are more.
  std::shared_ptr<const LiveTrace> trace();

 private:
  void take(const demonstration::Sample& sample);

  std::vector<LivePoint> points_;
  std::shared_ptr<const LiveTrace> trace_;
  std::int64_t stride_ = 1;
  std::int64_t seen_ = 0;
  std::int64_t first_tick_ = 0;
  demonstration::Sample last_;  ///< That was taken.
};

}  // namespace trocar::workbench
