/// What the timeline's lanes show of a demonstration, worked out once for each version and zoom.
#pragma once

#include <array>
#include <memory>
#include <span>
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

class LaneData {
 public:
  /// Cheap when neither the samples nor the zoom changed.
  void update(const demonstration::Demonstration& shown, const TimeRange& range, int columns);

  /// The same of a recording that goes on; what only a demonstration has is empty.
  void update(const std::shared_ptr<const workbench::LiveTrace>& trace, const TimeRange& range, int columns);

  const std::vector<Run>& authority() const { return authority_; }
  /// Spans in which a flag of `demonstration::SampleFlag` is set.
  const std::vector<Run>& flag(demonstration::SampleFlag flag) const;
  /// One for each column, on the line between samples where these are rarer; `low` > `high` in gaps.
  const std::vector<Extent>& jaw(int arm) const { return jaw_[static_cast<std::size_t>(arm)]; }
  /// What the grippers do, by time.
  const std::vector<demonstration::Event>& events() const { return events_; }
  /// Where samples are missing, longer than `demonstration::kMotionGap_s` and than what is usual there: to be bridged.
  const std::vector<Run>& gaps() const { return gaps_; }
  /// Where each edit of the stack has worked.
  const std::vector<demonstration::EditSpan>& edits() const { return edits_; }
  /// The segments as they were recorded.
  const std::vector<demonstration::SegmentSpan>& original() const { return original_; }
  double original_s() const { return original_s_; }  ///< How long the recording was.
  /// When the left tool has gone on by another cell of the lattice.
  const std::vector<double>& grid_steps() const { return grid_steps_; }
  /// Of a recording that goes on: its segments (`state` is the segment and 1), and speeds in mm/s.
  const std::vector<Run>& segments() const { return segments_; }
  const plot::Curve& speed(int arm) const { return speed_[static_cast<std::size_t>(arm)]; }
  float jaw_low() const { return jaw_low_; }
  float jaw_high() const { return jaw_high_; }

 private:
  void find_runs(const demonstration::Demonstration& shown);
  void find_gaps(const demonstration::Demonstration& shown);
  void find_grid_steps(const demonstration::Demonstration& shown);
  void decimate(const demonstration::Demonstration& shown, const TimeRange& range, int columns);
  class Columns;

  demonstration::SampleTrack samples_;
  TimeRange range_{0.0, 0.0};
  int columns_ = 0;
  std::vector<Run> authority_;
  std::vector<demonstration::Event> events_;
  std::vector<Run> gaps_;
  std::vector<double> grid_steps_;
  std::vector<Run> segments_;
  std::array<plot::Curve, 2> speed_;
  std::shared_ptr<const workbench::LiveTrace> trace_;
  std::shared_ptr<const demonstration::EditStack> stack_;
  std::vector<demonstration::EditSpan> edits_;
  std::shared_ptr<const demonstration::Recording> recording_;
  std::vector<demonstration::SegmentSpan> original_;
  double original_s_ = 0.0;
  std::array<std::vector<Run>, 4> flags_;
  std::array<std::vector<Extent>, 2> jaw_;
  float jaw_low_ = 0.0F;
  float jaw_high_ = 1.0F;
};

}  // namespace trocar::ui
