/// What the parts of the Rollouts panel share: how an end is said and coloured, and how starts are chosen.
#pragma once

#include <string>
#include <vector>

#include "engine/learning/rollout_table.h"
#include "ui/panel.h"

namespace trocar::ui {

/// An icon for how a rollout ends, drawn in `figure::outcome_colour`.
const char* end_sign(learning::RolloutEnd end);
/// The sign in its colour and the word beside it, as one item.
void end_text(Ui& ui, learning::RolloutEnd end);
/// "3, 4, 5"
std::string start_words(const spatial::Grid& grid, spatial::CellIndex cell);
/// A share with a sign, a bar and numbers.
void outcome_row(Ui& ui, const char* sign, std::string_view name, std::int64_t part, std::int64_t whole, Rgba colour);
void summary_block(Ui& ui, std::string_view name, const learning::RolloutSummary& summary);

/// The starts as text from now on.
void choose_starts(const WorkbenchState& state, std::string starts, Requests& requests);
/// This start stands out from now on; none: no one does.
void select_start(const WorkbenchState& state, std::optional<spatial::CellIndex> start, Requests& requests);

/// The newest job that runs or waits under a title that begins so; null if there is none.
const workbench::JobView* job_under_way(const WorkbenchState& state, std::string_view title);
/// Its progress, and a button that stops it and says what is kept.
void draw_job_under_way(Ui& ui, const workbench::JobView& job, std::string_view help, Requests& requests);

/// Opens the form that writes this figure.
void export_plot_button(Ui& ui, std::string_view label, const workbench::PlotSettings& plot, Requests& requests);

/// An area that is drawn by hand like `canvas`, over which the wheel still scrolls the panel. Returns true while it is
/// hovered.
bool chart_area(Ui& ui, std::string_view label, ImVec2 size, std::string_view value, const WidgetOptions& options = {});

/// Columns of the table, the measures that rollouts are sorted by.
const std::vector<std::string>& measure_names();
/// A value as `learning::measure` has it, for people: "12.50 mm", "loops", "2 of 3 down".
std::string measure_words(learning::RolloutMeasure measure, double value);

}  // namespace trocar::ui
