#include "ui/panels/lane_data.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/demonstration/motion.h"
#include "engine/demonstration/sampling_rate.h"

namespace trocar::ui {
namespace {

using demonstration::Sample;

// `state_of` gives 0 for what is not drawn.
template <typename StateOf>
std::vector<Run> runs(const demonstration::Demonstration& shown, StateOf state_of) {
  std::vector<Run> list;
  int state = 0;
  for (const Sample& sample : shown.samples) {
    const double t_s = shown.time_of(sample);
    const int now = state_of(sample);
    if (!list.empty() && state != 0) list.back().end_s = t_s;
    if (now != state && now != 0) list.push_back({t_s, t_s, now});
    state = now;
  }
  return list;
}

}  // namespace

const std::vector<Run>& LaneData::flag(demonstration::SampleFlag flag) const {
  return flags_[static_cast<std::size_t>(std::countr_zero(static_cast<std::uint32_t>(flag)))];
}

void LaneData::find_runs(const demonstration::Demonstration& shown) {
  authority_ = runs(shown, [](const Sample& sample) { return 1 + static_cast<int>(sample.authority); });
  for (std::size_t bit = 0; bit < flags_.size(); ++bit) {
    flags_[bit] = runs(shown, [bit](const Sample& sample) { return static_cast<int>(sample.flags >> bit & 1U); });
  }
  events_ = demonstration::events_within(shown, 0.0, shown.full_duration_s());
  std::erase_if(events_, [](const demonstration::Event& event) { return event.arm < 0; });
  gaps_.clear();
  jaw_low_ = 0.0F;
  jaw_high_ = 0.1F;
  for (const demonstration::SampleGap& gap : demonstration::sample_gaps(shown.samples)) {
    const auto time_s = [&](std::size_t i) { return Tick{shown.samples.tick(i) - shown.first_tick()}.seconds(); };
    const double begin_s = time_s(gap.after - 1);
    const double end_s = time_s(gap.after);
    if (end_s - begin_s > demonstration::kMotionGap_s) gaps_.push_back({begin_s, end_s, 1});
  }
  for (const Sample& sample : shown.samples) {
    for (const auto& arm : sample.arms) {
      jaw_low_ = std::min(jaw_low_, arm.jaw_rad);
      jaw_high_ = std::max(jaw_high_, arm.jaw_rad);
    }
  }
}

void LaneData::decimate(const demonstration::Demonstration& shown, const TimeRange& range, int columns) {
  for (auto& lane : jaw_) lane.assign(static_cast<std::size_t>(columns), Extent{1.0F, -1.0F});
  const demonstration::SampleTrack seen = shown.samples_within(range.begin_s - 0.02, range.end_s);
  for (const Sample& sample : seen) {
    const double place = (shown.time_of(sample) - range.begin_s) / range.span_s() * columns;
    if (place >= columns) break;
    if (place < 0.0) continue;
    const auto column = static_cast<std::size_t>(place);
    for (std::size_t arm = 0; arm < 2; ++arm) {
      Extent& extent = jaw_[arm][column];
      const float value = sample.arms[arm].jaw_rad;
      extent = extent.low > extent.high ? Extent{value, value}
                                        : Extent{std::min(extent.low, value), std::max(extent.high, value)};
    }
  }
}

void LaneData::update(const demonstration::Demonstration& shown, const TimeRange& range, int columns) {
  if (stack_ != shown.stack) {
    stack_ = shown.stack;
    edits_ = demonstration::edit_spans(shown);
  }
  if (recording_ != shown.recording) {
    recording_ = shown.recording;
    const demonstration::Demonstration original = demonstration::original_of(shown);
    original_ = original.segments;
    original_s_ = original.end_s;
  }
  const bool same_samples = samples_.same_pieces(shown.samples);
  if (!same_samples) {
    samples_ = shown.samples;
    find_runs(shown);
  }
  const bool same_range = range_.begin_s == range.begin_s && range_.end_s == range.end_s && columns_ == columns;
  if (same_samples && same_range) return;
  range_ = range;
  columns_ = columns;
  decimate(shown, range, columns);
}

}  // namespace trocar::ui
