#include "engine/trial/eyes.h"

#include <algorithm>
#include <cmath>

#include "engine/demonstration/recording.h"

namespace trocar::trial {
namespace {

constexpr std::size_t kSpeedSamples = 10;

}  // namespace

Eyes::Eyes(int block, double delay_s)
    : block_(block),
      delay_(static_cast<std::size_t>(std::lround(delay_s * demonstration::kSampleRate_hz))),
      ring_(delay_ + kSpeedSamples + 1) {}

const Glimpse& Eyes::look(const simulation::WorldState& present) {
  newest_ = (newest_ + 1) % ring_.size();
  ++seen_;
  Glimpse& now = ring_[newest_];
  for (std::size_t i = 0; i < 2; ++i) {
    now.X_WT[i] = present.arms[i].X_WT;
    now.jaw_rad[i] = present.arms[i].jaw_rad;
  }
  now.block = present.blocks[static_cast<std::size_t>(block_)];
  return ago(delay_);
}

const Glimpse& Eyes::ago(std::size_t samples) const {
  const std::size_t back = std::min(samples, seen_ - 1);
  return ring_[(newest_ + ring_.size() - back) % ring_.size()];
}

double Eyes::tool_speed_m_s(kinematics::ArmSide side) const {
  const double span_s = static_cast<double>(kSpeedSamples) / demonstration::kSampleRate_hz;
  return (ago(delay_).tool(side).p - ago(delay_ + kSpeedSamples).tool(side).p).norm() / span_s;
}

}  // namespace trocar::trial
