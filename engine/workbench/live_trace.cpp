#include "engine/workbench/live_trace.h"

#include <cmath>

namespace trocar::workbench {
namespace {

float distance_m(const demonstration::ArmSample& from, const demonstration::ArmSample& to) {
  float squared = 0.0F;
  for (std::size_t i = 0; i < 3; ++i) {
    const float by = to.measured.p[i] - from.measured.p[i];
    squared += by * by;
  }
  return std::sqrt(squared);
}

}  // namespace

void LiveTracer::take(const demonstration::Sample& sample) {
  LivePoint point;
  point.t_s = Tick{sample.tick - first_tick_}.seconds();
  const auto passed_s = static_cast<float>(Tick{sample.tick - last_.tick}.seconds());
  for (std::size_t arm = 0; arm < 2; ++arm) {
    point.jaw_rad[arm] = sample.arms[arm].jaw_rad;
    if (points_.empty() || passed_s <= 0.0F) continue;
    point.speed_m_s[arm] = distance_m(last_.arms[arm], sample.arms[arm]) / passed_s;
  }
  point.flags = sample.flags;
  point.authority = sample.authority;
  point.segment = sample.segment;
  points_.push_back(point);
  last_ = sample;
}

void LiveTracer::add(std::span<const demonstration::Sample> samples) {
  for (const demonstration::Sample& sample : samples) {
    if (seen_ == 0) first_tick_ = sample.tick;
    if (seen_++ % stride_ != 0) continue;
    take(sample);
    trace_.reset();
    if (points_.size() < kMost) continue;
    for (std::size_t i = 0; 2 * i < points_.size(); ++i) points_[i] = points_[2 * i];
    points_.resize((points_.size() + 1) / 2);
    stride_ *= 2;
  }
}

std::shared_ptr<const LiveTrace> LiveTracer::trace() {
  if (!trace_ && !points_.empty()) trace_ = std::make_shared<const LiveTrace>(LiveTrace{points_});
  return trace_;
}

}  // namespace trocar::workbench
