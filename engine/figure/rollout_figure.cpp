#include "engine/figure/rollout_figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "engine/core/check.h"
#include "engine/core/ending.h"
#include "engine/figure/fitted_text.h"
#include "engine/figure/outcome_colours.h"
#include "engine/figure/rollout_parts.h"
#include "engine/figure/slice_panel.h"

namespace trocar::figure {
namespace {

using canvas::Align;
using canvas::Canvas;
using canvas::Weight;
using learning::RolloutEnd;
using learning::RolloutMeasure;

/// Title, whose rollouts they are and from where; the height at which it ends.
double draw_head(Canvas& canvas, const RolloutFigure& figure, const Sheet& sheet) {
  constexpr std::array<std::string_view, 3> kTitles{"Measures of rollouts", "Rollouts, all measures",
                                                    "Rollouts from the side"};
  const double margin = margin_of(sheet);
  const double room = sheet.width - 2.0 * margin;
  double y = margin;
  const auto line = [&](std::string_view words, const canvas::TextStyle& letters) {
    for (const std::string& each : wrapped(canvas, words, letters, room)) {
      y += 1.3 * sheet.em;
      canvas.text({margin, y - 0.3 * sheet.em}, each, letters);
    }
  };
  line(kTitles[static_cast<std::size_t>(figure.plot)], sheet.letters(Align::kLeft, Weight::kSemiBold));
  for (std::size_t i = 0; i < figure.models.size(); ++i) {
    const std::string letter = letter_of(figure, i);
    line(letter.empty() ? figure.models[i].name : letter + ": " + figure.models[i].name, sheet.letters());
  }
  canvas::TextStyle quiet = sheet.letters();
  quiet.colour = kQuiet;
  if (!figure.subtitle.empty()) line(figure.subtitle, quiet);
  return y;
}

/// The ends that there are, each with its colour; the height at which it ends.
double draw_legend(Canvas& canvas, const RolloutFigure& figure, const Sheet& sheet, double top) {
  std::set<RolloutEnd> ends;
  for (const DrawnRollouts& of : figure.models) {
    if (figure.plot == RolloutPlot::kBoxes) {
      const auto there = ends_of(of);
      ends.insert(there.begin(), there.end());
    } else {
      for (const learning::Rollout& rollout : *of.rollouts) ends.insert(rollout.end);
    }
  }
  const canvas::TextStyle letters = sheet.letters();
  double x = margin_of(sheet);
  double y = top + 1.3 * sheet.em;
  for (const RolloutEnd end : ends) {
    const std::string_view words = learning::to_string(end);
    const double width = canvas.text_width(words, letters) + 2.4 * sheet.em;
    if (x > margin_of(sheet) && x + width > sheet.width) {
      x = margin_of(sheet);
      y += 1.3 * sheet.em;
    }
    canvas.rectangle(x, y - 0.95 * sheet.em, 0.8 * sheet.em, 0.8 * sheet.em, outcome_colour(end));
    canvas.text({x + 1.1 * sheet.em, y - 0.25 * sheet.em}, words, letters);
    x += width;
  }
  return y;
}

/// Everything; how high it is.
double draw_whole(Canvas& canvas, const RolloutFigure& figure, const Sheet& sheet) {
  double y = draw_legend(canvas, figure, sheet, draw_head(canvas, figure, sheet));
  y += 0.3 * sheet.em;
  if (figure.plot == RolloutPlot::kBoxes) y = draw_boxes(canvas, figure, sheet, y);
  if (figure.plot == RolloutPlot::kAxes) y = draw_axes(canvas, figure, sheet, y);
  if (figure.plot == RolloutPlot::kMultiples) y = draw_multiples(canvas, figure, sheet, y);
  return std::ceil(y + margin_of(sheet));
}

double sheet_height(const RolloutFigure& figure, const Sheet& sheet) {
  TROCAR_CHECK(!figure.models.empty());
  Canvas nowhere(Image(1, 1));
  return draw_whole(nowhere, figure, sheet);
}

}  // namespace

double margin_of(const Sheet& sheet) {
  return 0.6 * sheet.em;
}

std::string letter_of(const RolloutFigure& figure, std::size_t model) {
  return figure.models.size() < 2 ? "" : std::string(1, static_cast<char>('A' + static_cast<int>(model)));
}

double value_of(const DrawnRollouts& of, const learning::Rollout& rollout, RolloutMeasure measure) {
  const std::span<const double> clearance_m =
      of.clearance_m ? std::span<const double>(*of.clearance_m) : std::span<const double>();
  return learning::measure(rollout, measure, of.model->grid, clearance_m);
}

bool is_kept(const RolloutFigure& figure, const DrawnRollouts& of, const learning::Rollout& rollout) {
  return std::all_of(figure.kept.begin(), figure.kept.end(), [&](const learning::RolloutRange& range) {
    const double value = value_of(of, rollout, range.measure);
    return value >= range.low && value <= range.high;
  });
}

Image draw_rollouts(const RolloutFigure& figure) {
  const Sheet sheet = sheet_of(figure.print, figure.width_px, figure.print ? figure.print->dpi : kScreenDpi);
  Canvas canvas(Image(static_cast<int>(sheet.width), static_cast<int>(sheet_height(figure, sheet)), figure.ground));
  draw_whole(canvas, figure, sheet);
  return canvas.picture();
}

Status save_rollouts(const RolloutFigure& figure, const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  if (ending != ".svg" && ending != ".pdf") {
    return tl::unexpected(
        Error(ErrorCode::kInvalidArgument, "rollouts are drawn as .png, .svg or .pdf").at(path.string()));
  }
  const Sheet sheet = sheet_of(figure.print, figure.width_px, kDrawingDpi);
  const double height = sheet_height(figure, sheet);
  Canvas canvas = ending == ".pdf" ? Canvas::pdf(sheet.width, height, sheet.pt_per_px)
                  : figure.print   ? Canvas::svg_on_paper(sheet.width, height, sheet.pt_per_px)
                                   : Canvas::svg(sheet.width, height);
  canvas.rectangle(0.0, 0.0, sheet.width, height, figure.ground);
  draw_whole(canvas, figure, sheet);
  return canvas.save(path);
}

}  // namespace trocar::figure
