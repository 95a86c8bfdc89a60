#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/fitted_text.h"
#include "engine/figure/outcome_colours.h"
#include "engine/figure/rollout_parts.h"
#include "engine/figure/slice_panel.h"
#include "engine/plot/axis.h"

namespace trocar::figure {
namespace {

using canvas::Align;
using canvas::Canvas;
using canvas::Weight;
using learning::RolloutEnd;
using learning::RolloutMeasure;

constexpr Rgba kGround{244, 245, 247, 255};
constexpr Rgba kGridLine{218, 221, 226, 255};
constexpr double kRow_em = 1.5;
/// From which width on two panels stand side by side.
constexpr double kTwo_em = 50.0;

/// The rollouts of one model that end alike.
struct BoxRow {
  std::string name;
  std::size_t model = 0;
  RolloutEnd end = RolloutEnd::kArrives;
};

std::vector<BoxRow> rows_of(const RolloutFigure& figure) {
  std::vector<BoxRow> rows;
  for (std::size_t m = 0; m < figure.models.size(); ++m) {
    for (const RolloutEnd end : ends_of(figure.models[m])) {
      const std::string letter = letter_of(figure, m);
      rows.push_back({(letter.empty() ? "" : letter + " ") + std::string(outcome_word(end)), m, end});
    }
  }
  return rows;
}

struct BoxArea {
  double x = 0.0;
  double y = 0.0;
  double w = 0.0;
  double h = 0.0;
  plot::Axis axis;

  double at(double value) const { return x + axis.position(value) * w; }
};

/// `scale` makes the unit of the axis of SI.
void draw_box(Canvas& canvas, const learning::MeasureSpread& values, double scale, Rgba colour, const BoxArea& area,
              const Sheet& sheet) {
  const double y = area.y + 0.5 * area.h;
  colour.a = 150;
  for (std::size_t i = 0; i < values.some.size(); ++i) {
    // Spread over the height by their place, so that equal ones are seen.
    const double lower = (static_cast<double>(i * 7 % 11) / 10.0 - 0.5) * 0.75 * area.h;
    canvas.circle({area.at(scale * values.some[i]), y + lower}, 0.13 * sheet.em, colour);
  }
  const auto at = [&](double value) { return area.at(scale * value); };
  const learning::Spread& spread = values.spread;
  const double half = 0.3 * area.h;
  const double pen = 1.5 * sheet.pen;
  canvas.line({at(spread.least), y}, {at(spread.low), y}, kInk, pen);
  canvas.line({at(spread.high), y}, {at(spread.most), y}, kInk, pen);
  canvas.outline(at(spread.low), y - half, std::max(at(spread.high) - at(spread.low), pen), 2.0 * half, kInk, pen);
  canvas.line({at(spread.median), y - half}, {at(spread.median), y + half}, kInk, 2.0 * pen);
}

plot::Axis axis_of(const std::vector<const learning::MeasureSpread*>& rows, double scale, double width,
                   const Sheet& sheet) {
  std::optional<plot::Extent> all;
  for (const learning::MeasureSpread* row : rows) {
    if (row->spread.count == 0) continue;
    const plot::Extent one{scale * row->spread.least, scale * row->spread.most};
    all = all ? plot::Extent{std::min(all->low, one.low), std::max(all->high, one.high)} : one;
  }
  const plot::Extent range = plot::value_range(all.value_or(plot::Extent{0.0, 1.0}), true, {});
  return plot::axis_over(range.low, range.high, width, 4.0 * sheet.em);
}

/// One measure: a heading, the rows, the axis below them.
void draw_measure(Canvas& canvas, const RolloutFigure& figure, const std::vector<BoxRow>& rows, RolloutMeasure measure,
                  const Sheet& sheet, canvas::Point at, double width) {
  const learning::MeasureWords& words = learning::words_of(measure);
  const double em = sheet.em;
  double names = 0.0;
  for (const BoxRow& row : rows) names = std::max(names, canvas.text_width(row.name, sheet.letters()));
  std::vector<const learning::MeasureSpread*> values;
  std::vector<std::string> middles;
  double numbers = 0.0;
  for (const BoxRow& row : rows) {
    values.push_back(&figure.models[row.model].spread->of(measure, row.end));
    const learning::Spread& spread = values.back()->spread;
    middles.push_back(spread.count == 0 ? "none" : fmt::format("{:.3g}", words.scale * spread.median));
    if (middles.back().front() == '-') middles.back().replace(0, 1, "−");
    numbers = std::max(numbers, canvas.text_width(middles.back(), sheet.letters()));
  }
  const std::string title(words.title);
  canvas.text({at.x, at.y + em}, words.unit.empty() ? title : fmt::format("{}, {}", title, words.unit),
              sheet.letters(Align::kLeft, Weight::kSemiBold));
  BoxArea area{at.x + names + 0.8 * em, at.y + 1.5 * em, width - names - numbers - 1.6 * em, kRow_em * em, {}};
  area.axis = axis_of(values, words.scale, area.w, sheet);
  const double bottom = area.y + static_cast<double>(rows.size()) * area.h;
  canvas.rectangle(area.x, area.y, area.w, bottom - area.y, kGround);
  double free_from = at.x;  // A label that would touch the one before it is left out.
  for (std::size_t i = 0; i < area.axis.ticks.size(); ++i) {
    const double x = area.at(area.axis.ticks[i]);
    canvas.line({x, area.y}, {x, bottom}, kGridLine, sheet.pen);
    const double half = 0.5 * canvas.text_width(area.axis.labels[i], sheet.letters());
    if (x - half < free_from || x + half > at.x + width) continue;
    canvas::TextStyle quiet = sheet.letters(Align::kCentre);
    quiet.colour = kQuiet;
    canvas.text({x, bottom + 1.1 * em}, area.axis.labels[i], quiet);
    free_from = x + half + 0.4 * em;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double base = area.y + 0.5 * area.h + 0.35 * em;
    canvas.text({at.x + names, base}, rows[i].name, sheet.letters(Align::kRight));
    canvas.text({at.x + width, base}, middles[i], sheet.letters(Align::kRight));
    if (values[i]->spread.count > 0) {
      draw_box(canvas, *values[i], words.scale, outcome_colour(rows[i].end), area, sheet);
    }
    area.y += area.h;
  }
}

}  // namespace

std::vector<RolloutEnd> ends_of(const DrawnRollouts& of) {
  std::vector<RolloutEnd> ends;
  for (std::size_t e = 0; e < learning::kRolloutEnds; ++e) {
    // Every rollout has a number of steps.
    const auto end = static_cast<RolloutEnd>(e);
    if (of.spread->of(RolloutMeasure::kSteps, end).spread.count > 0) ends.push_back(end);
  }
  return ends;
}

double draw_boxes(Canvas& canvas, const RolloutFigure& figure, const Sheet& sheet, double top) {
  const double em = sheet.em;
  const double margin = margin_of(sheet);
  std::vector<RolloutMeasure> measures = figure.measures;
  if (figure.measures.empty()) {
    measures = learning::spread_measures();
  }
  const std::vector<BoxRow> rows = rows_of(figure);
  const std::size_t columns = sheet.width > kTwo_em * em && measures.size() > 1 ? 2 : 1;
  const double gap = 1.6 * em;
  const double width =
      (sheet.width - 2.0 * margin - gap * static_cast<double>(columns - 1)) / static_cast<double>(columns);
  const double height = (3.2 + kRow_em * static_cast<double>(rows.size())) * em;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const auto column = static_cast<double>(i % columns);
    const auto row = static_cast<double>(i / columns);
    draw_measure(canvas, figure, rows, measures[i], sheet, {margin + column * (width + gap), top + row * height},
                 width);
  }
  const std::size_t down = (measures.size() + columns - 1) / columns;
  double y = top + static_cast<double>(down) * height;
  canvas::TextStyle quiet = sheet.letters();
  quiet.colour = kQuiet;
  for (const std::string& line : wrapped(canvas, "Box: the middle half; bar and number: the middle one; line: all",
                                         quiet, sheet.width - 2.0 * margin)) {
    y += 1.3 * em;
    canvas.text({margin, y - 0.3 * em}, line, quiet);
  }
  return y;
}

}  // namespace trocar::figure
