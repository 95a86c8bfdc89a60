#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/fitted_text.h"
#include "engine/figure/outcome_colours.h"
#include "engine/figure/rollout_parts.h"
#include "engine/figure/slice_panel.h"

namespace trocar::figure {
namespace {

using canvas::Align;
using canvas::Canvas;
using canvas::Point;
using canvas::Weight;

constexpr Rgba kFrame{200, 203, 209, 255};
constexpr Rgba kExpert{168, 172, 179, 255};
/// Below this a picture is too small to be read.
constexpr double kLeastSide_em = 4.0;
/// A sheet as wide as this is a page or a screen, and no column.
constexpr double kPage_em = 50.0;

struct Frame {
  double x = 0.0;
  double y = 0.0;
  double side = 0.0;

  /// From the side: y to the right, z up.
  Point at(const spatial::Grid& grid, spatial::CellIndex cell) const {
    const spatial::CellCoordinates c = grid.coordinates(cell);
    const double step = side / grid.n;
    return {x + (c.y + 0.5) * step, y + side - (c.z + 0.5) * step};
  }
};

void draw_way(Canvas& canvas, const Frame& frame, const spatial::Grid& grid, const learning::CellSequence& cells,
              Rgba colour, double pen) {
  std::vector<Point> points;
  points.reserve(cells.size());
  for (const spatial::CellIndex cell : cells) points.push_back(frame.at(grid, cell));
  if (points.size() > 1) canvas.polyline(points, colour, pen);
}

void draw_picture(Canvas& canvas, const DrawnRollouts& of, const learning::Rollout& rollout, const Frame& frame,
                  const Sheet& sheet) {
  const learning::Model& model = *of.model;
  const double pen = 1.4 * sheet.pen;
  const double dot = 0.22 * sheet.em;
  canvas.outline(frame.x, frame.y, frame.side, frame.side, kFrame, sheet.pen);
  draw_way(canvas, frame, model.grid, model.experts.front(), kExpert, pen);
  draw_way(canvas, frame, model.grid, rollout.cells, outcome_colour(rollout.end), 1.6 * pen);
  draw_goal_mark(canvas, frame.at(model.grid, model.goal), 1.3 * dot, sheet.pen);
  canvas.circle(frame.at(model.grid, rollout.start), dot, kInk);
}

std::string words_of_start(const DrawnRollouts& of, const learning::Rollout& rollout) {
  const spatial::CellCoordinates c = of.model->grid.coordinates(rollout.start);
  return fmt::format("{}, {}, {}", c.x, c.y, c.z);
}

/// What the marks mean, and how large a frame is.
double draw_marks_key(Canvas& canvas, const RolloutFigure& figure, const Sheet& sheet, double top) {
  const double em = sheet.em;
  const canvas::TextStyle letters = sheet.letters();
  const double y = top + 1.3 * em;
  const double middle = y - 0.55 * em;
  double x = margin_of(sheet);
  const auto word = [&](std::string_view text) {
    canvas.text({x + 1.3 * em, y - 0.25 * em}, text, letters);
    x += canvas.text_width(text, letters) + 2.6 * em;
  };
  canvas.line({x, middle}, {x + em, middle}, kExpert, 1.4 * sheet.pen);
  word("expert");
  canvas.circle({x + 0.5 * em, middle}, 0.22 * em, kInk);
  word("start");
  draw_goal_mark(canvas, {x + 0.5 * em, middle}, 0.29 * em, sheet.pen);
  word("goal");
  const spatial::Grid& grid = figure.models.front().model->grid;
  canvas::TextStyle quiet = letters;
  quiet.colour = kQuiet;
  const std::string size = fmt::format("y to the right, z up; {:.3g} mm each way", 1e3 * grid.cell_m * grid.n);
  const std::string order = fmt::format("Sorted by {}, {} first", learning::words_of(figure.by).title,
                                        figure.descending ? "largest" : "smallest");
  double bottom = y + 0.3 * em;
  for (const std::string& words : {size, order}) {
    for (const std::string& line : wrapped(canvas, words, quiet, sheet.width - 2.0 * margin_of(sheet))) {
      bottom += 1.3 * em;
      canvas.text({margin_of(sheet), bottom - 0.3 * em}, line, quiet);
    }
  }
  return bottom;
}

}  // namespace

double draw_multiples(Canvas& canvas, const RolloutFigure& figure, const Sheet& sheet, double top) {
  const double em = sheet.em;
  const double margin = margin_of(sheet);
  const double gap = 0.7 * em;
  const double room = sheet.width - 2.0 * margin;
  const int fit = std::max(1, static_cast<int>((room + gap) / (kLeastSide_em * em + gap)));
  const int wanted = figure.columns > 0 ? figure.columns : sheet.width > kPage_em * em ? 8 : 4;
  const int columns = std::clamp(wanted, 1, fit);
  const double side = (room - gap * (columns - 1)) / columns;
  double y = draw_marks_key(canvas, figure, sheet, top) + 0.4 * em;
  for (std::size_t m = 0; m < figure.models.size(); ++m) {
    const DrawnRollouts& of = figure.models[m];
    const std::span<const double> clearance_m =
        of.clearance_m ? std::span<const double>(*of.clearance_m) : std::span<const double>();
    std::vector<std::size_t> order =
        learning::sorted_by(*of.rollouts, figure.by, figure.descending, of.model->grid, clearance_m);
    std::erase_if(order, [&](std::size_t place) { return !is_kept(figure, of, (*of.rollouts)[place]); });
    const std::size_t shown = std::min(order.size(), static_cast<std::size_t>(std::max(figure.pictures, 0)));
    const std::string letter = letter_of(figure, m);
    y += 1.4 * em;
    canvas.text({margin, y - 0.3 * em},
                fmt::format("{}{} of {} rollouts", letter.empty() ? "" : letter + ": ", shown, of.rollouts->size()),
                sheet.letters(Align::kLeft, Weight::kSemiBold));
    for (std::size_t i = 0; i < shown; ++i) {
      const auto column = static_cast<double>(i % static_cast<std::size_t>(columns));
      const auto row = static_cast<double>(i / static_cast<std::size_t>(columns));
      const learning::Rollout& rollout = (*of.rollouts)[order[i]];
      const Frame frame{margin + column * (side + gap), y + 0.2 * em + row * (side + 1.7 * em), side};
      draw_picture(canvas, of, rollout, frame, sheet);
      const bool by_start = figure.by == learning::RolloutMeasure::kStart;
      const std::string words =
          by_start ? words_of_start(of, rollout) : learning::measure_text(figure.by, value_of(of, rollout, figure.by));
      canvas.text({frame.x + 0.5 * side, frame.y + side + 1.1 * em}, fitted(canvas, words, sheet.letters(), side + gap),
                  sheet.letters(Align::kCentre));
    }
    const auto rows =
        static_cast<double>((shown + static_cast<std::size_t>(columns) - 1) / static_cast<std::size_t>(columns));
    y += 0.2 * em + rows * (side + 1.7 * em);
  }
  return y;
}

}  // namespace trocar::figure
