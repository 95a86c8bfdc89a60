#include "engine/figure/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/fitted_text.h"
#include "engine/figure/key.h"
#include "engine/figure/slice_panel.h"
#include "engine/spatial/units.h"

namespace trocar::figure {
namespace {

using canvas::Align;
using canvas::Canvas;
using canvas::TextStyle;
using canvas::Weight;

constexpr double kLine = 21.0;
constexpr double kTextAtUnit = 15.0;  // Letters of running text at a unit of 1.
constexpr double kMargin = 28.0;
constexpr double kPaperMargin = 4.0;  // The page around a printed figure has its own.
constexpr double kAxisBelow = 48.0;   // From a panel to the end of its axis' title.
constexpr double kThinLine_pt = 0.5;
constexpr double kLeastUnit = 0.6;  // Smaller letters cannot be read.

TextStyle style(double size, Weight weight, Rgba colour, Align align) {
  return {size, weight, colour, align};
}

/// To a hundredth, without zeros at the end, with a true minus.
std::string number_mm(double mm) {
  const double rounded = std::round(mm * 100.0) / 100.0;
  std::string text = fmt::format("{}", std::abs(rounded));
  return rounded < 0.0 ? std::string(plot::unicode_minus()) + text : text;
}

/// Where the cells of the figure are.
std::string place_line(const learning::Field& field, const FieldFigureOptions& options) {
  const spatial::Grid& grid = field.grid;
  std::string where;
  if (options.slice) {
    where = fmt::format("slice {} = {}, at {} mm", kAxisLetters[static_cast<std::size_t>(options.slice->axis)],
                        options.slice->index, number_mm(position_mm(grid, *options.slice)));
  } else {
    where = fmt::format("{} slices along z, from {} to {} mm", grid.n, number_mm(position_mm(grid, {2, 0})),
                        number_mm(position_mm(grid, {2, grid.n - 1})));
  }
  return where +
         fmt::format(", lattice of {0} × {0} × {0} cells of {1} mm", grid.n, number_mm(spatial::to_mm(grid.cell_m)));
}

std::string axis_title(int axis) {
  return fmt::format("{} (mm)", kAxisLetters[static_cast<std::size_t>(axis)]);
}

struct AxisTicks {
  std::vector<double> at_mm;
  std::vector<std::string> labels;
};

AxisTicks axis_ticks(const ExtentMm& extent, int count) {
  AxisTicks ticks{plot::ticks(extent.low, extent.high, count), {}};
  const double step = ticks.at_mm.size() > 1 ? ticks.at_mm[1] - ticks.at_mm[0] : 1.0;
  for (const double mm : ticks.at_mm) ticks.labels.push_back(plot::format_tick(mm, step));
  return ticks;
}

int wanted_ticks(double side, double unit) {
  return std::clamp(static_cast<int>(side / (55.0 * unit)), 3, 8);
}

/// As many ticks as their labels have room beside each other.
AxisTicks horizontal_ticks(const Canvas& canvas, const ExtentMm& extent, double side, const Layout& layout) {
  const TextStyle letters = style(layout.letters.tick, Weight::kRegular, kInk, Align::kCentre);
  const double gap = 0.4 * layout.letters.tick;
  AxisTicks ticks;
  for (int count = wanted_ticks(side, layout.unit); count > 0; --count) {
    ticks = axis_ticks(extent, count);
    bool fits = true;
    for (std::size_t i = 1; i < ticks.labels.size(); ++i) {
      const double apart = side * (ticks.at_mm[i] - ticks.at_mm[i - 1]) / (extent.high - extent.low);
      const double wide =
          (canvas.text_width(ticks.labels[i - 1], letters) + canvas.text_width(ticks.labels[i], letters)) / 2;
      fits = fits && wide + gap <= apart;
    }
    if (fits) break;
  }
  return ticks;
}

AxisTicks vertical_ticks(const ExtentMm& extent, double side, const Layout& layout) {
  return axis_ticks(extent, wanted_ticks(side, layout.unit));
}

void draw_horizontal_axis(Canvas& canvas, const spatial::Grid& grid, int axis, const PanelPlace& place,
                          const Layout& layout) {
  const double u = layout.unit;
  const ExtentMm extent = extent_mm(grid, axis);
  const double side = grid.n * place.cell_px;
  const double bottom = place.y + side;
  const AxisTicks ticks = horizontal_ticks(canvas, extent, side, layout);
  for (std::size_t i = 0; i < ticks.at_mm.size(); ++i) {
    const double x = place.x + side * (ticks.at_mm[i] - extent.low) / (extent.high - extent.low);
    canvas.line({x, bottom}, {x, bottom + 5 * u}, kInk, layout.pen_px);
    canvas.text({x, bottom + 21 * u}, ticks.labels[i],
                style(layout.letters.tick, Weight::kRegular, kInk, Align::kCentre));
  }
  canvas.text({place.x + side / 2, bottom + 43 * u}, axis_title(axis),
              style(layout.letters.text, Weight::kRegular, kInk, Align::kCentre));
}

void draw_vertical_axis(Canvas& canvas, const spatial::Grid& grid, int axis, const PanelPlace& place,
                        const Layout& layout) {
  const double u = layout.unit;
  const ExtentMm extent = extent_mm(grid, axis);
  const double side = grid.n * place.cell_px;
  const AxisTicks ticks = vertical_ticks(extent, side, layout);
  for (std::size_t i = 0; i < ticks.at_mm.size(); ++i) {
    const double y = place.y + side * (extent.high - ticks.at_mm[i]) / (extent.high - extent.low);
    canvas.line({place.x - 5 * u, y}, {place.x, y}, kInk, layout.pen_px);
    canvas.text({place.x - 9 * u, y + 0.36 * layout.letters.tick}, ticks.labels[i],
                style(layout.letters.tick, Weight::kRegular, kInk, Align::kRight));
  }
  // Upright and above the axis: read without turning the head.
  canvas.text({place.x - 9 * u, place.y - 12 * u}, axis_title(axis),
              style(layout.letters.text, Weight::kRegular, kInk, Align::kRight));
}

PanelPlace place_of(const Layout& layout, int panel) {
  const int column = panel % layout.columns;
  const int row = panel / layout.columns;
  return {static_cast<double>(layout.left + column * (layout.panel_px + layout.gap_x)),
          static_cast<double>(layout.top + row * (layout.panel_px + layout.gap_y)), static_cast<double>(layout.cell_px),
          layout.pen_px};
}

/// What stands over the panels of a montage: index and height, in letters that let both fit, or the index alone.
struct Heading {
  double size_px = 13.0;
  bool height = true;
};

std::string index_text(int k) {
  return fmt::format("z = {}", k);
}

std::string height_text(const spatial::Grid& grid, int k) {
  return fmt::format("{} mm", number_mm(position_mm(grid, {2, k})));
}

Heading heading_of(const Canvas& canvas, const spatial::Grid& grid, const Layout& layout) {
  for (const double size : {layout.letters.heading, layout.letters.small_heading}) {
    const TextStyle bold = style(size, Weight::kSemiBold, kInk, Align::kLeft);
    const TextStyle regular = style(size, Weight::kRegular, kQuiet, Align::kRight);
    double widest = 0.0;
    for (int k = 0; k < grid.n; ++k) {
      widest =
          std::max(widest, canvas.text_width(index_text(k), bold) + canvas.text_width(height_text(grid, k), regular));
    }
    if (widest + 0.8 * size <= layout.panel_px) return {size, true};
  }
  return {layout.letters.heading, false};
}

void draw_montage(Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options,
                  const plot::Colouring& colouring, const Layout& layout) {
  const Heading heading = heading_of(canvas, field.grid, layout);
  for (int k = 0; k < layout.panels; ++k) {
    const PanelPlace place = place_of(layout, k);
    draw_panel(canvas, field, options, colouring, {2, k}, place);
    const double base = place.y - 6 * layout.unit;
    canvas.text({place.x, base}, index_text(k), style(heading.size_px, Weight::kSemiBold, kInk, Align::kLeft));
    if (!heading.height) continue;
    canvas.text({place.x + layout.panel_px, base}, height_text(field.grid, k),
                style(heading.size_px, Weight::kRegular, kQuiet, Align::kRight));
  }
  const FlatAxes axes = flat_axes(Slice{2, 0});
  const PanelPlace corner = place_of(layout, (layout.rows - 1) * layout.columns);
  draw_horizontal_axis(canvas, field.grid, axes.horizontal, corner, layout);
  draw_vertical_axis(canvas, field.grid, axes.vertical, corner, layout);
}

/// The title, whose field it is, and where its cells are.
void draw_head(Canvas& canvas, const learning::Field& field, const Layout& layout) {
  const double u = layout.unit;
  const TextStyle large = style(layout.letters.title, Weight::kBold, kInk, Align::kLeft);
  const TextStyle letters = style(layout.letters.text, Weight::kRegular, kInk, Align::kLeft);
  double base = layout.margin + 16 * u;
  canvas.text({layout.margin, base}, fitted(canvas, field.title, large, layout.width - 2 * layout.margin), large);
  base += 25 * u;
  for (const HeadLine& line : layout.head) {
    TextStyle coloured = letters;
    coloured.colour = line.quiet ? kQuiet : kInk;
    canvas.text({layout.margin, base}, line.text, coloured);
    base += kLine * u;
  }
}

/// Whole lines on a screen, where there is room; for print, as many as they need.
std::vector<HeadLine> head_of(const Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options,
                              const Layout& layout) {
  const TextStyle letters = style(layout.letters.text, Weight::kRegular, kInk, Align::kLeft);
  const double room = layout.width - 2 * layout.margin;
  std::vector<HeadLine> lines;
  const auto add = [&](const std::string& text, bool quiet) {
    if (!options.print) lines.push_back({fitted(canvas, text, letters, room), quiet});
    if (!options.print) return;
    for (std::string& line : wrapped(canvas, text, letters, room)) lines.push_back({std::move(line), quiet});
  };
  if (!options.subtitle.empty()) add(options.subtitle, false);
  add(place_line(field, options), true);
  return lines;
}

/// Width, letters and lines, before anything is placed.
Layout look_of(const FieldFigureOptions& options, Medium medium) {
  Layout layout;
  if (!options.print) {
    layout.width = std::max(320, options.width_px);
    layout.unit = std::max(layout.width / 1000.0, kLeastUnit);
    layout.pt_per_px = pt_per_px(kScreenDpi);
    layout.margin = kMargin * layout.unit;
    for (double* size : {&layout.letters.title, &layout.letters.text, &layout.letters.tick, &layout.letters.heading,
                         &layout.letters.small_heading}) {
      *size *= layout.unit;
    }
    return layout;
  }
  const double dpi = medium == Medium::kDrawing ? kDrawingDpi : options.print->dpi;
  layout.pt_per_px = pt_per_px(dpi);
  layout.width = static_cast<int>(std::lround(options.print->width_mm * px_per_mm(dpi)));
  const double letter = options.print->text_pt / layout.pt_per_px;
  layout.letters = {letter, letter, letter, letter, letter};
  layout.unit = letter / kTextAtUnit;
  layout.pen_px = kThinLine_pt / layout.pt_per_px;
  layout.margin = kPaperMargin * layout.unit;
  return layout;
}

KeyLook key_look(const Layout& layout) {
  return {layout.unit, layout.letters.tick, layout.pen_px, kInk};
}

/// Left of the panels: the labels of the vertical axis, whatever they are.
int room_for_axis(const Canvas& canvas, const spatial::Grid& grid, int axis, const Layout& layout) {
  double widest = canvas.text_width(axis_title(axis), style(layout.letters.text, Weight::kRegular, kInk, Align::kLeft));
  const TextStyle letters = style(layout.letters.tick, Weight::kRegular, kInk, Align::kLeft);
  for (int count = 3; count <= 8; ++count) {
    for (const std::string& label : axis_ticks(extent_mm(grid, axis), count).labels) {
      widest = std::max(widest, canvas.text_width(label, letters));
    }
  }
  return static_cast<int>(std::ceil(layout.margin + widest + 9 * layout.unit));
}

/// For print, where letters do not shrink with the panels: as many columns as headings have room beside each other.
int columns_for(const Canvas& canvas, const spatial::Grid& grid, const Layout& layout, double room) {
  const TextStyle bold = style(layout.letters.heading, Weight::kSemiBold, kInk, Align::kLeft);
  const double widest = canvas.text_width(index_text(grid.n - 1), bold) + 0.5 * layout.letters.heading;
  const int most = static_cast<int>((room + layout.gap_x) / (widest + layout.gap_x));
  return std::clamp(most, 1, layout.columns);
}

}  // namespace

Layout layout_of(const learning::Field& field, const FieldFigureOptions& options, const plot::Colouring& colouring,
                 Medium medium) {
  const Canvas measure(Image(1, 1));
  Layout layout = look_of(options, medium);
  const bool print = options.print.has_value();
  const int n = field.grid.n;
  const auto px = [&](double at_1000) { return static_cast<int>(std::lround(at_1000 * layout.unit)); };
  const bool montage = !options.slice.has_value();
  layout.head = head_of(measure, field, options, layout);
  layout.panels = montage ? n : 1;
  layout.columns = montage ? std::max(1, static_cast<int>(std::ceil(std::sqrt(1.5 * n)))) : 1;
  const FlatAxes axes = flat_axes(options.slice.value_or(Slice{2, 0}));
  layout.left = print ? room_for_axis(measure, field.grid, axes.vertical, layout) : px(84);
  layout.top =
      px(layout.margin / layout.unit + (montage ? 88 : 94) + kLine * (static_cast<double>(layout.head.size()) - 1.0));
  layout.gap_x = montage ? px(14) : 0;
  layout.gap_y = montage ? px(32) : 0;
  const int margin = static_cast<int>(std::lround(layout.margin));
  const int key = static_cast<int>(key_width(measure, field, options, colouring, key_look(layout)));
  layout.key_x = layout.width - margin - key;
  const int all = layout.key_x - px(32) - layout.left;
  if (print && montage) layout.columns = columns_for(measure, field.grid, layout, all);
  layout.rows = (layout.panels + layout.columns - 1) / layout.columns;
  const int room = all - (layout.columns - 1) * layout.gap_x;
  layout.cell_px = std::max(print ? 1 : 2, room / (layout.columns * n));
  layout.panel_px = layout.cell_px * n;
  // What whole pixels leave over goes between the panels.
  if (layout.columns > 1) layout.gap_x += std::max(0, room - layout.columns * layout.panel_px) / (layout.columns - 1);
  const int grid_width = layout.columns * layout.panel_px + (layout.columns - 1) * layout.gap_x;
  layout.key_x = layout.left + grid_width + px(32);
  layout.width = std::max(layout.width, layout.key_x + key + margin);
  layout.height = layout.top + layout.rows * layout.panel_px + (layout.rows - 1) * layout.gap_y +
                  px(print ? kAxisBelow + layout.margin / layout.unit : 66.0);
  return layout;
}

void draw_figure(Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options,
                 const plot::Colouring& colouring, const Layout& layout) {
  canvas.rectangle(0, 0, layout.width, layout.height, options.ground);
  draw_head(canvas, field, layout);
  if (options.slice) {
    const PanelPlace place = place_of(layout, 0);
    draw_panel(canvas, field, options, colouring, *options.slice, place);
    const FlatAxes axes = flat_axes(*options.slice);
    draw_horizontal_axis(canvas, field.grid, axes.horizontal, place, layout);
    draw_vertical_axis(canvas, field.grid, axes.vertical, place, layout);
  } else {
    draw_montage(canvas, field, options, colouring, layout);
  }
  const int grid_height = layout.rows * layout.panel_px + (layout.rows - 1) * layout.gap_y;
  draw_key(canvas, field, options, colouring,
           {static_cast<double>(layout.key_x), static_cast<double>(layout.top), static_cast<double>(grid_height),
            key_look(layout)});
}

}  // namespace trocar::figure
