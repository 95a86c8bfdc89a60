/// What the timeline's lanes show of a demonstration, worked out once for each version and zoom.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "engine/demonstration/demonstration.h"
#include "engine/demonstration/edit_spans.h"
#include "engine/demonstration/events.h"
#include "engine/plot/curve.h"
#include "engine/workbench/live_trace.h"
#include "ui/panels/time_range.h"

namespace trocar::ui {

/// A stretch of time in which a state held.
struct Run {
  double begin_s = 0.0;
  double end_s = 0.0;
  int state = 0;
};

/// The least and the greatest value within one column of pixels.
struct Extent {
  float low = 0.0F;
  float high = 0.0F;
};

/// What a version of a demonstration has in its lanes, however they are zoomed. Immutable once made.
struct LaneRuns {
  /// The extents of the jaws over neighbouring samples, of long demonstrations.
  struct Stretch {
    double begin_s = 0.0;
    double end_s = 0.0;
    std::array<Extent, 2> jaw;
  };
  std::vector<Run> authority;
  std::array<std::vector<Run>, 4> flags;  ///< By bit of `demonstration::SampleFlag`.
  std::vector<demonstration::Event> events;
  std::vector<Run> gaps;
  std::vector<double> grid_steps;
  std::vector<Stretch> stretches;
  float jaw_low = 0.0F;
  float jaw_high = 0.1F;
};
/// A pure function. Threads: any.
LaneRuns lane_runs(const demonstration::Demonstration& shown);

/// Up to so many samples, lanes are worked out in the frame that shows them.
constexpr std::size_t kLanesAtOnce_samples = 50'000;

/// So many versions of lanes are remembered.
constexpr std::size_t kKeptLanes = 4;

class LaneData {
 public:
  LaneData();
  ~LaneData();
  /// Cheap when neither the samples nor the zoom changed. Of a long demonstration what is new is worked out beside the
  /// window; until then the lanes are those of the version before.
  void update(const demonstration::Demonstration& shown, const TimeRange& range, int columns);
  /// Newer lanes are still to come.
  bool pending() const;

  /// The same of a recording that goes on; what only a demonstration has is empty.
  void update(const std::shared_ptr<const workbench::LiveTrace>& trace, const TimeRange& range, int columns);

  const std::vector<Run>& authority() const { return runs_->authority; }
  /// Spans in which a flag of `demonstration::SampleFlag` is set.
  const std::vector<Run>& flag(demonstration::SampleFlag flag) const;
  /// One for each column, on the line between samples where these are rarer; `low` > `high` in gaps.
  const std::vector<Extent>& jaw(int arm) const { return jaw_[static_cast<std::size_t>(arm)]; }
  /// What the grippers do, by time.
  const std::vector<demonstration::Event>& events() const { return runs_->events; }
  /// Where samples are missing, longer than `demonstration::kMotionGap_s` and than what is usual there: to be bridged.
  const std::vector<Run>& gaps() const { return runs_->gaps; }
  /// Where each edit of the stack has worked.
  const std::vector<demonstration::EditSpan>& edits() const { return edits_; }
  /// The segments as they were recorded.
  const std::vector<demonstration::SegmentSpan>& original() const { return original_; }
  double original_s() const { return original_s_; }  ///< How long the recording was.
  /// When the left tool has gone on by another cell of the lattice.
  const std::vector<double>& grid_steps() const { return runs_->grid_steps; }
  /// Of a recording that goes on: its segments (`state` is the segment and 1), and speeds in mm/s.
  const std::vector<Run>& segments() const { return segments_; }
  const plot::Curve& speed(int arm) const { return speed_[static_cast<std::size_t>(arm)]; }
  float jaw_low() const { return runs_->jaw_low; }
  float jaw_high() const { return runs_->jaw_high; }

 private:
  class Columns;
  class Worker;
  using Runs = std::shared_ptr<const LaneRuns>;

  void keep(std::uint64_t hash, Runs runs);
  /// True if the lanes are others than before.
  bool follow(const demonstration::Demonstration& shown);
  void decimate(const demonstration::Demonstration& shown, const TimeRange& range, int columns);

  demonstration::SampleTrack samples_;  ///< Those that lanes were made of, or asked for.
  /// By the hash of the samples, the newest first: for undo and redo.
  std::deque<std::pair<std::uint64_t, Runs>> kept_;
  Runs runs_ = std::make_shared<const LaneRuns>();
  std::unique_ptr<Worker> worker_;  ///< None before there was a long demonstration.
  TimeRange range_{0.0, 0.0};
  int columns_ = 0;
  std::vector<Run> segments_;
  std::array<plot::Curve, 2> speed_;
  std::shared_ptr<const workbench::LiveTrace> trace_;
  std::shared_ptr<const demonstration::EditStack> stack_;
  std::vector<demonstration::EditSpan> edits_;
  std::shared_ptr<const demonstration::RecordingInfo> recording_;
  std::vector<demonstration::SegmentSpan> original_;
  double original_s_ = 0.0;
  std::array<std::vector<Extent>, 2> jaw_;
};

}  // namespace trocar::ui
