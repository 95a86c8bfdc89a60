#include "ui/panels/lane_data.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "engine/demonstration/motion.h"
#include "engine/workbench/latest_worker.h"

namespace trocar::ui {
namespace {

using demonstration::Demonstration;
using demonstration::Sample;

constexpr std::size_t kStretch_samples = 64;

/// Gathers neighbours in one state into runs; state 0 is not drawn.
class RunWriter {
 public:
  void add(double t_s, int state) {
    if (!runs_.empty() && state_ != 0) runs_.back().end_s = t_s;
    if (state != state_ && state != 0) runs_.push_back({t_s, t_s, state});
    state_ = state;
  }
  std::vector<Run> take() { return std::move(runs_); }

 private:
  std::vector<Run> runs_;
  int state_ = 0;
};

void widen(Extent& extent, const Extent& by) {
  if (by.low > by.high) return;
  extent = extent.low > extent.high ? by : Extent{std::min(extent.low, by.low), std::max(extent.high, by.high)};
}

std::array<Extent, 2> jaws_of(const Sample& sample) {
  return {Extent{sample.arms[0].jaw_rad, sample.arms[0].jaw_rad},
          Extent{sample.arms[1].jaw_rad, sample.arms[1].jaw_rad}};
}

}  // namespace

LaneRuns lane_runs(const Demonstration& shown) {
  LaneRuns lanes;
  RunWriter authority;
  std::array<RunWriter, 4> flags;
  double last_s = shown.samples.empty() ? 0.0 : shown.time_of(shown.samples[0]);
  const bool is_long = shown.samples.size() > kLanesAtOnce_samples;
  std::size_t count = 0;
  for (const Sample& sample : shown.samples) {
    const double now_s = shown.time_of(sample);
    authority.add(now_s, 1 + static_cast<int>(sample.authority));
    for (std::size_t bit = 0; bit < flags.size(); ++bit) {
      flags[bit].add(now_s, static_cast<int>(sample.flags >> bit & 1U));
    }
    if (now_s - last_s > demonstration::kMotionGap_s) lanes.gaps.push_back({last_s, now_s, 1});
    last_s = now_s;
    const std::array<Extent, 2> jaws = jaws_of(sample);
    for (const Extent& jaw : jaws) {
      lanes.jaw_low = std::min(lanes.jaw_low, jaw.low);
      lanes.jaw_high = std::max(lanes.jaw_high, jaw.high);
    }
    if (!is_long) continue;
    if (count++ % kStretch_samples == 0) lanes.stretches.push_back({now_s, now_s, jaws});
    LaneRuns::Stretch& stretch = lanes.stretches.back();
    stretch.end_s = now_s;
    for (std::size_t arm = 0; arm < 2; ++arm) widen(stretch.jaw[arm], jaws[arm]);
  }
  lanes.authority = authority.take();
  for (std::size_t bit = 0; bit < flags.size(); ++bit) lanes.flags[bit] = flags[bit].take();
  lanes.events = demonstration::events_within(shown, 0.0, shown.full_duration_s());
  std::erase_if(lanes.events, [](const demonstration::Event& event) { return event.arm < 0; });
  return lanes;
}

/// What was asked for, and what came of it.
struct MadeLanes {
  std::uint64_t hash = 0;
  std::shared_ptr<const LaneRuns> runs;
};

/// Of a demonstration by value, which shares its samples.
class LaneData::Worker : public workbench::LatestWorker<std::shared_ptr<const Demonstration>, MadeLanes> {
 public:
  Worker() : LatestWorker([] { return &Worker::made; }) {}

 private:
  static MadeLanes made(const std::shared_ptr<const Demonstration>& shown) {
    return {shown->samples.hash(), std::make_shared<const LaneRuns>(lane_runs(*shown))};
  }
};

LaneData::LaneData() = default;
LaneData::~LaneData() = default;

bool LaneData::pending() const {
  return worker_ && worker_->pending();
}

const std::vector<Run>& LaneData::flag(demonstration::SampleFlag flag) const {
  return runs_->flags[static_cast<std::size_t>(std::countr_zero(static_cast<std::uint32_t>(flag)))];
}

void LaneData::keep(std::uint64_t hash, Runs runs) {
  runs_ = std::move(runs);
  std::erase_if(kept_, [hash](const auto& each) { return each.first == hash; });
  kept_.emplace_front(hash, runs_);
  if (kept_.size() > kKeptLanes) kept_.pop_back();
}

bool LaneData::follow(const Demonstration& shown) {
  bool changed = false;
  if (!samples_.same_pieces(shown.samples)) {
    samples_ = shown.samples;
    const std::uint64_t hash = shown.samples.hash();
    const auto known =
        std::find_if(kept_.begin(), kept_.end(), [hash](const auto& each) { return each.first == hash; });
    changed = true;
    if (known != kept_.end()) {
      keep(hash, known->second);
    } else if (shown.samples.size() <= kLanesAtOnce_samples) {
      keep(hash, std::make_shared<const LaneRuns>(lane_runs(shown)));
    } else {
      if (!worker_) worker_ = std::make_unique<Worker>();
      worker_->request(std::make_shared<const Demonstration>(shown));
    }
  }
  if (!worker_ || !worker_->update()) return changed;
  const MadeLanes& made = worker_->answer();
  // An answer may be of what is no longer shown.
  if (made.hash != samples_.hash()) return changed;
  keep(made.hash, made.runs);
  return true;
}

void LaneData::widen(const TimeRange& range, double t_s, const std::array<Extent, 2>& by) {
  const double place = (t_s - range.begin_s) / range.span_s() * columns_;
  if (place < 0.0 || place >= columns_) return;
  for (std::size_t arm = 0; arm < 2; ++arm) ui::widen(jaw_[arm][static_cast<std::size_t>(place)], by[arm]);
}

void LaneData::decimate(const Demonstration& shown, const TimeRange& range, int columns) {
  for (auto& lane : jaw_) lane.assign(static_cast<std::size_t>(columns), Extent{1.0F, -1.0F});
  const demonstration::SampleTrack seen = shown.samples_within(range.begin_s - 0.02, range.end_s);
  if (seen.size() <= kLanesAtOnce_samples) {
    for (const Sample& sample : seen) widen(range, shown.time_of(sample), jaws_of(sample));
    return;
  }
  // Each of the columns holds many stretches, or most of one.
  for (const LaneRuns::Stretch& stretch : runs_->stretches) {
    widen(range, stretch.begin_s, stretch.jaw);
    widen(range, stretch.end_s, stretch.jaw);
  }
}

void LaneData::update(const Demonstration& shown, const TimeRange& range, int columns) {
  if (stack_ != shown.stack) {
    stack_ = shown.stack;
    edits_ = demonstration::edit_spans(shown);
  }
  if (recording_ != shown.recording) {
    recording_ = shown.recording;
    const Demonstration original = demonstration::original_of(shown);
    original_ = original.segments;
    original_s_ = original.end_s;
  }
  const bool changed = follow(shown);
  const bool same_range = range_.begin_s == range.begin_s && range_.end_s == range.end_s && columns_ == columns;
  if (!changed && same_range) return;
  range_ = range;
  columns_ = columns;
  decimate(shown, range, columns);
}

}  // namespace trocar::ui
