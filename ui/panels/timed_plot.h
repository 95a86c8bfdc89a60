/// A plot over the time that all panels show: what the Curves and the Diff panel have in common.
#pragma once

#include <optional>

#include "ui/panel.h"
#include "ui/panels/time_range.h"
#include "ui/widgets/plot.h"

namespace trocar::ui {

/// A plot without lines yet: of the shared time, with the demonstration's gates and the playhead.
PlotSpec timed_plot(const SharedTime& time, const demonstration::Demonstration& shown, double playhead_s,
                    std::optional<double> cursor_s);

/// Does what was done on a plot to the time that all panels show, and asks for the playhead to move.
void follow_plot(const PlotActs& acts, double length_s, SharedTime& time, Requests& requests);

}  // namespace trocar::ui
