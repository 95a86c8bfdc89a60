/// What is drawn over the timeline's lanes: gates, selection, playhead.
#pragma once

#include "ui/panels/timeline_mouse.h"

namespace trocar::ui {

/// The gates and what is used between them, with its length; the rest is veiled. `drag`: one that moves is lit.
void draw_gates(Ui& ui, const LaneLayout& layout, TimelineMouse::Drag drag);
void draw_selection(Ui& ui, const LaneLayout& layout, const workbench::TimeSpan& selection);
/// What the timeline will show when the middle button is released.
void draw_zoomed(Ui& ui, const LaneLayout& layout, const workbench::TimeSpan& span);
void draw_playhead(Ui& ui, const LaneLayout& layout, double t_s);
/// The place that a drag has gone to by itself.
void draw_snap(Ui& ui, const LaneLayout& layout, double t_s);

/// Hatched over all lanes: samples are missing here.
void draw_gaps(Ui& ui, const LaneLayout& layout, const std::vector<Run>& gaps);

}  // namespace trocar::ui
