/// The kinds of rollout figures, each drawn from a height downwards. Private to the module.
#pragma once

#include "engine/figure/rollout_figure.h"
#include "engine/figure/sheet.h"

namespace trocar::figure {

/// Each returns the height at which it ends.
double draw_boxes(canvas::Canvas& canvas, const RolloutFigure& figure, const Sheet& sheet, double top);
double draw_axes(canvas::Canvas& canvas, const RolloutFigure& figure, const Sheet& sheet, double top);
double draw_multiples(canvas::Canvas& canvas, const RolloutFigure& figure, const Sheet& sheet, double top);

/// At both sides of the sheet, and above and below.
double margin_of(const Sheet& sheet);
/// "A", "B" … where there are several models; "" for one alone.
std::string letter_of(const RolloutFigure& figure, std::size_t model);
/// Whether all ranges hold its values.
bool is_kept(const RolloutFigure& figure, const DrawnRollouts& of, const learning::Rollout& rollout);
/// How rollouts of its spread end, each once.
std::vector<learning::RolloutEnd> ends_of(const DrawnRollouts& of);
double value_of(const DrawnRollouts& of, const learning::Rollout& rollout, learning::RolloutMeasure measure);

}  // namespace trocar::figure
