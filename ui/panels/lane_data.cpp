#include "ui/panels/lane_data.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <utility>

#include "engine/demonstration/motion.h"
#include "engine/demonstration/sampling_rate.h"
#include "engine/spatial/grid.h"
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

std::array<float, 2> jaws_of(const Sample& sample) {
  return {sample.arms[0].jaw_rad, sample.arms[1].jaw_rad};
}

std::vector<Run> gaps_of(const Demonstration& shown) {
  std::vector<Run> gaps;
  const auto time_s = [&](std::size_t i) { return Tick{shown.samples.tick(i) - shown.first_tick()}.seconds(); };
  for (const demonstration::SampleGap& gap : demonstration::sample_gaps(shown.samples)) {
    const double begin_s = time_s(gap.after - 1);
    const double end_s = time_s(gap.after);
    if (end_s - begin_s > demonstration::kMotionGap_s) gaps.push_back({begin_s, end_s, 1});
  }
  return gaps;
}

/// Counts the left tool's steps from cell to cell. From a place that was counted it must get a whole cell away along an
/// axis: what trembles about a face of a cell makes no steps.
class GridSteps {
 public:
  void add(double t_s, const Eigen::Vector3d& p_WT) {
    if (!begun_) counted_ = p_WT;
    begun_ = true;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      // Half a micrometre less: a tool that steps by exactly one cell has done so.
      while (std::abs(p_WT[axis] - counted_[axis]) >= cell_m_ - 5e-7) {
        counted_[axis] += std::copysign(cell_m_, p_WT[axis] - counted_[axis]);
        steps_.push_back(t_s);
      }
    }
  }
  std::vector<double> take() { return std::move(steps_); }

 private:
  double cell_m_ = spatial::Grid{}.cell_m;
  bool begun_ = false;
  Eigen::Vector3d counted_ = Eigen::Vector3d::Zero();
  std::vector<double> steps_;
};

}  // namespace

LaneRuns lane_runs(const Demonstration& shown) {
  LaneRuns lanes;
  RunWriter authority;
  std::array<RunWriter, 4> flags;
  GridSteps steps;
  const bool is_long = shown.samples.size() > kLanesAtOnce_samples;
  std::size_t count = 0;
  for (const Sample& sample : shown.samples) {
    const double now_s = shown.time_of(sample);
    authority.add(now_s, 1 + static_cast<int>(sample.authority));
    for (std::size_t bit = 0; bit < flags.size(); ++bit) {
      flags[bit].add(now_s, static_cast<int>(sample.flags >> bit & 1U));
    }
    steps.add(now_s, demonstration::measured_tip(sample, 0));
    const std::array<float, 2> jaws = jaws_of(sample);
    for (const float jaw : jaws) {
      lanes.jaw_low = std::min(lanes.jaw_low, jaw);
      lanes.jaw_high = std::max(lanes.jaw_high, jaw);
    }
    if (!is_long) continue;
    if (count++ % kStretch_samples == 0) {
      lanes.stretches.push_back({now_s, now_s, {Extent{jaws[0], jaws[0]}, Extent{jaws[1], jaws[1]}}});
    }
    LaneRuns::Stretch& stretch = lanes.stretches.back();
    stretch.end_s = now_s;
    for (std::size_t arm = 0; arm < 2; ++arm) widen(stretch.jaw[arm], {jaws[arm], jaws[arm]});
  }
  lanes.authority = authority.take();
  for (std::size_t bit = 0; bit < flags.size(); ++bit) lanes.flags[bit] = flags[bit].take();
  lanes.gaps = gaps_of(shown);
  lanes.grid_steps = steps.take();
  lanes.events = demonstration::events_within(shown, 0.0, shown.full_duration_s());
  std::erase_if(lanes.events, [](const demonstration::Event& event) { return event.arm < 0; });
  return lanes;
}

/// The jaws column by column, joined where a column has no sample of its own.
class LaneData::Columns {
 public:
  Columns(LaneData& data, const TimeRange& range, int count) : data_(data), range_(range), count_(count) {
    for (auto& lane : data_.jaw_) lane.assign(static_cast<std::size_t>(count), Extent{1.0F, -1.0F});
  }

  void add(double t_s, const std::array<float, 2>& jaw_rad) {
    const double place = place_of(t_s);
    const bool joined = begun_ && !gap_between(last_s_, t_s);
    for (std::size_t arm = 0; arm < 2; ++arm) {
      if (joined) join(arm, place, jaw_rad[arm]);
      put(arm, place, {jaw_rad[arm], jaw_rad[arm]});
    }
    begun_ = true;
    last_s_ = t_s;
    last_place_ = place;
    last_ = jaw_rad;
  }

  /// Of samples so dense that none need be joined.
  void add(const LaneRuns::Stretch& stretch) {
    for (std::size_t arm = 0; arm < 2; ++arm) {
      put(arm, place_of(stretch.begin_s), stretch.jaw[arm]);
      put(arm, place_of(stretch.end_s), stretch.jaw[arm]);
    }
  }

 private:
  double place_of(double t_s) const { return (t_s - range_.begin_s) / range_.span_s() * count_; }

  void put(std::size_t arm, double place, const Extent& by) const {
    if (place >= 0.0 && place < count_) widen(data_.jaw_[arm][static_cast<std::size_t>(place)], by);
  }

  bool gap_between(double from_s, double to_s) const {
    const std::vector<Run>& gaps = data_.gaps();
    const double middle_s = 0.5 * (from_s + to_s);
    const auto after = std::upper_bound(gaps.begin(), gaps.end(), middle_s,
                                        [](double t_s, const Run& gap) { return t_s < gap.begin_s; });
    return after != gaps.begin() && middle_s < std::prev(after)->end_s;
  }

  // The columns between the last sample's and this one's, both left out.
  void join(std::size_t arm, double place, float value) const {
    const auto first = static_cast<int>(std::max(std::floor(last_place_) + 1.0, 0.0));
    const auto end = static_cast<int>(std::min(std::floor(place), static_cast<double>(count_)));
    for (int column = first; column < end; ++column) {
      const auto share = static_cast<float>((column + 0.5 - last_place_) / (place - last_place_));
      const float between = last_[arm] + share * (value - last_[arm]);
      widen(data_.jaw_[arm][static_cast<std::size_t>(column)], {between, between});
    }
  }

  LaneData& data_;
  TimeRange range_;
  int count_;
  bool begun_ = false;
  double last_s_ = 0.0;
  double last_place_ = 0.0;
  std::array<float, 2> last_{};
};

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

void LaneData::decimate(const Demonstration& shown, const TimeRange& range, int columns) {
  Columns made(*this, range, columns);
  // With the neighbours just outside, so that lines go on to the edges.
  const std::size_t from = shown.samples.lower_bound(shown.tick_from(range.begin_s));
  const std::size_t to = shown.samples.lower_bound(shown.tick_after(range.end_s));
  const std::size_t first = from == 0 ? 0 : from - 1;
  const demonstration::SampleTrack seen = shown.samples.slice(first, to + 1 - first);
  if (seen.size() <= kLanesAtOnce_samples) {
    for (const Sample& sample : seen) made.add(shown.time_of(sample), jaws_of(sample));
    return;
  }
  // Each of the columns holds many stretches, or most of one.
  for (const LaneRuns::Stretch& stretch : runs_->stretches) made.add(stretch);
}

void LaneData::update(const std::shared_ptr<const workbench::LiveTrace>& trace, const TimeRange& range, int columns) {
  const bool same_range = range_.begin_s == range.begin_s && range_.end_s == range.end_s && columns_ == columns;
  if (!trace || (trace == trace_ && same_range)) return;
  trace_ = trace;
  range_ = range;
  columns_ = columns;
  samples_ = {};
  RunWriter segments;
  RunWriter authority;
  std::array<RunWriter, 4> flags;
  std::vector<double> times;
  std::array<std::vector<double>, 2> speeds;
  // However thinned out they are, live points have no gaps: a pause is one in wall time only.
  LaneRuns lanes;
  for (const workbench::LivePoint& point : trace->points) {
    segments.add(point.t_s, 1 + static_cast<int>(point.segment));
    authority.add(point.t_s, 1 + static_cast<int>(point.authority));
    for (std::size_t bit = 0; bit < flags.size(); ++bit) {
      flags[bit].add(point.t_s, static_cast<int>(point.flags >> bit & 1U));
    }
    times.push_back(point.t_s);
    for (std::size_t arm = 0; arm < 2; ++arm) {
      speeds[arm].push_back(1000.0 * static_cast<double>(point.speed_m_s[arm]));
      lanes.jaw_low = std::min(lanes.jaw_low, point.jaw_rad[arm]);
      lanes.jaw_high = std::max(lanes.jaw_high, point.jaw_rad[arm]);
    }
  }
  lanes.authority = authority.take();
  for (std::size_t bit = 0; bit < flags.size(); ++bit) lanes.flags[bit] = flags[bit].take();
  segments_ = segments.take();
  for (std::size_t arm = 0; arm < 2; ++arm) speed_[arm] = plot::Curve(times, std::move(speeds[arm]));
  runs_ = std::make_shared<const LaneRuns>(std::move(lanes));
  Columns made(*this, range, columns);
  for (const workbench::LivePoint& point : trace->points) made.add(point.t_s, point.jaw_rad);
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
