/// Draws the timeline's ruler and lanes; knows nothing of the mouse.
#pragma once

#include "ui/panels/lane_data.h"
#include "ui/panels/time_range.h"
#include "ui/widgets/widgets.h"

namespace trocar::ui {

struct LaneLayout {
  Rect names;  ///< Column of the lanes' names.
  Rect ruler;
  Rect lanes;  ///< Below the ruler; times run from `lanes.x0` to `lanes.x1`.
  TimeRange range;
  double gate_in_s = 0.0;
  double gate_out_s = 0.0;

  float x_of(double t_s) const { return range.x_of(t_s, lanes.x0, lanes.width()); }
  double time_at(float x) const { return range.time_at(x, lanes.x0, lanes.width()); }
};

LaneLayout lay_out(const Ui& ui, const Rect& area, const TimeRange& range);
/// What all lanes and the ruler take, pixels.
float lanes_height(const Ui& ui);
void draw_ruler(Ui& ui, const LaneLayout& layout);
/// All lanes from the top. Words stand between the gates, and times of segments are cut to them.
void draw_lanes(Ui& ui, const LaneLayout& layout, const demonstration::Demonstration& shown, const LaneData& data);

}  // namespace trocar::ui
