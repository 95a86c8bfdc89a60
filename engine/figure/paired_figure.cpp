#include "engine/figure/paired_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/core/ending.h"
#include "engine/figure/fitted_text.h"
#include "engine/figure/rollout_parts.h"
#include "engine/figure/slice_panel.h"
#include "engine/plot/axis.h"
#include "engine/statistics/summary.h"

namespace trocar::figure {
namespace {

using canvas::Align;
using canvas::Canvas;
using canvas::Weight;

constexpr Rgba kFirst{110, 118, 130, 255};
constexpr Rgba kSecond{38, 148, 112, 255};
constexpr Rgba kScriptedGround{253, 233, 200, 255};
constexpr Rgba kValueLine{218, 221, 226, 255};
constexpr double kPlot_em = 17.0;

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
};

Moments moments_of(const std::vector<double>& values) {
  if (values.empty()) return {};
  return {statistics::mean(values), values.size() < 2 ? 0.0 : statistics::standard_deviation(values)};
}

/// Where something is drawn, with the axis of its values upwards.
struct BarPlot {
  double x = 0.0;
  double y = 0.0;
  double w = 0.0;
  double h = 0.0;
  plot::Axis axis;

  double at(double value) const { return y + h - axis.position(value) * h; }
};

Rgba colour_of(std::size_t group) {
  return group == 0 ? kFirst : kSecond;
}

/// Lines and numbers of the axis; what is left of them is the plot.
void draw_values_axis(Canvas& canvas, BarPlot& plot, double most, const std::string& unit, const Sheet& sheet) {
  const plot::Extent range = plot::value_range({0.0, std::max(most, 1e-9)}, true, {});
  plot.axis = plot::axis_over(range.low, range.high, plot.h, 2.5 * sheet.em);
  double widest = 0.0;
  for (const std::string& label : plot.axis.labels)
    widest = std::max(widest, canvas.text_width(label, sheet.letters()));
  plot.x += widest + 0.5 * sheet.em;
  plot.w -= widest + 0.5 * sheet.em;
  canvas::TextStyle quiet = sheet.letters(Align::kRight);
  quiet.colour = kQuiet;
  for (std::size_t i = 0; i < plot.axis.ticks.size(); ++i) {
    const double y = plot.at(plot.axis.ticks[i]);
    canvas.line({plot.x, y}, {plot.x + plot.w, y}, kValueLine, sheet.pen);
    canvas.text({plot.x - 0.4 * sheet.em, y + 0.35 * sheet.em}, plot.axis.labels[i], quiet);
  }
  quiet.align = Align::kLeft;
  canvas.text({plot.x, plot.y - 0.4 * sheet.em}, unit, quiet);
}

void draw_bar(Canvas& canvas, const BarPlot& plot, const std::vector<double>& values, std::size_t group, double x,
              double w, const Sheet& sheet) {
  const Moments moments = moments_of(values);
  const double base = plot.y + plot.h;
  if (values.empty()) {
    canvas.text({x + 0.5 * w, base - 0.4 * sheet.em}, "–", sheet.letters(Align::kCentre));
    return;
  }
  Rgba fill = colour_of(group);
  canvas.rectangle(x, plot.at(moments.mean), w, base - plot.at(moments.mean), fill);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double across = (static_cast<double>(i * 7 % 11) / 10.0 - 0.5) * 0.6 * w;
    canvas.circle({x + 0.5 * w + across, plot.at(values[i])}, 0.16 * sheet.em, kInk);
  }
  const double middle = x + 0.5 * w;
  const double low = plot.at(std::max(0.0, moments.mean - moments.deviation));
  const double high = plot.at(moments.mean + moments.deviation);
  canvas.line({middle, low}, {middle, high}, kInk, 2.0 * sheet.pen);
  for (const double y : {low, high}) canvas.line({middle - 0.15 * w, y}, {middle + 0.15 * w, y}, kInk, 2.0 * sheet.pen);
}

void draw_bars(Canvas& canvas, const PairedFigure& figure, BarPlot plot, const Sheet& sheet) {
  double most = 0.0;
  for (const PairedMeasure& measure : figure.measures) {
    for (const auto& values : measure.values) {
      const Moments moments = moments_of(values);
      most = std::max(most, moments.mean + moments.deviation);
      for (const double value : values) most = std::max(most, value);
    }
  }
  draw_values_axis(canvas, plot, most, figure.unit, sheet);
  const double place = plot.w / static_cast<double>(figure.measures.size());
  for (std::size_t i = 0; i < figure.measures.size(); ++i) {
    const double x = plot.x + place * static_cast<double>(i);
    const double w = 0.34 * place;
    for (std::size_t g = 0; g < 2; ++g) {
      draw_bar(canvas, plot, figure.measures[i].values[g], g,
               x + 0.14 * place + static_cast<double>(g) * (w + 0.04 * place), w, sheet);
    }
    const std::string name = fitted(canvas, figure.measures[i].name, sheet.letters(), place);
    canvas.text({x + 0.5 * place, plot.y + plot.h + 1.3 * sheet.em}, name, sheet.letters(Align::kCentre));
  }
}

void draw_pairs(Canvas& canvas, const PairedFigure& figure, BarPlot plot, const Sheet& sheet) {
  double most = 0.0;
  for (const auto& pair : figure.pairs) most = std::max({most, pair[0], pair[1]});
  draw_values_axis(canvas, plot, most, figure.pairs_title, sheet);
  const std::array<double, 2> x{plot.x + 0.2 * plot.w, plot.x + 0.8 * plot.w};
  for (const auto& pair : figure.pairs) {
    Rgba colour = pair[1] < pair[0] ? kSecond : kFirst;
    canvas.line({x[0], plot.at(pair[0])}, {x[1], plot.at(pair[1])}, colour, 1.4 * sheet.pen);
    for (std::size_t g = 0; g < 2; ++g) canvas.circle({x[g], plot.at(pair[g])}, 0.22 * sheet.em, colour_of(g));
  }
  for (std::size_t g = 0; g < 2; ++g) {
    canvas.text({x[g], plot.y + plot.h + 1.3 * sheet.em}, figure.groups[g], sheet.letters(Align::kCentre));
  }
}

/// Small plots side by side, all on one axis, so that their heights are compared; the height at which they end.
double draw_panels(Canvas& canvas, const PairedFigure& figure, const Sheet& sheet, double top) {
  constexpr double kPanel_em = 9.0;
  constexpr double kLeast_em = 7.5;
  const double em = sheet.em;
  const double margin = margin_of(sheet);
  const double width = sheet.width - 2.0 * margin;
  double most = 0.0;
  for (const PairedMeasure& panel : figure.panels) {
    for (const auto& values : panel.values) {
      for (const double value : values) most = std::max(most, value);
      const Moments moments = moments_of(values);
      most = std::max(most, moments.mean + moments.deviation);
    }
  }
  const auto columns = std::clamp<std::size_t>(static_cast<std::size_t>(width / (kLeast_em * em)), 1, 8);
  const double cell = width / static_cast<double>(columns);
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const PairedMeasure& panel = figure.panels[i];
    BarPlot plot{margin + static_cast<double>(i % columns) * cell,
                 top + static_cast<double>(i / columns) * (kPanel_em + 4.0) * em + 1.6 * em,
                 cell - 0.8 * em,
                 kPanel_em * em,
                 {}};
    canvas.text({plot.x, plot.y - 1.9 * em},
                fitted(canvas, panel.name, sheet.letters(Align::kLeft, Weight::kSemiBold), plot.w),
                sheet.letters(Align::kLeft, Weight::kSemiBold));
    draw_values_axis(canvas, plot, most, i % columns == 0 ? figure.unit : "", sheet);
    for (std::size_t g = 0; g < 2; ++g) {
      const double w = 0.36 * plot.w;
      const double x = plot.x + 0.1 * plot.w + static_cast<double>(g) * (w + 0.08 * plot.w);
      draw_bar(canvas, plot, panel.values[g], g, x, w, sheet);
    }
  }
  const auto rows = (figure.panels.size() + columns - 1) / columns;
  return top + static_cast<double>(rows) * (kPanel_em + 4.0) * em;
}

double draw_pair_head(Canvas& canvas, const PairedFigure& figure, const Sheet& sheet) {
  const double margin = margin_of(sheet);
  const double width = sheet.width - 2.0 * margin;
  double y = margin + sheet.em;
  canvas.text({margin, y}, fitted(canvas, figure.title, sheet.letters(Align::kLeft, Weight::kSemiBold), width),
              sheet.letters(Align::kLeft, Weight::kSemiBold));
  for (const std::string& line : wrapped(canvas, figure.label, sheet.letters(), width)) {
    y += 1.5 * sheet.em;
    if (figure.scripted)
      canvas.rectangle(margin - 0.2 * sheet.em, y - 1.05 * sheet.em, width, 1.4 * sheet.em, kScriptedGround);
    canvas.text({margin, y}, line, sheet.letters());
  }
  y += 1.6 * sheet.em;
  double x = margin;
  for (std::size_t g = 0; g < 2; ++g) {
    canvas.rectangle(x, y - 0.85 * sheet.em, 0.8 * sheet.em, 0.8 * sheet.em, colour_of(g));
    const std::string words = fmt::format("{} ({})", figure.groups[g], figure.measures.front().values[g].size());
    canvas.text({x + 1.1 * sheet.em, y - 0.1 * sheet.em}, words, sheet.letters());
    x += canvas.text_width(words, sheet.letters()) + 2.6 * sheet.em;
  }
  return y + 1.8 * sheet.em;
}

/// Everything; how high it is.
double draw_pair_sheet(Canvas& canvas, const PairedFigure& figure, const Sheet& sheet) {
  const double em = sheet.em;
  const double margin = margin_of(sheet);
  double y = draw_pair_head(canvas, figure, sheet);
  const double width = sheet.width - 2.0 * margin;
  const bool beside = !figure.pairs.empty() && width > 40.0 * em;
  const double bars = beside ? 0.66 * width - em : width;
  draw_bars(canvas, figure, {margin, y, bars, kPlot_em * em, {}}, sheet);
  if (!figure.pairs.empty()) {
    if (!beside) y += (kPlot_em + 3.6) * em;
    draw_pairs(canvas, figure,
               {beside ? margin + bars + em : margin, y, beside ? width - bars - em : width, kPlot_em * em, {}}, sheet);
  }
  y += (kPlot_em + 2.2) * em;
  return figure.panels.empty() ? y : draw_panels(canvas, figure, sheet, y + 2.0 * em);
}

double pairs_height(const PairedFigure& figure, const Sheet& sheet) {
  TROCAR_CHECK(!figure.measures.empty());
  Canvas nowhere(Image(1, 1));
  return std::ceil(draw_pair_sheet(nowhere, figure, sheet) + margin_of(sheet));
}

}  // namespace

Image draw_paired(const PairedFigure& figure) {
  const Sheet sheet = sheet_of(figure.print, figure.width_px, figure.print ? figure.print->dpi : kScreenDpi);
  Canvas canvas(Image(static_cast<int>(sheet.width), static_cast<int>(pairs_height(figure, sheet)), kPaper));
  draw_pair_sheet(canvas, figure, sheet);
  return canvas.picture();
}

Status save_paired(const PairedFigure& figure, const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  if (ending != ".svg" && ending != ".pdf") {
    return tl::unexpected(Error(ErrorCode::kInvalidArgument, "bars are drawn as .png, .svg or .pdf").at(path.string()));
  }
  const Sheet sheet = sheet_of(figure.print, figure.width_px, kDrawingDpi);
  const double height = pairs_height(figure, sheet);
  Canvas canvas = ending == ".pdf" ? Canvas::pdf(sheet.width, height, sheet.pt_per_px)
                  : figure.print   ? Canvas::svg_on_paper(sheet.width, height, sheet.pt_per_px)
                                   : Canvas::svg(sheet.width, height);
  canvas.rectangle(0.0, 0.0, sheet.width, height, kPaper);
  draw_pair_sheet(canvas, figure, sheet);
  return canvas.save(path);
}

}  // namespace trocar::figure
