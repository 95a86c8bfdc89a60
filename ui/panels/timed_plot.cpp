#include "ui/panels/timed_plot.h"

namespace trocar::ui {

PlotSpec timed_plot(const SharedTime& time, const demonstration::Demonstration& shown, double playhead_s,
                    std::optional<double> cursor_s) {
  PlotSpec spec;
  spec.begin_s = time.range.begin_s;
  spec.end_s = time.range.end_s;
  spec.gate_in_s = shown.begin_s;
  spec.gate_out_s = shown.end_s;
  spec.playhead_s = playhead_s;
  spec.cursor_s = cursor_s;
  return spec;
}

void follow_plot(const PlotActs& acts, double length_s, SharedTime& time, Requests& requests) {
  if (acts.zoom != 1.0) time.range.zoom(acts.zoom_at_s, acts.zoom);
  if (acts.pan_s != 0.0) time.range.pan(acts.pan_s);
  time.range.keep_within(length_s);
  if (acts.seek_s) requests.emplace_back(workbench::Command{workbench::SetPlayhead{*acts.seek_s}});
}

}  // namespace trocar::ui
