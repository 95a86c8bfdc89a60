#include "engine/figure/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/figure/key.h"
#include "engine/figure/slice_panel.h"
#include "engine/spatial/units.h"

namespace trocar::figure {
namespace {

using canvas::Align;
using canvas::Canvas;
using canvas::TextStyle;
using canvas::Weight;

constexpr double kTitle = 24.0;
constexpr double kText = 15.0;
constexpr double kTick = 14.0;
constexpr double kLine = 21.0;
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

/// Shortens from the end until it fits.
std::string fitted(const Canvas& canvas, std::string text, const TextStyle& letters, double width) {
  if (canvas.text_width(text, letters) <= width) return text;
  const auto is_inside_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  while (!text.empty() && canvas.text_width(text + "…", letters) > width) {
    while (text.size() > 1 && is_inside_letter(text.back())) text.pop_back();
    text.pop_back();
  }
  return text + "…";
}

void draw_horizontal_axis(Canvas& canvas, const spatial::Grid& grid, int axis, const PanelPlace& place, double unit) {
  const ExtentMm extent = extent_mm(grid, axis);
  const double side = grid.n * place.cell_px;
  const double bottom = place.y + side;
  const int count = std::clamp(static_cast<int>(side / (55.0 * unit)), 3, 8);
  const std::vector<double> at = plot::ticks(extent.low, extent.high, count);
  const double step = at.size() > 1 ? at[1] - at[0] : 1.0;
  for (const double mm : at) {
    const double x = place.x + side * (mm - extent.low) / (extent.high - extent.low);
    canvas.line({x, bottom}, {x, bottom + 5 * unit}, kInk, 1.0);
    canvas.text({x, bottom + 21 * unit}, plot::format_tick(mm, step),
                style(kTick * unit, Weight::kRegular, kInk, Align::kCentre));
  }
  canvas.text({place.x + side / 2, bottom + 43 * unit},
              fmt::format("{} (mm)", kAxisLetters[static_cast<std::size_t>(axis)]),
              style(kText * unit, Weight::kRegular, kInk, Align::kCentre));
}

void draw_vertical_axis(Canvas& canvas, const spatial::Grid& grid, int axis, const PanelPlace& place, double unit) {
  const ExtentMm extent = extent_mm(grid, axis);
  const double side = grid.n * place.cell_px;
  const int count = std::clamp(static_cast<int>(side / (55.0 * unit)), 3, 8);
  const std::vector<double> at = plot::ticks(extent.low, extent.high, count);
  const double step = at.size() > 1 ? at[1] - at[0] : 1.0;
  for (const double mm : at) {
    const double y = place.y + side * (extent.high - mm) / (extent.high - extent.low);
    canvas.line({place.x - 5 * unit, y}, {place.x, y}, kInk, 1.0);
    canvas.text({place.x - 9 * unit, y + 0.36 * kTick * unit}, plot::format_tick(mm, step),
                style(kTick * unit, Weight::kRegular, kInk, Align::kRight));
  }
  // Upright and above the axis: read without turning the head.
  canvas.text({place.x - 9 * unit, place.y - 12 * unit},
              fmt::format("{} (mm)", kAxisLetters[static_cast<std::size_t>(axis)]),
              style(kText * unit, Weight::kRegular, kInk, Align::kRight));
}

PanelPlace place_of(const Layout& layout, int panel) {
  const int column = panel % layout.columns;
  const int row = panel / layout.columns;
  return {static_cast<double>(layout.left + column * (layout.panel_px + layout.gap_x)),
          static_cast<double>(layout.top + row * (layout.panel_px + layout.gap_y)),
          static_cast<double>(layout.cell_px)};
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
  for (const double size : {13.0, 11.5}) {
    const TextStyle bold = style(size * layout.unit, Weight::kSemiBold, kInk, Align::kLeft);
    const TextStyle regular = style(size * layout.unit, Weight::kRegular, kQuiet, Align::kRight);
    double widest = 0.0;
    for (int k = 0; k < grid.n; ++k) {
      widest =
          std::max(widest, canvas.text_width(index_text(k), bold) + canvas.text_width(height_text(grid, k), regular));
    }
    if (widest + 0.8 * size * layout.unit <= layout.panel_px) return {size * layout.unit, true};
  }
  return {13.0 * layout.unit, false};
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
  draw_horizontal_axis(canvas, field.grid, axes.horizontal, corner, layout.unit);
  draw_vertical_axis(canvas, field.grid, axes.vertical, corner, layout.unit);
}

/// The title, whose field it is, and where its cells are.
void draw_head(Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options, const Layout& layout) {
  const double u = layout.unit;
  const double room = layout.width - 56 * u;
  const TextStyle large = style(kTitle * u, Weight::kBold, kInk, Align::kLeft);
  canvas.text({28 * u, 44 * u}, fitted(canvas, field.title, large, room), large);
  double base = 69 * u;
  const auto line = [&](const std::string& words, Rgba colour) {
    const TextStyle letters = style(kText * u, Weight::kRegular, colour, Align::kLeft);
    canvas.text({28 * u, base}, fitted(canvas, words, letters, room), letters);
    base += kLine * u;
  };
  if (!options.subtitle.empty()) line(options.subtitle, kInk);
  line(place_line(field, options), kQuiet);
}

}  // namespace

Layout layout_of(const learning::Field& field, const FieldFigureOptions& options, const plot::Colouring& colouring) {
  Layout layout;
  const int n = field.grid.n;
  layout.width = std::max(320, options.width_px);
  layout.unit = std::max(layout.width / 1000.0, kLeastUnit);
  const auto px = [&](double at_1000) { return static_cast<int>(std::lround(at_1000 * layout.unit)); };
  const bool montage = !options.slice.has_value();
  layout.panels = montage ? n : 1;
  layout.columns = montage ? std::max(1, static_cast<int>(std::ceil(std::sqrt(1.5 * n)))) : 1;
  layout.rows = (layout.panels + layout.columns - 1) / layout.columns;
  layout.left = px(84);
  layout.top = px((montage ? 116 : 122) + (options.subtitle.empty() ? 0.0 : kLine));
  layout.gap_x = montage ? px(14) : 0;
  layout.gap_y = montage ? px(32) : 0;
  const Canvas measure(Image(1, 1));
  const int key = static_cast<int>(key_width(measure, field, options, colouring, layout.unit));
  const int room = layout.width - layout.left - px(32) - key - px(28) - (layout.columns - 1) * layout.gap_x;
  layout.cell_px = std::max(2, room / (layout.columns * n));
  layout.panel_px = layout.cell_px * n;
  // What whole pixels leave over goes between the panels.
  if (layout.columns > 1) layout.gap_x += std::max(0, room - layout.columns * layout.panel_px) / (layout.columns - 1);
  const int grid_width = layout.columns * layout.panel_px + (layout.columns - 1) * layout.gap_x;
  layout.key_x = layout.left + grid_width + px(32);
  layout.width = std::max(layout.width, layout.key_x + key + px(28));
  layout.height = layout.top + layout.rows * layout.panel_px + (layout.rows - 1) * layout.gap_y + px(66);
  return layout;
}

void draw_figure(Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options,
                 const plot::Colouring& colouring, const Layout& layout) {
  const double u = layout.unit;
  canvas.rectangle(0, 0, layout.width, layout.height, kPaper);
  draw_head(canvas, field, options, layout);
  if (options.slice) {
    const PanelPlace place = place_of(layout, 0);
    draw_panel(canvas, field, options, colouring, *options.slice, place);
    const FlatAxes axes = flat_axes(*options.slice);
    draw_horizontal_axis(canvas, field.grid, axes.horizontal, place, u);
    draw_vertical_axis(canvas, field.grid, axes.vertical, place, u);
  } else {
    draw_montage(canvas, field, options, colouring, layout);
  }
  const int grid_height = layout.rows * layout.panel_px + (layout.rows - 1) * layout.gap_y;
  draw_key(canvas, field, options, colouring,
           {static_cast<double>(layout.key_x), static_cast<double>(layout.top), static_cast<double>(grid_height), u});
}

}  // namespace trocar::figure
