#include "ui/panels/lane_data.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <utility>

#include "engine/demonstration/motion.h"
#include "engine/demonstration/sampling_rate.h"
#include "engine/spatial/grid.h"

namespace trocar::ui {
namespace {

using demonstration::Sample;

// Of points in time; `state_of` gives 0 for what is not drawn.
class RunMaker {
 public:
  explicit RunMaker(std::vector<Run>& list) : list_(list) { list_.clear(); }

  void add(double t_s, int state) {
    if (!list_.empty() && state_ != 0) list_.back().end_s = t_s;
    if (state != state_ && state != 0) list_.push_back({t_s, t_s, state});
    state_ = state;
  }

 private:
  std::vector<Run>& list_;
  int state_ = 0;
};

template <typename StateOf>
std::vector<Run> runs(const demonstration::Demonstration& shown, StateOf state_of) {
  std::vector<Run> list;
  RunMaker maker(list);
  for (const Sample& sample : shown.samples) maker.add(shown.time_of(sample), state_of(sample));
  return list;
}

void widen(Extent& extent, float value) {
  extent = extent.low > extent.high ? Extent{value, value}
                                    : Extent{std::min(extent.low, value), std::max(extent.high, value)};
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
  jaw_low_ = 0.0F;
  jaw_high_ = 0.1F;
  for (const Sample& sample : shown.samples) {
    for (const auto& arm : sample.arms) {
      jaw_low_ = std::min(jaw_low_, arm.jaw_rad);
      jaw_high_ = std::max(jaw_high_, arm.jaw_rad);
    }
  }
  find_gaps(shown);
  find_grid_steps(shown);
}

void LaneData::find_gaps(const demonstration::Demonstration& shown) {
  gaps_.clear();
  for (const demonstration::SampleGap& gap : demonstration::sample_gaps(shown.samples)) {
    const auto time_s = [&](std::size_t i) { return Tick{shown.samples.tick(i) - shown.first_tick()}.seconds(); };
    const double begin_s = time_s(gap.after - 1);
    const double end_s = time_s(gap.after);
    if (end_s - begin_s > demonstration::kMotionGap_s) gaps_.push_back({begin_s, end_s, 1});
  }
}

// From a place that was counted the tool must get a whole cell away along an axis: what trembles about a face of a cell
// makes no steps.
void LaneData::find_grid_steps(const demonstration::Demonstration& shown) {
  grid_steps_.clear();
  if (shown.samples.empty()) return;
  const double cell_m = spatial::Grid{}.cell_m;
  Eigen::Vector3d counted = demonstration::measured_tip(shown.samples[0], 0);
  for (const Sample& sample : shown.samples) {
    const Eigen::Vector3d p_WT = demonstration::measured_tip(sample, 0);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      // Half a micrometre less: a tool that steps by exactly one cell has done so.
      while (std::abs(p_WT[axis] - counted[axis]) >= cell_m - 5e-7) {
        counted[axis] += std::copysign(cell_m, p_WT[axis] - counted[axis]);
        grid_steps_.push_back(shown.time_of(sample));
      }
    }
  }
}

/// The jaws column by column, joined where a column has no sample of its own.
class LaneData::Columns {
 public:
  Columns(LaneData& data, const TimeRange& range, int count) : data_(data), range_(range), count_(count) {
    for (auto& lane : data_.jaw_) lane.assign(static_cast<std::size_t>(count), Extent{1.0F, -1.0F});
  }

  void add(double t_s, const std::array<float, 2>& jaw_rad) {
    const double place = (t_s - range_.begin_s) / range_.span_s() * count_;
    const bool joined = begun_ && !gap_between(last_s_, t_s);
    for (std::size_t arm = 0; arm < 2; ++arm) {
      if (joined) join(arm, place, jaw_rad[arm]);
      if (place >= 0.0 && place < count_) widen(data_.jaw_[arm][static_cast<std::size_t>(place)], jaw_rad[arm]);
    }
    begun_ = true;
    last_s_ = t_s;
    last_place_ = place;
    last_ = jaw_rad;
  }

 private:
  bool gap_between(double from_s, double to_s) const {
    const double middle_s = 0.5 * (from_s + to_s);
    const auto after = std::upper_bound(data_.gaps_.begin(), data_.gaps_.end(), middle_s,
                                        [](double t_s, const Run& gap) { return t_s < gap.begin_s; });
    return after != data_.gaps_.begin() && middle_s < std::prev(after)->end_s;
  }

  // The columns between the last sample's and this one's, both left out.
  void join(std::size_t arm, double place, float value) const {
    const auto first = static_cast<int>(std::max(std::floor(last_place_) + 1.0, 0.0));
    const auto end = static_cast<int>(std::min(std::floor(place), static_cast<double>(count_)));
    for (int column = first; column < end; ++column) {
      const auto share = static_cast<float>((column + 0.5 - last_place_) / (place - last_place_));
      widen(data_.jaw_[arm][static_cast<std::size_t>(column)], last_[arm] + share * (value - last_[arm]));
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

void LaneData::decimate(const demonstration::Demonstration& shown, const TimeRange& range, int columns) {
  Columns made(*this, range, columns);
  // With the neighbours just outside, so that lines go on to the edges.
  const std::size_t from = shown.samples.lower_bound(shown.tick_from(range.begin_s));
  const std::size_t to = shown.samples.lower_bound(shown.tick_after(range.end_s));
  const std::size_t first = from == 0 ? 0 : from - 1;
  for (const Sample& sample : shown.samples.slice(first, to + 1 - first)) {
    made.add(shown.time_of(sample), {sample.arms[0].jaw_rad, sample.arms[1].jaw_rad});
  }
}

void LaneData::update(const std::shared_ptr<const workbench::LiveTrace>& trace, const TimeRange& range, int columns) {
  const bool same_range = range_.begin_s == range.begin_s && range_.end_s == range.end_s && columns_ == columns;
  if (!trace || (trace == trace_ && same_range)) return;
  trace_ = trace;
  range_ = range;
  columns_ = columns;
  RunMaker segments(segments_);
  RunMaker authority(authority_);
  std::vector<double> times;
  std::array<std::vector<double>, 2> speeds;
  jaw_low_ = 0.0F;
  jaw_high_ = 0.1F;
  for (const workbench::LivePoint& point : trace->points) {
    segments.add(point.t_s, 1 + static_cast<int>(point.segment));
    authority.add(point.t_s, 1 + static_cast<int>(point.authority));
    times.push_back(point.t_s);
    for (std::size_t arm = 0; arm < 2; ++arm) {
      speeds[arm].push_back(1000.0 * static_cast<double>(point.speed_m_s[arm]));
      jaw_low_ = std::min(jaw_low_, point.jaw_rad[arm]);
      jaw_high_ = std::max(jaw_high_, point.jaw_rad[arm]);
    }
  }
  for (std::size_t bit = 0; bit < flags_.size(); ++bit) {
    RunMaker flag(flags_[bit]);
    for (const workbench::LivePoint& point : trace->points)
      flag.add(point.t_s, static_cast<int>(point.flags >> bit & 1U));
  }
  for (std::size_t arm = 0; arm < 2; ++arm) speed_[arm] = plot::Curve(times, std::move(speeds[arm]));
  // However thinned out it is: a pause is a gap in wall time only.
  gaps_.clear();
  Columns made(*this, range, columns);
  for (const workbench::LivePoint& point : trace->points) made.add(point.t_s, point.jaw_rad);
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
