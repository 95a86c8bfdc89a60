#include "engine/figure/curve_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "engine/canvas/canvas.h"
#include "engine/core/check.h"
#include "engine/core/ending.h"
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
/// Of Okabe and Ito: blue, vermilion, green, purple, orange, sky.
constexpr std::array<Rgba, 6> kLines{Rgba{0, 114, 178, 255},   Rgba{213, 94, 0, 255},  Rgba{0, 158, 115, 255},
                                     Rgba{204, 121, 167, 255}, Rgba{230, 159, 0, 255}, Rgba{86, 180, 233, 255}};
constexpr std::uint8_t kBandAlpha = 56;

constexpr double kPlotHeight = 150.0;  // All at a width of 1000 pixels.
constexpr double kPlotGap = 34.0;
constexpr double kTop = 44.0;
constexpr double kLeft = 72.0;
constexpr double kRight = 22.0;
constexpr double kBottom = 46.0;
constexpr double kLabelGap = 7.0;
constexpr double kPaperMargin = 4.0;
constexpr double kTickAtUnit = 12.0;
constexpr double kNameAfter = 34.0;  // From the beginning of a piece of line to its name …
constexpr double kNameGap = 10.0;    // … and from the name to the next.
constexpr double kNameRow = 17.0;
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
  std::size_t name_rows = 0;  ///< Above the first plot, where its lines' names have no room beside its heading.
  double finest_px = 1.0;     ///< Below which curves need no detail.
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
  return std::ceil(sizes.unit * (kTop + kNameRow * static_cast<double>(sizes.name_rows) +
                                 count * (kPlotHeight + kPlotGap) - kPlotGap + kBottom));
}

Place place_of(const CurveFigure& figure, std::size_t index, const Sizes& sizes) {
  const CurvePlot& shown = figure.plots[index];
  Place place;
  place.unit = sizes.unit;
  place.sizes = sizes;
  place.x = sizes.left;
  place.y =
      (kTop + kNameRow * static_cast<double>(sizes.name_rows) + static_cast<double>(index) * (kPlotHeight + kPlotGap)) *
      place.unit;
  place.w = sizes.width - sizes.left - kRight * place.unit;
  place.h = kPlotHeight * place.unit;
  std::optional<plot::Extent> all;
  for (const FigureLine& line : shown.lines) {
    std::vector<const plot::Curve*> curves{line.curve.get()};
    for (const BandAround& band : line.bands) curves.insert(curves.end(), {band.low.get(), band.high.get()});
    for (const plot::Curve* curve : curves) {
      const std::optional<plot::Extent> one = curve->extent(figure.begin_s, figure.end_s);
      if (one) all = all ? plot::Extent{std::min(all->low, one->low), std::max(all->high, one->high)} : *one;
    }
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

/// Up along the upper edge and back along the lower one. A band has no gaps.
void draw_band(Canvas& canvas, const BandAround& band, Rgba colour, const Place& place) {
  const auto columns = static_cast<int>(place.w / place.sizes.finest_px);
  const auto edge = [&](const plot::Curve& curve) {
    const auto lines = curve.lines(place.time.low, place.time.high, columns);
    return lines.empty() ? std::vector<Point>() : cut(lines.front(), place);
  };
  std::vector<Point> around = edge(*band.high);
  const std::vector<Point> below = edge(*band.low);
  around.insert(around.end(), below.rbegin(), below.rend());
  colour.a = kBandAlpha;
  if (around.size() > 2) canvas.polygon(around, colour);
}

void draw_lines(Canvas& canvas, const CurvePlot& shown, const Place& place) {
  const double width = place.sizes.line;
  for (std::size_t i = 0; i < shown.lines.size(); ++i) {
    for (const BandAround& band : shown.lines[i].bands) draw_band(canvas, band, kLines[i % kLines.size()], place);
  }
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

std::string heading_of(const CurvePlot& shown) {
  return shown.unit.empty() ? shown.title : fmt::format("{}, {}", shown.title, shown.unit);
}

/// A piece of the line, and its name behind it.
void draw_name(Canvas& canvas, std::size_t i, Point at, const std::string& name, const Sizes& sizes) {
  const double unit = sizes.unit;
  const std::vector<Point> sample{{at.x, at.y - 4.0 * unit}, {at.x + 28.0 * unit, at.y - 4.0 * unit}};
  const Rgba colour = kLines[i % kLines.size()];
  if (i % 2 == 1) {
    draw_dashed(canvas, sample, colour, sizes.line);
  } else {
    canvas.polyline(sample, colour, sizes.line);
  }
  canvas.text({at.x + kNameAfter * unit, at.y}, name, {sizes.tick, Weight::kRegular, kInk, Align::kLeft});
}

/// What the names take beside the heading, each with its piece of line.
double names_width(const Canvas& canvas, const CurvePlot& shown, const Sizes& sizes) {
  const TextStyle style{sizes.tick, Weight::kRegular, kInk, Align::kLeft};
  double width = 0.0;
  for (const FigureLine& line : shown.lines) {
    width += canvas.text_width(line.name, style) + (kNameAfter + kNameGap) * sizes.unit;
  }
  return width;
}

/// Above the plot: title and unit on the left, the lines' names on the right, or above where there is no room.
void draw_heading(Canvas& canvas, const CurvePlot& shown, const Place& place, bool first) {
  const double unit = place.unit;
  const double y = place.y - 8.0 * unit;
  canvas.text({place.x, y}, heading_of(shown), {place.sizes.heading, Weight::kSemiBold, kInk, Align::kLeft});
  const TextStyle style{place.sizes.tick, Weight::kRegular, kInk, Align::kLeft};
  double x = place.x + place.w - names_width(canvas, shown, place.sizes) + kNameGap * unit;
  for (std::size_t i = 0; i < shown.lines.size(); ++i) {
    if (place.sizes.name_rows > 0) {
      if (!first) continue;
      const double above = static_cast<double>(place.sizes.name_rows) - static_cast<double>(i);
      const double room = place.w - kNameAfter * unit;
      draw_name(canvas, i, {place.x, y - above * kNameRow * unit}, fitted(canvas, shown.lines[i].name, style, room),
                place.sizes);
    } else {
      draw_name(canvas, i, {x, y}, shown.lines[i].name, place.sizes);
      x += canvas.text_width(shown.lines[i].name, style) + (kNameAfter + kNameGap) * unit;
    }
  }
}

void draw(Canvas& canvas, const CurveFigure& figure, const Sizes& sizes) {
  TROCAR_CHECK(figure.begin_s < figure.end_s);
  const double unit = sizes.unit;
  canvas.rectangle(0.0, 0.0, sizes.width, height_of(figure, sizes), figure.ground);
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
    draw_heading(canvas, figure.plots[i], place, i == 0);
  }
}

/// A cell of a CSV; names are the user's.
std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

bool names_alike(const CurvePlot& a, const CurvePlot& b) {
  return std::equal(a.lines.begin(), a.lines.end(), b.lines.begin(), b.lines.end(),
                    [](const FigureLine& one, const FigureLine& other) { return one.name == other.name; });
}

Sizes laid_out(const CurveFigure& figure, double dpi) {
  Sizes sizes = sizes_of(figure, dpi);
  const Canvas canvas(Image(1, 1));
  if (figure.print) sizes.left = left_of(canvas, figure, sizes);
  const CurvePlot& first = figure.plots.front();
  const TextStyle bold{sizes.heading, Weight::kSemiBold, kInk, Align::kLeft};
  const double room = sizes.width - sizes.left - kRight * sizes.unit;
  bool short_of_room = false;
  for (const CurvePlot& each : figure.plots) {
    if (!names_alike(each, first)) return sizes;
    short_of_room |= canvas.text_width(heading_of(each), bold) + names_width(canvas, each, sizes) > room;
  }
  if (short_of_room) sizes.name_rows = first.lines.size();
  return sizes;
}

}  // namespace

Image draw_curves(const CurveFigure& figure) {
  const Sizes sizes = laid_out(figure, figure.print ? figure.print->dpi : kScreenDpi);
  Canvas canvas(Image(static_cast<int>(sizes.width), static_cast<int>(height_of(figure, sizes)), figure.ground));
  draw(canvas, figure, sizes);
  return canvas.picture();
}

Status save_curves(const CurveFigure& figure, const std::filesystem::path& path) {
  const std::string extension = ending_of(path);
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
  const auto add = [&](const CurvePlot& shown, const std::string& name, const plot::Curve* curve) {
    if (curve == nullptr) return;
    for (std::size_t i = 0; i < curve->x().size(); ++i) {
      if (curve->x()[i] < figure.begin_s || curve->x()[i] > figure.end_s || !std::isfinite(curve->y()[i])) continue;
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", curve->x()[i], csv_cell(shown.title), shown.unit,
                     csv_cell(name), curve->y()[i]);
    }
  };
  for (const CurvePlot& shown : figure.plots) {
    for (const FigureLine& line : shown.lines) {
      add(shown, line.name, line.curve.get());
      for (const BandAround& band : line.bands) {
        add(shown, line.name + " " + band.low_name, band.low.get());
        add(shown, line.name + " " + band.high_name, band.high.get());
      }
    }
  }
  return write_file(path, text);
}

}  // namespace trocar::figure
