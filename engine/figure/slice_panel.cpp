#include "engine/figure/slice_panel.h"

#include <algorithm>
#include <vector>

namespace trocar::figure {
namespace {

constexpr Rgba kSafeLine{20, 20, 24, 255};
constexpr Rgba kGoalFill{255, 200, 60, 255};
// Light around dark, so that the line is seen on either end of every map.
constexpr Rgba kSafeHalo{255, 255, 255, 190};

/// Between two numbers of thin lines.
double within(double length, double low, double high, double pen) {
  return std::clamp(length, low * pen, high * pen);
}

/// Runs of one colour become one rectangle, so that an SVG stays small. Each reaches a little under its right and lower
/// neighbour, or viewers show the paper between them.
void draw_cells(canvas::Canvas& canvas, const Image& pixels, const PanelPlace& place) {
  const double overlap = 0.35 * place.pen_px;
  for (int row = 0; row < pixels.height; ++row) {
    for (int column = 0; column < pixels.width;) {
      const Rgba colour = pixels.at(column, row);
      int end = column + 1;
      while (end < pixels.width && pixels.at(end, row) == colour) ++end;
      if (colour.a != 0) {
        const double right = end < pixels.width ? overlap : 0.0;
        const double below = row + 1 < pixels.height ? overlap : 0.0;
        canvas.rectangle(place.x + column * place.cell_px, place.y + row * place.cell_px,
                         (end - column) * place.cell_px + right, place.cell_px + below, colour);
      }
      column = end;
    }
  }
}

void draw_unknown(canvas::Canvas& canvas, const Image& pixels, const PanelPlace& place) {
  const double side = pixels.width * place.cell_px;
  canvas.rectangle(place.x, place.y, side, side, kHatchGround);
  canvas.hatch(place.x, place.y, side, side, kHatchInk, within(0.3 * place.cell_px, 3.0, 7.0, place.pen_px),
               place.pen_px);
}

struct Edge {
  canvas::Point a;
  canvas::Point b;
};

/// The edges between cells of which one is in the set and the other is not; neighbouring ones are one line.
std::vector<Edge> outline_of(const learning::Field& field, const spatial::CellSet& safe, const Slice& slice,
                             const PanelPlace& place) {
  const int n = field.grid.n;
  const auto inside = [&](int column, int row) {
    return column >= 0 && row >= 0 && column < n && row < n && safe.contains(cell_at(field.grid, slice, {column, row}));
  };
  const auto corner = [&](int column, int row) {
    return canvas::Point{place.x + column * place.cell_px, place.y + row * place.cell_px};
  };
  std::vector<Edge> edges;
  for (int line = 0; line <= n; ++line) {
    int row_begin = -1;
    int column_begin = -1;
    for (int at = 0; at <= n; ++at) {
      const bool row_edge = at < n && inside(at, line - 1) != inside(at, line);
      if (!row_edge && row_begin >= 0) edges.push_back({corner(row_begin, line), corner(at, line)});
      row_begin = !row_edge ? -1 : row_begin < 0 ? at : row_begin;
      const bool column_edge = at < n && inside(line - 1, at) != inside(line, at);
      if (!column_edge && column_begin >= 0) edges.push_back({corner(line, column_begin), corner(line, at)});
      column_begin = !column_edge ? -1 : column_begin < 0 ? at : column_begin;
    }
  }
  return edges;
}

void draw_outline(canvas::Canvas& canvas, const std::vector<Edge>& edges, const PanelPlace& place) {
  const double width = within(0.09 * place.cell_px, 1.0, 2.5, place.pen_px);
  for (const Edge& edge : edges) canvas.line(edge.a, edge.b, kSafeHalo, width + 2.0 * place.pen_px);
  for (const Edge& edge : edges) draw_safe_line(canvas, edge.a, edge.b, width);
}

void draw_path(canvas::Canvas& canvas, const learning::Field& field, const learning::CellSequence& path,
               const Slice& slice, const PanelPlace& place) {
  learning::CellSequence cells = path;
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  for (const spatial::CellIndex cell : cells) {
    const std::optional<FlatCell> at = flat_cell(field.grid, slice, cell);
    if (!at) continue;
    draw_path_mark(canvas, {place.x + (at->column + 0.5) * place.cell_px, place.y + (at->row + 0.5) * place.cell_px},
                   within(0.24 * place.cell_px, 1.0, 6.0, place.pen_px), place.pen_px);
  }
}

void draw_ends(canvas::Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options,
               const Slice& slice, const PanelPlace& place) {
  // Larger than a small cell: the two ends are what is looked for in a montage.
  const double radius = within(0.42 * place.cell_px, 4.0, 10.0, place.pen_px);
  const auto centre = [&](const std::optional<spatial::CellIndex>& cell) -> std::optional<canvas::Point> {
    const std::optional<FlatCell> at = cell ? flat_cell(field.grid, slice, *cell) : std::nullopt;
    if (!at) return std::nullopt;
    return canvas::Point{place.x + (at->column + 0.5) * place.cell_px, place.y + (at->row + 0.5) * place.cell_px};
  };
  if (const auto at = centre(options.start)) draw_start_mark(canvas, *at, radius, place.pen_px);
  if (const auto at = centre(options.goal)) draw_goal_mark(canvas, *at, radius, place.pen_px);
}

}  // namespace

void draw_start_mark(canvas::Canvas& canvas, canvas::Point centre, double radius, double pen) {
  const double rim = std::max(pen, 0.22 * radius);
  const double half = 0.78 * radius;
  canvas.rectangle(centre.x - half - rim, centre.y - half - rim, 2 * (half + rim), 2 * (half + rim), kInk);
  canvas.rectangle(centre.x - half, centre.y - half, 2 * half, 2 * half, kPaper);
}

void draw_goal_mark(canvas::Canvas& canvas, canvas::Point centre, double radius, double pen) {
  const auto diamond = [&centre](double reach) {
    return std::vector<canvas::Point>{{centre.x, centre.y - reach},
                                      {centre.x + reach, centre.y},
                                      {centre.x, centre.y + reach},
                                      {centre.x - reach, centre.y}};
  };
  canvas.polygon(diamond(1.15 * radius + std::max(1.4 * pen, 0.31 * radius)), kInk);
  canvas.polygon(diamond(1.15 * radius), kGoalFill);
}

void draw_path_mark(canvas::Canvas& canvas, canvas::Point centre, double radius, double pen) {
  canvas.circle(centre, radius + std::max(0.7 * pen, 0.22 * radius), kInk);
  canvas.circle(centre, radius, kPaper);
}

void draw_safe_line(canvas::Canvas& canvas, canvas::Point a, canvas::Point b, double width) {
  canvas.line(a, b, kSafeLine, width);
}

void draw_panel(canvas::Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options,
                const plot::Colouring& colouring, const Slice& slice, const PanelPlace& place) {
  const Image pixels = slice_pixels(field, slice, colouring);
  draw_unknown(canvas, pixels, place);
  draw_cells(canvas, pixels, place);
  if (!options.safe.empty()) draw_outline(canvas, outline_of(field, options.safe, slice, place), place);
  draw_path(canvas, field, options.path, slice, place);
  draw_ends(canvas, field, options, slice, place);
  const double side = pixels.width * place.cell_px;
  canvas.outline(place.x, place.y, side, side, kInk, place.pen_px);
}

}  // namespace trocar::figure
