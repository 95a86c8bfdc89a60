#include "engine/figure/curve_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "engine/canvas/canvas.h"
#include "engine/core/check.h"
#include "engine/core/file.h"
#include "engine/figure/fitted_text.h"
#include "engine/figure/slice_panel.h"

namespace trocar::figure {
namespace {

using canvas::Align;
using canvas::Canvas;
using canvas::Point;
using canvas::TextStyle;
using canvas::Weight;

constexpr Rgba kQuiet{96, 101, 109, 255};
constexpr Rgba kGrid{226, 229, 233, 255};
constexpr Rgba kBeyond{213, 60, 50, 28};
constexpr Rgba kLimit{190, 40, 40, 255};
/// Of Okabe and Ito: blue and vermilion.
constexpr std::array<Rgba, 2> kLines{Rgba{0, 114, 178, 255}, Rgba{213, 94, 0, 255}};

constexpr double kPlotHeight = 150.0;  // All at a width of 1000 pixels.
constexpr double kPlotGap = 34.0;
constexpr double kTop = 44.0;
constexpr double kLeft = 72.0;
constexpr double kRight = 22.0;
constexpr double kBottom = 46.0;
constexpr double kLabelGap = 7.0;
constexpr double kPaperMargin = 4.0;
constexpr double kTickAtUnit = 12.0;
constexpr double kFinestDpi = 600.0;
constexpr double kCurve_pt = 0.8;
constexpr double kThin_pt = 0.5;

/// Lengths in pixels.
struct Sizes {
  double unit = 1.0;  ///< 1 at a width of 1000 pixels, and at ticks of 12 pixels for print.
  double pt_per_px = 0.75;
  double width = 1000.0;
  double title = 14.0;  ///< Em sizes.
  double heading = 13.0;
  double tick = 12.0;
  double limit = 11.0;
  double left = kLeft;
  double line = 1.8;  ///< Widths of the curves, and of all else.
  double thin = 1.0;
  double finest_px = 1.0;  ///< Below which curves need no detail.
};

/// Where one plot lies, and what its edges stand for.
struct Place {
  double x = 0.0;
  double y = 0.0;
  double w = 0.0;
  double h = 0.0;
  double unit = 1.0;
  Sizes sizes;
  plot::Axis time;
  plot::Axis values;

  Point at(plot::CurvePoint point) const {
    return {x + time.position(point.x) * w, y + (1.0 - values.position(point.y)) * h};
  }
};

Sizes sizes_of(const CurveFigure& figure, double dpi) {
  Sizes sizes;
  if (!figure.print) {
    sizes.width = std::max(figure.width_px, 480);
    sizes.unit = sizes.width / 1000.0;
    for (double* each :
         {&sizes.title, &sizes.heading, &sizes.tick, &sizes.limit, &sizes.left, &sizes.line, &sizes.thin})
      *each *= sizes.unit;
    return sizes;
  }
  sizes.pt_per_px = pt_per_px(dpi);
  sizes.line = kCurve_pt / sizes.pt_per_px;
  sizes.thin = kThin_pt / sizes.pt_per_px;
  sizes.finest_px = std::max(1.0, dpi / kFinestDpi);
  sizes.width = std::round(figure.print->width_mm * px_per_mm(dpi));
  sizes.tick = figure.print->text_pt / sizes.pt_per_px;
  sizes.title = sizes.heading = sizes.limit = sizes.tick;
  sizes.unit = sizes.tick / kTickAtUnit;
  return sizes;
}

double height_of(const CurveFigure& figure, const Sizes& sizes) {
  const auto count = static_cast<double>(figure.plots.size());
  return std::ceil(sizes.unit * (kTop + count * (kPlotHeight + kPlotGap) - kPlotGap + kBottom));
}

Place place_of(const CurveFigure& figure, std::size_t index, const Sizes& sizes) {
  const CurvePlot& shown = figure.plots[index];
  Place place;
  place.unit = sizes.unit;
  place.sizes = sizes;
  place.x = sizes.left;
  place.y = (kTop + static_cast<double>(index) * (kPlotHeight + kPlotGap)) * place.unit;
  place.w = sizes.width - sizes.left - kRight * place.unit;
  place.h = kPlotHeight * place.unit;
  std::optional<plot::Extent> all;
  for (const FigureLine& line : shown.lines) {
    const std::optional<plot::Extent> one = line.curve->extent(figure.begin_s, figure.end_s);
    if (one) all = all ? plot::Extent{std::min(all->low, one->low), std::max(all->high, one->high)} : *one;
  }
  const plot::Extent range = plot::value_range(all.value_or(plot::Extent{0.0, 1.0}), shown.from_zero, shown.limits);
  place.time = plot::axis_over(figure.begin_s, figure.end_s, place.w, 90.0 * place.unit);
  place.values = plot::axis_over(range.low, range.high, place.h, 30.0 * place.unit);
  return place;
}

/// For print, where the labels take what they need: the widest of all plots beside their left edges.
double left_of(const Canvas& canvas, const CurveFigure& figure, const Sizes& sizes) {
  const TextStyle style{sizes.tick, Weight::kRegular, kQuiet, Align::kRight};
  double widest = 0.0;
  for (std::size_t i = 0; i < figure.plots.size(); ++i) {
    for (const std::string& label : place_of(figure, i, sizes).values.labels) {
      widest = std::max(widest, canvas.text_width(label, style));
    }
  }
  return std::ceil(widest + (kLabelGap + kPaperMargin) * sizes.unit);
}

/// With numbers and the name of the axis below, if this is the lowest plot.
void draw_grid(Canvas& canvas, const Place& place, bool lowest, const std::string& axis) {
  const TextStyle style{place.sizes.tick, Weight::kRegular, kQuiet, Align::kRight};
  for (std::size_t i = 0; i < place.values.ticks.size(); ++i) {
    const double y = place.at({place.time.low, place.values.ticks[i]}).y;
    canvas.line({place.x, y}, {place.x + place.w, y}, kGrid, place.sizes.thin);
    canvas.text({place.x - kLabelGap * place.unit, y + 4.0 * place.unit}, place.values.labels[i], style);
  }
  TextStyle below = style;
  below.align = Align::kCentre;
  for (std::size_t i = 0; i < place.time.ticks.size(); ++i) {
    const double x = place.at({place.time.ticks[i], place.values.low}).x;
    canvas.line({x, place.y}, {x, place.y + place.h}, kGrid, place.sizes.thin);
    if (lowest) canvas.text({x, place.y + place.h + 17.0 * place.unit}, place.time.labels[i], below);
  }
  if (lowest) {
    canvas.text({place.x + 0.5 * place.w, place.y + place.h + 36.0 * place.unit}, axis, below);
  }
}

void draw_limit(Canvas& canvas, const Place& place, double limit, bool above, const std::string& words) {
  if (!(limit > place.values.low && limit < place.values.high)) return;
  const double y = place.at({place.time.low, limit}).y;
  const double top = above ? place.y : y;
  const double height = above ? y - place.y : place.y + place.h - y;
  canvas.rectangle(place.x, top, place.w, height, kBeyond);
  canvas.line({place.x, y}, {place.x + place.w, y}, kLimit, place.sizes.thin);
  if (height < 13.0 * place.unit) return;
  canvas.text({place.x + place.w - 5.0 * place.unit, above ? y - 4.0 * place.unit : y + 12.0 * place.unit}, words,
              {place.sizes.limit, Weight::kRegular, kLimit, Align::kRight});
}

/// Cut to the times of the plot; values are within it.
std::vector<Point> cut(const std::vector<plot::CurvePoint>& line, const Place& place) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < line.size(); ++i) {
    plot::CurvePoint point = line[i];
    const bool early = point.x < place.time.low;
    if (early || point.x > place.time.high) {
      const bool has_inner = early ? i + 1 < line.size() : i > 0;
      if (!has_inner) continue;
      const plot::CurvePoint& inner = early ? line[i + 1] : line[i - 1];
      const double edge = early ? place.time.low : place.time.high;
      if (early ? inner.x < edge : inner.x > edge) continue;
      point.y += (inner.y - point.y) * (edge - point.x) / (inner.x - point.x);
      point.x = edge;
    }
    points.push_back(place.at(point));
  }
  return points;
}

void draw_dashed(Canvas& canvas, const std::vector<Point>& points, Rgba colour, double width) {
  const std::array<double, 2> lengths{4.5 * width, 2.5 * width};
  std::vector<Point> piece{points.front()};
  bool down = true;
  double left = lengths[0];
  for (std::size_t i = 1; i < points.size(); ++i) {
    Point at = points[i - 1];
    double way = std::hypot(points[i].x - at.x, points[i].y - at.y);
    for (; way > left; left = lengths[down ? 0 : 1]) {
      const double share = left / way;
      at = {at.x + share * (points[i].x - at.x), at.y + share * (points[i].y - at.y)};
      way -= left;
      piece.push_back(at);
      if (down) canvas.polyline(piece, colour, width);
      piece = {at};
      down = !down;
    }
    left -= way;
    piece.push_back(points[i]);
  }
  if (down && piece.size() > 1) canvas.polyline(piece, colour, width);
}

void draw_lines(Canvas& canvas, const CurvePlot& shown, const Place& place) {
  const double width = place.sizes.line;
  for (std::size_t i = 0; i < shown.lines.size(); ++i) {
    const Rgba colour = kLines[i % kLines.size()];
    const auto columns = static_cast<int>(place.w / place.sizes.finest_px);
    for (const auto& line : shown.lines[i].curve->lines(place.time.low, place.time.high, columns)) {
      const std::vector<Point> points = cut(line, place);
      if (points.size() < 2) continue;
      if (i % 2 == 1) {
        draw_dashed(canvas, points, colour, width);
      } else {
        canvas.polyline(points, colour, width);
      }
    }
  }
}

/// Above the plot: title and unit on the left, the lines' names on the right.
void draw_heading(Canvas& canvas, const CurvePlot& shown, const Place& place) {
  const double y = place.y - 8.0 * place.unit;
  canvas.text({place.x, y}, shown.unit.empty() ? shown.title : fmt::format("{}, {}", shown.title, shown.unit),
              {place.sizes.heading, Weight::kSemiBold, kInk, Align::kLeft});
  double x = place.x + place.w;
  const TextStyle style{place.sizes.tick, Weight::kRegular, kInk, Align::kRight};
  for (std::size_t i = shown.lines.size(); i-- > 0;) {
    canvas.text({x, y}, shown.lines[i].name, style);
    x -= canvas.text_width(shown.lines[i].name, style) + 6.0 * place.unit;
    const std::vector<Point> sample{{x - 28.0 * place.unit, y - 4.0 * place.unit}, {x, y - 4.0 * place.unit}};
    const Rgba colour = kLines[i % kLines.size()];
    if (i % 2 == 1) {
      draw_dashed(canvas, sample, colour, place.sizes.line);
    } else {
      canvas.polyline(sample, colour, place.sizes.line);
    }
    x -= 44.0 * place.unit;
  }
}

void draw(Canvas& canvas, const CurveFigure& figure, const Sizes& sizes) {
  TROCAR_CHECK(figure.begin_s < figure.end_s);
  const double unit = sizes.unit;
  canvas.rectangle(0.0, 0.0, sizes.width, height_of(figure, sizes), {255, 255, 255, 255});
  const double right = sizes.width - kRight * unit;
  const TextStyle title{sizes.title, Weight::kSemiBold, kInk, Align::kCentre};
  canvas.text({0.5 * (sizes.left + right), 19.0 * unit}, fitted(canvas, figure.title, title, right - sizes.left),
              title);
  for (std::size_t i = 0; i < figure.plots.size(); ++i) {
    const Place place = place_of(figure, i, sizes);
    draw_grid(canvas, place, i + 1 == figure.plots.size(), figure.axis);
    for (const plot::Band& limit : figure.plots[i].limits) {
      draw_limit(canvas, place, limit.high, true, limit.label);
      draw_limit(canvas, place, limit.low, false, limit.label);
    }
    draw_lines(canvas, figure.plots[i], place);
    canvas.outline(place.x, place.y, place.w, place.h, kQuiet, place.sizes.thin);
    draw_heading(canvas, figure.plots[i], place);
  }
}

Sizes laid_out(const CurveFigure& figure, double dpi) {
  Sizes sizes = sizes_of(figure, dpi);
  if (figure.print) sizes.left = left_of(Canvas(Image(1, 1)), figure, sizes);
  return sizes;
}

}  // namespace

Image draw_curves(const CurveFigure& figure) {
  const Sizes sizes = laid_out(figure, figure.print ? figure.print->dpi : kScreenDpi);
  Canvas canvas(Image(static_cast<int>(sizes.width), static_cast<int>(height_of(figure, sizes)), {255, 255, 255, 255}));
  draw(canvas, figure, sizes);
  return canvas.picture();
}

Status save_curves(const CurveFigure& figure, const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension != ".svg" && extension != ".pdf") {
    return tl::unexpected(
        Error(ErrorCode::kInvalidArgument, "curves are saved as .png, .svg, .pdf or .csv").at(path.string()));
  }
  const Sizes sizes = laid_out(figure, kDrawingDpi);
  const double height = height_of(figure, sizes);
  Canvas canvas = extension == ".pdf" ? Canvas::pdf(sizes.width, height, sizes.pt_per_px)
                  : figure.print      ? Canvas::svg_on_paper(sizes.width, height, sizes.pt_per_px)
                                      : Canvas::svg(sizes.width, height);
  draw(canvas, figure, sizes);
  return canvas.save(path);
}

Status save_curves_csv(const CurveFigure& figure, const std::filesystem::path& path) {
  std::string text = figure.axis_column + ",curve,unit,line,value\n";
  for (const CurvePlot& shown : figure.plots) {
    for (const FigureLine& line : shown.lines) {
      const plot::Curve& curve = *line.curve;
      for (std::size_t i = 0; i < curve.x().size(); ++i) {
        if (curve.x()[i] < figure.begin_s || curve.x()[i] > figure.end_s || !std::isfinite(curve.y()[i])) continue;
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", curve.x()[i], shown.title, shown.unit, line.name,
                       curve.y()[i]);
      }
    }
  }
  return write_file(path, text);
}

}  // namespace trocar::figure
