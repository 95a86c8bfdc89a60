#include "engine/figure/key.h"

#include <algorithm>
#include <cmath>

namespace trocar::figure {
namespace {

using canvas::Canvas;
using canvas::TextStyle;

constexpr double kBarWidth = 18.0;
constexpr double kPoint = 11.0;
constexpr double kTickLength = 5.0;
constexpr double kGap = 7.0;
constexpr double kRow = 24.0;
constexpr double kSwatch = 15.0;

TextStyle label_style(const KeyLook& look) {
  return {look.text_px, canvas::Weight::kRegular, look.ink, canvas::Align::kLeft};
}

struct BarTicks {
  std::vector<double> values;
  std::vector<std::string> labels;
};

constexpr int kMostTicks = 7;

/// How many labels have room one above the other.
int tick_count(double height, const KeyLook& look) {
  return std::clamp(static_cast<int>(height / (1.7 * look.text_px)), 2, kMostTicks);
}

BarTicks bar_ticks(const plot::Scale& scale, int count) {
  BarTicks bar;
  bar.values = plot::ticks(scale, count);
  bar.labels = plot::format_ticks(scale, bar.values);
  return bar;
}

/// The marks that this figure has, from the top.
enum class Mark { kStart, kGoal, kPath, kSafe, kUnknown };
struct MarkRow {
  Mark mark;
  const char* text;
};
std::vector<MarkRow> mark_rows(const learning::Field& field, const FieldFigureOptions& options) {
  std::vector<MarkRow> rows;
  if (options.start) rows.push_back({Mark::kStart, "start"});
  if (options.goal) rows.push_back({Mark::kGoal, "goal"});
  if (!options.path.empty()) rows.push_back({Mark::kPath, "expert"});
  if (!options.safe.empty()) rows.push_back({Mark::kSafe, "safe set"});
  const bool whole = std::all_of(field.values.begin(), field.values.end(), [](double v) { return std::isfinite(v); });
  if (!whole) rows.push_back({Mark::kUnknown, "unknown"});
  return rows;
}

void draw_swatch(Canvas& canvas, Mark mark, double x, double y, double size, double pen) {
  const canvas::Point middle{x + size / 2, y + size / 2};
  if (mark == Mark::kStart) draw_start_mark(canvas, middle, 0.42 * size, pen);
  if (mark == Mark::kGoal) draw_goal_mark(canvas, middle, 0.42 * size, pen);
  if (mark == Mark::kPath) draw_path_mark(canvas, middle, 0.3 * size, pen);
  if (mark == Mark::kSafe) draw_safe_line(canvas, {x, middle.y}, {x + size, middle.y}, 0.14 * size);
  if (mark != Mark::kUnknown) return;
  canvas.rectangle(x, y, size, size, kHatchGround);
  canvas.hatch(x, y, size, size, kHatchInk, size / 4, pen);
  canvas.outline(x, y, size, size, kQuiet, pen);
}

/// Where values lie beyond the scale the bar ends in a point.
struct Clipping {
  bool below = false;
  bool above = false;
};
Clipping clipping_of(const learning::Field& field, const plot::Scale& scale) {
  return {field.low() < scale.low, field.high() > scale.high};
}

void draw_points(Canvas& canvas, const plot::Colouring& colouring, const Clipping& clipping, const KeyPlace& bar) {
  const double width = kBarWidth * bar.look.unit;
  const double tall = kPoint * bar.look.unit;
  const double bottom = bar.y + bar.height;
  const std::vector<canvas::Point> up{{bar.x, bar.y}, {bar.x + width / 2, bar.y - tall}, {bar.x + width, bar.y}};
  const std::vector<canvas::Point> down{{bar.x, bottom}, {bar.x + width / 2, bottom + tall}, {bar.x + width, bottom}};
  if (clipping.above) {
    canvas.polygon(up, colouring.colour_at(1.0));
    canvas.polyline(up, bar.look.ink, bar.look.pen_px);
  }
  if (clipping.below) {
    canvas.polygon(down, colouring.colour_at(0.0));
    canvas.polyline(down, bar.look.ink, bar.look.pen_px);
  }
}

void draw_bar(Canvas& canvas, const plot::Colouring& colouring, const Clipping& clipping, const KeyPlace& room) {
  KeyPlace bar = room;
  const double point = (kPoint + 1.0) * bar.look.unit;
  bar.y += clipping.above ? point : 0.0;
  bar.height -= (clipping.above ? point : 0.0) + (clipping.below ? point : 0.0);
  const double width = kBarWidth * bar.look.unit;
  const double pen = bar.look.pen_px;
  const int steps = std::max(2, static_cast<int>(bar.height / pen));
  for (int i = 0; i < steps; ++i) {
    const double top = bar.y + bar.height * i / steps;
    canvas.rectangle(bar.x, top, width, bar.height / steps + (i + 1 < steps ? 0.5 * pen : 0.0),
                     colouring.colour_at(1.0 - (i + 0.5) / steps));
  }
  canvas.outline(bar.x, bar.y, width, bar.height, bar.look.ink, pen);
  draw_points(canvas, colouring, clipping, bar);
  const BarTicks ticks = bar_ticks(colouring.scale, tick_count(bar.height, bar.look));
  const TextStyle style = label_style(bar.look);
  const double unit = bar.look.unit;
  for (std::size_t i = 0; i < ticks.values.size(); ++i) {
    const double y = std::round(bar.y + bar.height * (1.0 - colouring.scale.position(ticks.values[i])) - 0.5) + 0.5;
    canvas.line({bar.x + width, y}, {bar.x + width + kTickLength * unit, y}, bar.look.ink, pen);
    canvas.text({bar.x + width + (kTickLength + kGap) * unit, y + 0.36 * style.size_px}, ticks.labels[i], style);
  }
}

void draw_classes(Canvas& canvas, const learning::Field& field, const plot::Colouring& colouring,
                  const KeyPlace& place) {
  const TextStyle style = label_style(place.look);
  const double size = kSwatch * place.look.unit;
  for (std::size_t i = 0; i < field.categories.size(); ++i) {
    const double y = place.y + kRow * place.look.unit * static_cast<double>(i);
    canvas.rectangle(place.x, y, size, size, colouring.colour(static_cast<double>(i)));
    canvas.outline(place.x, y, size, size, kQuiet, place.look.pen_px);
    canvas.text({place.x + size + kGap * place.look.unit, y + size / 2 + 0.36 * style.size_px}, field.categories[i],
                style);
  }
}

}  // namespace

void draw_key(Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options,
              const plot::Colouring& colouring, const KeyPlace& place) {
  const std::vector<MarkRow> marks = mark_rows(field, options);
  const double row = kRow * place.look.unit;
  const double marks_height = static_cast<double>(marks.size()) * row;
  double y = place.y + place.height - marks_height + row - kSwatch * place.look.unit;
  if (colouring.categories.empty()) {
    const double head = field.unit.empty() ? 0.0 : row;
    if (head > 0.0) canvas.text({place.x, place.y + 0.6 * row}, field.unit, label_style(place.look));
    KeyPlace bar = place;
    bar.y += head;
    bar.height -= head + marks_height + (marks.empty() ? 0.0 : 0.8 * row);
    draw_bar(canvas, colouring, clipping_of(field, colouring.scale), bar);
  } else {
    draw_classes(canvas, field, colouring, place);
    y = place.y + row * (static_cast<double>(field.categories.size()) + 0.6);
  }
  const TextStyle style = label_style(place.look);
  for (const MarkRow& mark : marks) {
    const double size = kSwatch * place.look.unit;
    draw_swatch(canvas, mark.mark, place.x, y, size, place.look.pen_px);
    canvas.text({place.x + size + kGap * place.look.unit, y + size / 2 + 0.36 * style.size_px}, mark.text, style);
    y += row;
  }
}

double key_width(const Canvas& canvas, const learning::Field& field, const FieldFigureOptions& options,
                 const plot::Colouring& colouring, const KeyLook& look) {
  const TextStyle style = label_style(look);
  double width = field.unit.empty() ? 0.0 : canvas.text_width(field.unit, style);
  const auto beside = [&](double left, std::string_view text) {
    width = std::max(width, left * look.unit + canvas.text_width(text, style));
  };
  for (const MarkRow& mark : mark_rows(field, options)) beside(kSwatch + kGap, mark.text);
  if (colouring.categories.empty()) {
    for (const std::string& label : bar_ticks(colouring.scale, kMostTicks).labels) {
      beside(kBarWidth + kTickLength + kGap, label);
    }
  } else {
    for (const std::string& name : field.categories) beside(kSwatch + kGap, name);
  }
  return std::ceil(width);
}

}  // namespace trocar::figure
