#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
using learning::RolloutMeasure;

/// All but the start: a cell has no more and less.
constexpr int kAxes = learning::kRolloutMeasures - 1;
/// More lines than these would be one area.
constexpr std::size_t kMostLines = 300;
/// What an axis needs for the words at its ends.
constexpr double kApart_em = 4.3;
constexpr double kHeight_em = 13.0;
/// Less where many rows have to share a sheet of paper, whose height this is without head and foot.
constexpr double kLeastHeight_em = 5.0;
constexpr double kSheet_em = 90.0;
constexpr double kAboveAxis_em = 4.2;
constexpr double kBelowAxis_em = 1.6;
constexpr Rgba kLeftOut{200, 203, 209, 255};

struct DrawnAxis {
  RolloutMeasure measure = RolloutMeasure::kEnd;
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double x = 0.0;
  double top = 0.0;
  double bottom = 0.0;

  double y_of(double value) const {
    if (high <= low) return 0.5 * (top + bottom);
    return bottom - (value - low) / (high - low) * (bottom - top);
  }
};

/// What stands at an end of the axis: the unit is in its name.
std::string end_text(RolloutMeasure measure, double value) {
  if (!std::isfinite(value)) return "none";
  if (measure == RolloutMeasure::kEnd) {
    return std::string(outcome_word(static_cast<learning::RolloutEnd>(std::lround(value))));
  }
  const std::string text = learning::measure_text(measure, value);
  return learning::words_of(measure).unit.empty() ? text : text.substr(0, text.find(' '));
}

std::vector<DrawnAxis> axes_of(const RolloutFigure& figure) {
  std::vector<DrawnAxis> axes(kAxes);
  for (int i = 0; i < kAxes; ++i) {
    DrawnAxis& axis = axes[static_cast<std::size_t>(i)];
    axis.measure = static_cast<RolloutMeasure>(i + 1);
    // One scale for all models, so that their lines are compared.
    for (const DrawnRollouts& of : figure.models) {
      for (const learning::Rollout& rollout : *of.rollouts) {
        const double value = value_of(of, rollout, axis.measure);
        if (!std::isfinite(value)) continue;
        axis.low = std::min(axis.low, value);
        axis.high = std::max(axis.high, value);
      }
    }
  }
  return axes;
}

void draw_rollout_lines(Canvas& canvas, const RolloutFigure& figure, const DrawnRollouts& of,
                        const std::vector<DrawnAxis>& axes, const Sheet& sheet) {
  const std::size_t all = of.rollouts->size();
  const std::size_t drawn = std::min(kMostLines, all);
  for (const bool kept : {false, true}) {
    for (std::size_t n = 0; n < drawn; ++n) {
      const learning::Rollout& rollout = (*of.rollouts)[n * all / drawn];
      if (is_kept(figure, of, rollout) != kept) continue;
      std::vector<Point> points;
      for (const DrawnAxis& axis : axes) {
        const double value = value_of(of, rollout, axis.measure);
        if (std::isfinite(value)) points.push_back({axis.x, axis.y_of(value)});
      }
      Rgba colour = kept ? outcome_colour(rollout.end) : kLeftOut;
      colour.a = kept ? 140 : 90;
      if (points.size() > 1) canvas.polyline(points, colour, sheet.pen);
    }
  }
}

void draw_axis(Canvas& canvas, const RolloutFigure& figure, const DrawnAxis& axis, bool high_name, double apart,
               const Sheet& sheet) {
  const double em = sheet.em;
  canvas.line({axis.x, axis.top}, {axis.x, axis.bottom}, kInk, 1.5 * sheet.pen);
  for (const learning::RolloutRange& range : figure.kept) {
    if (range.measure != axis.measure || axis.high < axis.low) continue;
    const double from = std::max(axis.y_of(range.high), axis.top);
    const double to = std::min(axis.y_of(range.low), axis.bottom);
    if (to > from) canvas.rectangle(axis.x - 0.3 * em, from, 0.6 * em, to - from, {28, 30, 34, 90});
  }
  const learning::MeasureWords& words = learning::words_of(axis.measure);
  const std::string name = words.unit.empty() ? std::string(words.name) : fmt::format("{}, {}", words.name, words.unit);
  const auto middle = [&](double y, const std::string& text, double room, Rgba colour) {
    canvas::TextStyle letters = sheet.letters(Align::kCentre);
    letters.colour = colour;
    const std::string shown = fitted(canvas, text, letters, room);
    // The first and the last stay on the sheet.
    const double half = 0.5 * canvas.text_width(shown, letters);
    const double margin = 0.4 * em;
    canvas.text({std::clamp(axis.x, margin + half, sheet.width - margin - half), y}, shown, letters);
  };
  middle(axis.top - (high_name ? 2.9 : 1.65) * em, name, 1.9 * apart, kInk);
  middle(axis.top - 0.4 * em, end_text(axis.measure, axis.high), 0.95 * apart, kQuiet);
  middle(axis.bottom + 1.1 * em, end_text(axis.measure, axis.low), 0.95 * apart, kQuiet);
}

}  // namespace

double draw_axes(Canvas& canvas, const RolloutFigure& figure, const Sheet& sheet, double top) {
  const double em = sheet.em;
  const double room = sheet.width - 2.0 * margin_of(sheet);
  const int most = std::clamp(static_cast<int>(room / (kApart_em * em)), 2, kAxes);
  const int banks = (kAxes + most - 1) / most;
  const int in_bank = (kAxes + banks - 1) / banks;
  const double apart = room / in_bank;
  const std::vector<DrawnAxis> axes = axes_of(figure);
  const double rows = static_cast<double>(banks) * static_cast<double>(figure.models.size());
  const double height_em = std::clamp(kSheet_em / rows - kAboveAxis_em - kBelowAxis_em, kLeastHeight_em, kHeight_em);
  double y = top;
  for (std::size_t m = 0; m < figure.models.size(); ++m) {
    if (const std::string letter = letter_of(figure, m); !letter.empty()) {
      y += 1.6 * em;
      canvas.text({margin_of(sheet), y - 0.3 * em}, letter + ": " + figure.models[m].name,
                  sheet.letters(Align::kLeft, Weight::kSemiBold));
    }
    for (int first = 0; first < kAxes; first += in_bank) {
      std::vector<DrawnAxis> bank(axes.begin() + first, axes.begin() + std::min(first + in_bank, kAxes));
      for (std::size_t i = 0; i < bank.size(); ++i) {
        bank[i].x = margin_of(sheet) + (static_cast<double>(i) + 0.5) * apart;
        bank[i].top = y + kAboveAxis_em * em;
        bank[i].bottom = bank[i].top + height_em * em;
      }
      draw_rollout_lines(canvas, figure, figure.models[m], bank, sheet);
      for (std::size_t i = 0; i < bank.size(); ++i) draw_axis(canvas, figure, bank[i], i % 2 == 0, apart, sheet);
      y = bank.front().bottom + kBelowAxis_em * em;
    }
  }
  std::size_t all = 0;
  for (const DrawnRollouts& of : figure.models) all = std::max(all, of.rollouts->size());
  if (all > kMostLines) {
    canvas::TextStyle quiet = sheet.letters();
    quiet.colour = kQuiet;
    y += 1.2 * em;
    canvas.text({margin_of(sheet), y - 0.3 * em}, fmt::format("{} of {} lines, evenly", kMostLines, all), quiet);
  }
  return y;
}

}  // namespace trocar::figure
